//! Any OSMesa library as an implementation of [`Gl`]: its functions are looked up by name in the shared library and called
//! through pointers. All unsafe code of the report is here. It rests on three facts: the symbols have the signatures of
//! GL 1.5 and OSMesa, which the table and the lines below write down; the library stays loaded as long as a context of
//! it lives; and every context is made current, on the one thread that uses peers, before it is called.

#![expect(unsafe_code, reason = "functions of a shared library are called through pointers")]

use super::gl::{Gl, Library, commands};
use fixedgl::args::Element;
use fixedgl::enums::*;
use std::ffi::{c_int, c_void};
use std::ptr::null_mut;
use std::rc::Rc;

type OsMesaContext = *mut c_void;

macro_rules! make_functions {
    ($($c:ident $name:ident($($arg:ident: $t:ty),*);)*) => {
        /// The functions that are called.
        struct Functions {
            $($name: unsafe extern "C" fn($($t),*),)*
            load_matrixd: unsafe extern "C" fn(*const f64),
            tex_parameterfv: unsafe extern "C" fn(u32, u32, *const f32),
            tex_envfv: unsafe extern "C" fn(u32, u32, *const f32),
            tex_genfv: unsafe extern "C" fn(u32, u32, *const f32),
            fogfv: unsafe extern "C" fn(u32, *const f32),
            tex_image_2d: unsafe extern "C" fn(u32, i32, i32, i32, i32, i32, u32, u32, *const c_void),
            read_pixels: unsafe extern "C" fn(i32, i32, i32, i32, u32, u32, *mut c_void),
            get_error: unsafe extern "C" fn() -> u32,
            create: unsafe extern "C" fn(u32, c_int, c_int, c_int, OsMesaContext) -> OsMesaContext,
            make_current: unsafe extern "C" fn(OsMesaContext, *mut c_void, u32, c_int, c_int) -> u8,
            destroy: unsafe extern "C" fn(OsMesaContext),
            /// Keeps the functions in memory.
            _library: libloading::Library,
        }

        impl Functions {
            fn load(path: &str) -> Result<Functions, String> {
                // SAFETY: the user names the library, so running its initialisers is what the user asks for.
                let library = unsafe { libloading::Library::new(path) }.map_err(|e| format!("{path}: {e}"))?;
                Ok(Functions {
                    $($name: find(&library, concat!(stringify!($c), "\0"))?,)*
                    load_matrixd: find(&library, "glLoadMatrixd\0")?,
                    tex_parameterfv: find(&library, "glTexParameterfv\0")?,
                    tex_envfv: find(&library, "glTexEnvfv\0")?,
                    tex_genfv: find(&library, "glTexGenfv\0")?,
                    fogfv: find(&library, "glFogfv\0")?,
                    tex_image_2d: find(&library, "glTexImage2D\0")?,
                    read_pixels: find(&library, "glReadPixels\0")?,
                    get_error: find(&library, "glGetError\0")?,
                    create: find(&library, "OSMesaCreateContextExt\0")?,
                    make_current: find(&library, "OSMesaMakeCurrent\0")?,
                    destroy: find(&library, "OSMesaDestroyContext\0")?,
                    _library: library,
                })
            }
        }

        impl Gl for PeerContext {
            $(fn $name(&mut self, $($arg: $t),*) {
                // SAFETY: scalars only; the context is current (see the top of the file).
                unsafe { (self.functions.$name)($($arg),*) };
            })*

            fn load_matrixd(&mut self, matrix: &[f64; 16]) {
                // SAFETY: the command reads 16 numbers.
                unsafe { (self.functions.load_matrixd)(matrix.as_ptr()) };
            }
            fn tex_parameterfv(&mut self, target: u32, pname: u32, values: &[f32; 4]) {
                // SAFETY: the command reads at most four numbers; so do the three that follow.
                unsafe { (self.functions.tex_parameterfv)(target, pname, values.as_ptr()) };
            }
            fn tex_envfv(&mut self, target: u32, pname: u32, values: &[f32; 4]) {
                // SAFETY: as above.
                unsafe { (self.functions.tex_envfv)(target, pname, values.as_ptr()) };
            }
            fn tex_genfv(&mut self, coord: u32, pname: u32, values: &[f32; 4]) {
                // SAFETY: as above.
                unsafe { (self.functions.tex_genfv)(coord, pname, values.as_ptr()) };
            }
            fn fogfv(&mut self, pname: u32, values: &[f32; 4]) {
                // SAFETY: as above.
                unsafe { (self.functions.fogfv)(pname, values.as_ptr()) };
            }
            fn tex_image_2d(&mut self, level: i32, internal_format: i32, [w, h]: [i32; 2], texels: &[u8]) {
                assert!(texels.len() >= 4 * w.max(0) as usize * h.max(0) as usize, "too few texels");
                let (target, format, type_) = (GL_TEXTURE_2D, GL_RGBA, GL_UNSIGNED_BYTE);
                let data = texels.as_ptr().cast();
                // SAFETY: w h texels of four bytes are read (no pixel-store state is set but an alignment of 1).
                unsafe { (self.functions.tex_image_2d)(target, level, internal_format, w, h, 0, format, type_, data) };
            }
            fn make_current(&mut self) {
                self.bind();
            }
            fn error(&mut self) -> u32 {
                // SAFETY: no arguments.
                unsafe { (self.functions.get_error)() }
            }
            fn bytes(&mut self) -> Vec<[u8; 4]> {
                self.read(GL_RGBA, GL_UNSIGNED_BYTE, 4).as_chunks().0.to_vec()
            }
            fn floats(&mut self) -> Vec<[f32; 4]> {
                self.read(GL_RGBA, GL_FLOAT, 4).as_chunks().0.to_vec()
            }
            fn depths(&mut self) -> Vec<u32> {
                self.read(GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1)
            }
        }
    };
}
commands!(make_functions);

/// A function of the library; `T` must be the type of the function of that name, which ends in a zero.
fn find<T: Copy>(library: &libloading::Library, name: &str) -> Result<T, String> {
    // SAFETY: the fields of `Functions`, the only callers, have the types that GL 1.5 and OSMesa give these names.
    let symbol = unsafe { library.get::<T>(name.as_bytes()) };
    symbol.map(|s| *s).map_err(|e| format!("{}: {e}", name.trim_end_matches('\0')))
}

/// A shared library with the entry points of OSMesa.
pub struct Peer {
    name: String,
    functions: Rc<Functions>,
}

impl Peer {
    /// Loads the library.
    pub fn load(path: &str) -> Result<Peer, String> {
        // A peer of the llvmpipe family draws in the calling thread then, so that its time can be compared.
        // SAFETY: the report starts no thread before the peer is loaded.
        unsafe { std::env::set_var("LP_NUM_THREADS", "0") };
        let name = path.rsplit('/').next().unwrap_or(path).split(".so").next().unwrap_or(path);
        Ok(Peer { name: name.trim_start_matches("lib").to_string(), functions: Rc::new(Functions::load(path)?) })
    }
}

impl Library for Peer {
    fn name(&self) -> &str {
        &self.name
    }

    fn open(&self, [width, height]: [u32; 2], float: bool) -> Box<dyn Gl> {
        // SAFETY: sizes of buffers and no context to share with.
        let context = unsafe { (self.functions.create)(GL_RGBA, 24, 8, 16, null_mut()) };
        assert!(!context.is_null(), "{} makes no context", self.name);
        let words = if float { 4 } else { 1 } * width as usize * height as usize;
        let size = [width, height];
        let mut context =
            PeerContext { functions: self.functions.clone(), context, memory: vec![0; words], size, float };
        assert!(context.bind(), "{} cannot draw into this memory", self.name);
        Box::new(context)
    }
}

/// A context and the memory that it draws into.
struct PeerContext {
    functions: Rc<Functions>,
    context: OsMesaContext,
    memory: Vec<u32>,
    size: [u32; 2],
    float: bool,
}

impl PeerContext {
    fn bind(&mut self) -> bool {
        let type_ = if self.float { GL_FLOAT } else { GL_UNSIGNED_BYTE };
        let [width, height] = self.size.map(|n| n as c_int);
        let memory = self.memory.as_mut_ptr().cast();
        // SAFETY: the memory holds width * height pixels of this type and lives, in place, as long as the context.
        unsafe { (self.functions.make_current)(self.context, memory, type_, width, height) != 0 }
    }

    /// The numbers of the picture, `channels` for each pixel.
    fn read<T: Element + Default>(&mut self, format: u32, type_: u32, channels: usize) -> Vec<T> {
        let [width, height] = self.size;
        let mut numbers = vec![T::default(); (width * height) as usize * channels];
        let place = numbers.as_mut_ptr().cast();
        // SAFETY: each caller's T is a channel of its type, its format has that many, and there are width * height pixels;
        // an `Element` is a plain number, for which every pattern of bits will do.
        unsafe { (self.functions.read_pixels)(0, 0, width as i32, height as i32, format, type_, place) };
        numbers
    }
}

impl Drop for PeerContext {
    fn drop(&mut self) {
        // SAFETY: the context is released before its memory goes, and nobody uses it afterwards.
        unsafe {
            (self.functions.make_current)(null_mut(), null_mut(), 0, 0, 0);
            (self.functions.destroy)(self.context);
        }
    }
}
