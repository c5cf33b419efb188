//! The commands that the scenes use, as one table, and the trait [`Gl`] that is made from it: a scene speaks to any
//! implementation of OpenGL through it. Here is the implementation by this crate's [`Context`]; `peer.rs` has the one by
//! a shared library. What GL does with pointers has rows of its own at the end of the trait.

use fixedgl::Context;
use fixedgl::FramebufferFormat;
use fixedgl::SimdLevel;
use fixedgl::enums::*;
use fixedgl::{Config, args::Element};

/// Hands the table of commands without pointers to a macro.
macro_rules! commands {
    ($make:ident) => {
        $make! {
            glEnable enable(cap: u32);
            glDisable disable(cap: u32);
            glHint hint(target: u32, mode: u32);
            glViewport viewport(x: i32, y: i32, width: i32, height: i32);
            glDepthRange depth_range(near: f64, far: f64);
            glMatrixMode matrix_mode(mode: u32);
            glLoadIdentity load_identity();
            glActiveTexture active_texture(unit: u32);
            glBindTexture bind_texture(target: u32, name: u32);
            glTexParameteri tex_parameteri(target: u32, pname: u32, value: i32);
            glTexParameterf tex_parameterf(target: u32, pname: u32, value: f32);
            glTexEnvi tex_envi(target: u32, pname: u32, value: i32);
            glTexEnvf tex_envf(target: u32, pname: u32, value: f32);
            glTexGeni tex_geni(coord: u32, pname: u32, value: i32);
            glFogi fogi(pname: u32, value: i32);
            glFogf fogf(pname: u32, value: f32);
            glBlendFunc blend_func(source: u32, destination: u32);
            glDepthFunc depth_func(func: u32);
            glCullFace cull_face(face: u32);
            glPixelStorei pixel_storei(pname: u32, value: i32);
            glClearColor clear_color(red: f32, green: f32, blue: f32, alpha: f32);
            glClear clear(mask: u32);
            glAccum accum(op: u32, value: f32);
            glFinish finish();
            glNewList new_list(list: u32, mode: u32);
            glEndList end_list();
            glCallList call_list(list: u32);
            glBegin begin(mode: u32);
            glEnd end();
            glColor4f color4f(red: f32, green: f32, blue: f32, alpha: f32);
            glNormal3f normal3f(x: f32, y: f32, z: f32);
            glFogCoordf fog_coordf(coordinate: f32);
            glMultiTexCoord4f multi_tex_coord4f(unit: u32, s: f32, t: f32, r: f32, q: f32);
            glVertex4f vertex4f(x: f32, y: f32, z: f32, w: f32);
        }
    };
}
pub(crate) use commands;

macro_rules! make_trait {
    ($($c:ident $name:ident($($arg:ident: $t:ty),*);)*) => {
        /// An OpenGL context with a framebuffer of a fixed size.
        pub trait Gl {
            $(#[doc = stringify!($c)] fn $name(&mut self, $($arg: $t),*);)*
            /// glLoadMatrixd
            fn load_matrixd(&mut self, matrix: &[f64; 16]);
            /// glTexParameterfv
            fn tex_parameterfv(&mut self, target: u32, pname: u32, values: &[f32; 4]);
            /// glTexEnvfv
            fn tex_envfv(&mut self, target: u32, pname: u32, values: &[f32; 4]);
            /// glTexGenfv
            fn tex_genfv(&mut self, coord: u32, pname: u32, values: &[f32; 4]);
            /// glFogfv
            fn fogfv(&mut self, pname: u32, values: &[f32; 4]);
            /// glTexImage2D of RGBA bytes
            fn tex_image_2d(&mut self, level: i32, internal_format: i32, size: [i32; 2], texels: &[u8]);
            /// Makes this context the current one, where there is such a thing.
            fn make_current(&mut self);
            /// glGetError
            fn error(&mut self) -> u32;
            /// glReadPixels of the whole picture as bytes, rows from the bottom.
            fn bytes(&mut self) -> Vec<[u8; 4]>;
            /// glReadPixels as floats.
            fn floats(&mut self) -> Vec<[f32; 4]>;
            /// glReadPixels of depth as 32-bit integers.
            fn depths(&mut self) -> Vec<u32>;
        }
    };
}
commands!(make_trait);

/// Where contexts come from.
pub trait Library {
    /// The name in the tables.
    fn name(&self) -> &str;
    /// A context with RGBA of 8 bits or of floats, 24 bits of depth and an accumulation buffer.
    fn open(&self, size: [u32; 2], float: bool) -> Box<dyn Gl>;
}

/// This crate.
pub struct Ours {
    /// The instruction set.
    pub level: SimdLevel,
}

impl Ours {
    /// A context of this crate itself, for what the trait does not have.
    pub fn context(&self, size: [u32; 2], float: bool) -> Context {
        let mut format = FramebufferFormat::default();
        format.color_bits = if float { [32; 4] } else { [8; 4] };
        format.float = float;
        let config = Config::default().with_level(self.level).with_threads(1).with_format(format);
        Context::with_config(size[0], size[1], config)
    }
}

impl Library for Ours {
    fn name(&self) -> &'static str {
        "fixedgl"
    }

    fn open(&self, size: [u32; 2], float: bool) -> Box<dyn Gl> {
        Box::new(self.context(size, float))
    }
}

/// The numbers of a picture of a context, `channels` for each pixel.
fn read<T: Element + Default>(cx: &mut Context, format: u32, type_: u32, channels: usize) -> Vec<T> {
    let (width, height) = cx.size();
    let mut numbers = vec![T::default(); width as usize * height as usize * channels];
    cx.read_pixels(0, 0, width as i32, height as i32, format, type_, &mut numbers);
    numbers
}

macro_rules! make_ours {
    ($($c:ident $name:ident($($arg:ident: $t:ty),*);)*) => {
        impl Gl for Context {
            $(fn $name(&mut self, $($arg: $t),*) { Context::$name(self, $($arg),*); })*

            fn load_matrixd(&mut self, matrix: &[f64; 16]) {
                Context::load_matrixd(self, matrix);
            }
            fn tex_parameterfv(&mut self, target: u32, pname: u32, values: &[f32; 4]) {
                Context::tex_parameterfv(self, target, pname, values);
            }
            fn tex_envfv(&mut self, target: u32, pname: u32, values: &[f32; 4]) {
                Context::tex_envfv(self, target, pname, values);
            }
            fn tex_genfv(&mut self, coord: u32, pname: u32, values: &[f32; 4]) {
                Context::tex_genfv(self, coord, pname, values);
            }
            fn fogfv(&mut self, pname: u32, values: &[f32; 4]) {
                Context::fogfv(self, pname, values);
            }
            fn tex_image_2d(&mut self, level: i32, internal_format: i32, [w, h]: [i32; 2], texels: &[u8]) {
                let (target, format, type_) = (GL_TEXTURE_2D, GL_RGBA, GL_UNSIGNED_BYTE);
                Context::tex_image_2d(self, target, level, internal_format, w, h, 0, format, type_, texels);
            }
            fn make_current(&mut self) {}
            fn error(&mut self) -> u32 {
                self.get_error()
            }
            fn bytes(&mut self) -> Vec<[u8; 4]> {
                read(self, GL_RGBA, GL_UNSIGNED_BYTE, 4).as_chunks().0.to_vec()
            }
            fn floats(&mut self) -> Vec<[f32; 4]> {
                read(self, GL_RGBA, GL_FLOAT, 4).as_chunks().0.to_vec()
            }
            fn depths(&mut self) -> Vec<u32> {
                read(self, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1)
            }
        }
    };
}
commands!(make_ours);
