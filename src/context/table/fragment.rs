//! Chapter of the table: per-fragment operations and the framebuffer (OpenGL 1.5, sections 4.1 and 4.2), enables, the
//! attribute stack and occlusion queries (sections 4.1.7, 6.1.14).

macro_rules! fragment_table { ($generate:ident) => { $generate! {
    title "Tests, blending, the framebuffer, enables, attribute stacks and occlusion queries (chapter 4, section 6.1.14)";
    canonical {}
    commands {
        /// Turns a capability on. `INVALID_ENUM` if there is none of this name.
        #[doc = include_str!("examples/enable.md")]
        client glEnable enable(cap: enum);
        /// Turns a capability off. `INVALID_ENUM` if there is none of this name.
        client glDisable disable(cap: enum);
        /// Sets the scissor box (section 4.1.2). `INVALID_VALUE` for a negative size.
        list glScissor scissor(x: i32, y: i32, width: i32, height: i32);
        /// Sets the alpha test (section 4.1.4). `INVALID_ENUM` if `func` is no comparison.
        list glAlphaFunc alpha_func(func: enum, reference: f32);
        /// Sets the stencil test (section 4.1.5). `INVALID_ENUM` if `func` is no comparison.
        list glStencilFunc stencil_func(func: enum, reference: i32, mask: uint);
        /// Sets what the stencil buffer becomes (section 4.1.5). `INVALID_ENUM` for other operations.
        list glStencilOp stencil_op(fail: enum, zfail: enum, zpass: enum);
        /// Sets the stencil test of front faces, points and lines, and of back faces (ATI_separate_stencil).
        /// `INVALID_ENUM` if a function is no comparison.
        list glStencilFuncSeparateATI stencil_func_separate(front: enum, back: enum, reference: i32, mask: uint);
        /// Sets what the stencil buffer becomes for one or both faces of polygons (ATI_separate_stencil). `INVALID_ENUM`
        /// for other faces and operations.
        list glStencilOpSeparateATI stencil_op_separate(face: enum, fail: enum, zfail: enum, zpass: enum);
        /// Sets the depth comparison (section 4.1.6). `INVALID_ENUM` if `func` is no comparison.
        #[doc = include_str!("examples/depth_func.md")]
        list glDepthFunc depth_func(func: enum);
        /// Sets the factors of blending (section 4.1.8). `INVALID_ENUM` for other factors.
        #[doc = include_str!("examples/blend_func.md")]
        list glBlendFunc blend_func(sfactor: enum, dfactor: enum);
        /// Sets the factors of blending for colour and alpha (section 4.1.8). `INVALID_ENUM` for other factors.
        list glBlendFuncSeparate | glBlendFuncSeparateEXT | glBlendFuncSeparateINGR blend_func_separate(
            sfactor_rgb: enum, dfactor_rgb: enum, sfactor_alpha: enum, dfactor_alpha: enum);
        /// Sets the equation of blending (section 4.1.8). `INVALID_ENUM` for other equations.
        list glBlendEquation | glBlendEquationEXT blend_equation(mode: enum);
        /// Sets the blend equations of RGB and alpha (EXT_blend_equation_separate). `INVALID_ENUM` for other equations.
        list glBlendEquationSeparateEXT blend_equation_separate(mode_rgb: enum, mode_alpha: enum);
        /// Sets the constant colour of blending (section 4.1.8); it is clamped to [0, 1].
        list glBlendColor | glBlendColorEXT blend_color(red: f32, green: f32, blue: f32, alpha: f32);
        /// Sets the logical operation (section 4.1.10). `INVALID_ENUM` for other operations.
        list glLogicOp logic_op(opcode: enum);
        /// Selects the colour buffers that are drawn to (section 4.2.1).
        list glDrawBuffer draw_buffer(mode: enum);
        /// Sets which bits of a colour index are written (section 4.2.2).
        list glIndexMask index_mask(mask: uint);
        /// Sets which colour components are written (section 4.2.2).
        list glColorMask color_mask(red: bool, green: bool, blue: bool, alpha: bool);
        /// Sets whether depth is written (section 4.2.2).
        list glDepthMask depth_mask(flag: bool);
        /// Sets which stencil bits are written (section 4.2.2).
        list glStencilMask stencil_mask(mask: uint);
        /// Clears buffers to their clear values (section 4.2.3). `INVALID_VALUE` for other bits.
        #[doc = include_str!("examples/clear.md")]
        list glClear clear(mask: bits);
        /// Sets the clear colour (section 4.2.3); it is clamped to [0, 1].
        list glClearColor clear_color(red: f32, green: f32, blue: f32, alpha: f32);
        /// Sets the clear value of a colour index buffer (section 4.2.3).
        list glClearIndex clear_index(index: f32);
        /// Sets the clear value of the depth buffer (section 4.2.3); it is clamped to [0, 1].
        list glClearDepth clear_depth(depth: f64);
        /// Sets the clear value of the stencil buffer (section 4.2.3).
        list glClearStencil clear_stencil(s: i32);
        /// Sets the clear value of the accumulation buffer (section 4.2.3); it is clamped to [-1, 1].
        list glClearAccum clear_accum(red: f32, green: f32, blue: f32, alpha: f32);
        /// Works on the accumulation buffer (section 4.2.4). `INVALID_ENUM` for other operations.
        list glAccum accum(op: enum, value: f32);
        /// Saves groups of state on the attribute stack (section 6.1.14). `STACK_OVERFLOW` on a full stack.
        list glPushAttrib push_attrib(mask: bits);
        /// Restores the groups of the last PushAttrib (section 6.1.14). `STACK_UNDERFLOW` on an empty stack.
        list glPopAttrib pop_attrib();
        /// Starts to count samples that pass the depth test (section 4.1.7).
        list glBeginQuery | glBeginQueryARB begin_query(target: enum, id: uint);
        /// Ends the count of samples (section 4.1.7).
        list glEndQuery | glEndQueryARB end_query(target: enum);
    }
    forms {}
    context {}
    now {
        /// Makes names of queries that are not in use (section 4.1.7).
        now glGenQueries | glGenQueriesARB gen_queries(n: i32, ids: (out u32: count(n)));
        /// Deletes queries; names that do not exist and 0 are ignored (section 4.1.7).
        now glDeleteQueries | glDeleteQueriesARB delete_queries(n: i32, ids: (slice u32: count(n)));
        /// Whether a name is that of a query object (section 6.1.12).
        now glIsQuery | glIsQueryARB is_query(id: uint) -> bool;
    }
    queries {
        family "The query that is active, or how many bits its counter has (section 6.1.12)." {
            glGetQueryiv | glGetQueryivARB get_queryiv(target: enum, pname: enum) -> i32 => get_query(target, pname);
        }
        family "The result of a query, or whether it is there (section 6.1.12)." {
            glGetQueryObjectiv | glGetQueryObjectivARB get_query_objectiv(id: uint, pname: enum) -> i32
                => get_query_object(id, pname);
            glGetQueryObjectuiv | glGetQueryObjectuivARB get_query_objectuiv(id: uint, pname: enum) -> u32
                => get_query_object(id, pname);
        }
    }
    answers {
        get_query(target: enum, pname: enum);
        get_query_object(id: uint, pname: enum);
    }
    manual {}
} } }

pub(crate) use fragment_table;
