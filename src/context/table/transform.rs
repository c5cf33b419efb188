//! Chapter of the table: coordinate transformations (OpenGL 1.5, sections 2.11 and 2.11.1 to 2.11.4, 2.12 clipping).
//! Matrices travel as sixteen doubles, column by column; transposed forms are turned over at the door.

macro_rules! transform_table { ($generate:ident) => { $generate! {
    title "Coordinate transformation and clipping (sections 2.11, 2.12)";
    canonical {
        list LoadMatrix load_matrix(m: matrix);
        list MultMatrix mult_matrix(m: matrix);
        list Rotate rotate(angle: f64, x: f64, y: f64, z: f64);
        list Scale scale(x: f64, y: f64, z: f64);
        list Translate translate(x: f64, y: f64, z: f64);
        list TexGen tex_gen(coord: enum, pname: enum, params: params);
    }
    commands {
        /// Selects the matrix stack that the matrix commands work on (section 2.11.2): `MODELVIEW`, `PROJECTION`,
        /// `TEXTURE` or `COLOR`, else `INVALID_ENUM`.
        #[doc = include_str!("examples/matrix_mode.md")]
        list glMatrixMode matrix_mode(mode: enum);
        /// Replaces the current matrix by the identity (section 2.11.2).
        list glLoadIdentity load_identity();
        /// Pushes a copy of the current matrix (section 2.11.2). `STACK_OVERFLOW` on a full stack.
        list glPushMatrix push_matrix();
        /// Pops the current matrix (section 2.11.2). `STACK_UNDERFLOW` if it is the only one.
        list glPopMatrix pop_matrix();
        /// Multiplies a perspective matrix (section 2.11.2). `INVALID_VALUE` if `near` or `far` is not positive or two
        /// planes coincide.
        list glFrustum frustum(left: f64, right: f64, bottom: f64, top: f64, near: f64, far: f64);
        /// Multiplies an orthographic matrix (section 2.11.2). `INVALID_VALUE` if two planes coincide.
        list glOrtho ortho(left: f64, right: f64, bottom: f64, top: f64, near: f64, far: f64);
        /// Sets the viewport (section 2.11.1). `INVALID_VALUE` for a negative size.
        list glViewport viewport(x: i32, y: i32, width: i32, height: i32);
        /// Sets how depth in [-1, 1] becomes window depth (section 2.11.1); values are clamped to [0, 1].
        list glDepthRange depth_range(near: f64, far: f64);
        /// Sets a user clip plane, transformed by the inverse of the modelview matrix (section 2.12). `INVALID_ENUM` if
        /// `plane` is not `CLIP_PLANE0` or one of its successors.
        list glClipPlane clip_plane(plane: enum, equation: (upto f64: four()));
        /// Selects the texture unit that texture commands work on (section 2.7). `INVALID_ENUM` for a unit that does not
        /// exist.
        list glActiveTexture | glActiveTextureARB active_texture(texture: enum);
    }
    forms {
        family "Replaces the current matrix (section 2.11.2)." {
            list glLoadMatrixf load_matrixf(m: [f32; 16]) => load_matrix(&matrix(m));
            list glLoadMatrixd load_matrixd(m: [f64; 16]) => load_matrix(m);
        }
        family "Replaces the current matrix by one that is stored row by row (section 2.11.2)." {
            list glLoadTransposeMatrixf | glLoadTransposeMatrixfARB load_transpose_matrixf(m: [f32; 16])
                => load_matrix(&transposed(m));
            list glLoadTransposeMatrixd | glLoadTransposeMatrixdARB load_transpose_matrixd(m: [f64; 16])
                => load_matrix(&transposed(m));
        }
        family "Multiplies the current matrix from the right (section 2.11.2)." {
            list glMultMatrixf mult_matrixf(m: [f32; 16]) => mult_matrix(&matrix(m));
            list glMultMatrixd mult_matrixd(m: [f64; 16]) => mult_matrix(m);
        }
        family "Multiplies the current matrix by one that is stored row by row (section 2.11.2)." {
            list glMultTransposeMatrixf | glMultTransposeMatrixfARB mult_transpose_matrixf(m: [f32; 16])
                => mult_matrix(&transposed(m));
            list glMultTransposeMatrixd | glMultTransposeMatrixdARB mult_transpose_matrixd(m: [f64; 16])
                => mult_matrix(&transposed(m));
        }
        family "Multiplies a rotation by an angle in degrees about an axis (section 2.11.2)." {
            #[doc = include_str!("examples/rotate.md")]
            list glRotatef rotatef(angle: f32, x: f32, y: f32, z: f32)
                => rotate(f64::from(angle), f64::from(x), f64::from(y), f64::from(z));
            list glRotated rotated(angle: f64, x: f64, y: f64, z: f64) => rotate(angle, x, y, z);
        }
        family "Multiplies a scaling (section 2.11.2)." {
            list glScalef scalef(x: f32, y: f32, z: f32) => scale(f64::from(x), f64::from(y), f64::from(z));
            list glScaled scaled(x: f64, y: f64, z: f64) => scale(x, y, z);
        }
        family "Multiplies a translation (section 2.11.2)." {
            list glTranslatef translatef(x: f32, y: f32, z: f32) => translate(f64::from(x), f64::from(y), f64::from(z));
            list glTranslated translated(x: f64, y: f64, z: f64) => translate(x, y, z);
        }
        family "Sets how a texture coordinate is generated (section 2.11.4): mode, object plane or eye plane of `S`, `T`, `R` or `Q`. `INVALID_ENUM` for other names, modes that the coordinate does not have, and planes through a scalar form." {
            #[doc = include_str!("examples/tex_gen.md")]
            list glTexGeni tex_geni(coord: enum, pname: enum, param: i32) => tex_gen(coord, pname, &Params::int(param));
            list glTexGenf tex_genf(coord: enum, pname: enum, param: f32) => tex_gen(coord, pname, &Params::float(param));
            list glTexGend tex_gend(coord: enum, pname: enum, param: f64)
                => tex_gen(coord, pname, &Params::float(param as f32));
            list glTexGeniv tex_geniv(coord: enum, pname: enum, params: (upto i32: tex_gen(pname)))
                => tex_gen(coord, pname, &Params::ints(params));
            list glTexGenfv tex_genfv(coord: enum, pname: enum, params: (upto f32: tex_gen(pname)))
                => tex_gen(coord, pname, &Params::floats(params));
            list glTexGendv tex_gendv(coord: enum, pname: enum, params: (upto f64: tex_gen(pname)))
                => tex_gen(coord, pname, &Params::doubles(params));
        }
    }
    context {}
    now {}
    queries {
        family "What TexGen has set (section 6.1.3)." {
            glGetTexGeniv get_tex_geniv(coord: enum, pname: enum) -> i32 => get_tex_gen(coord, pname);
            glGetTexGenfv get_tex_genfv(coord: enum, pname: enum) -> f32 => get_tex_gen(coord, pname);
            glGetTexGendv get_tex_gendv(coord: enum, pname: enum) -> f64 => get_tex_gen(coord, pname);
        }
        family "The coefficients of a user clip plane in eye coordinates (section 6.1.3)." {
            glGetClipPlane get_clip_plane(plane: enum) -> f64 => get_clip_plane_values(plane);
        }
    }
    answers {
        get_tex_gen(coord: enum, pname: enum);
        get_clip_plane_values(plane: enum);
    }
    manual {}
} } }

pub(crate) use transform_table;
