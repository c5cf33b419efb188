//! Chapter of the table: display lists, selection, feedback and the end of the pipeline (OpenGL 1.5, sections 5.2 to
//! 5.5). The commands that make and call lists are the context's own; the rest of them belongs to the engine.

macro_rules! lists_table {
    ($generate:ident) => {
        $generate! {
            title "Display lists, selection, feedback, flush and finish (sections 5.2 to 5.5)";
            canonical {}
            commands {
                /// Sets what CallLists adds to every name (section 5.4).
                list glListBase list_base(base: uint);
                /// Empties the name stack (section 5.2).
                list glInitNames init_names();
                /// Replaces the top of the name stack (section 5.2). `INVALID_OPERATION` if it is empty.
                list glLoadName load_name(name: uint);
                /// Pushes a name (section 5.2). `STACK_OVERFLOW` on a full stack.
                list glPushName push_name(name: uint);
                /// Pops a name (section 5.2). `STACK_UNDERFLOW` on an empty stack.
                list glPopName pop_name();
                /// Writes a number into the feedback buffer (section 5.3).
                list glPassThrough pass_through(token: f32);
            }
            forms {}
            context {
                /// Opens a display list (section 5.4): `COMPILE` only records, `COMPILE_AND_EXECUTE` also carries out.
                /// `INVALID_VALUE` for the name 0, `INVALID_ENUM` for other modes, `INVALID_OPERATION` if one is open.
                #[doc = include_str!("examples/new_list.md")]
                now glNewList new_list(list: uint, mode: enum);
                /// Closes the open list, which now takes the place of the one of its name (section 5.4). `INVALID_OPERATION` if
                /// none is open.
                now glEndList end_list();
                /// Carries out a list (section 5.4), also between Begin and End; a name without a list does nothing.
                begin glCallList call_list(list: uint);
                /// Carries out several lists (section 5.4). `INVALID_ENUM` for other types than the integers, `FLOAT` and
                /// `2_BYTES` to `4_BYTES`, `INVALID_VALUE` for a negative count.
                begin glCallLists call_lists(n: i32, type_: enum,
                    lists: (bytes crate::context::param_counts::list_names(n, type_)));
                /// Reserves a run of names of lists and returns the first one, or 0 (section 5.4). `INVALID_VALUE` for a negative
                /// count.
                now glGenLists gen_lists(range: i32) -> uint;
                /// Deletes a run of lists (section 5.4). `INVALID_VALUE` for a negative count.
                now glDeleteLists delete_lists(list: uint, range: i32);
                /// Whether a name is that of a list (section 6.1.13).
                now glIsList is_list(list: uint) -> bool;
            }
            now {
                /// Makes sure that what has been issued will be drawn in finite time (section 5.5).
                now glFlush flush();
                /// Returns when all that has been issued is in the framebuffer (section 5.5).
                now glFinish finish();
            }
            queries {}
            answers {}
            manual {
                now glRenderMode;
                now glFeedbackBuffer;
                now glSelectBuffer;
            }
        }
    };
}

pub(crate) use lists_table;
