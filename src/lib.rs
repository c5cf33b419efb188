//! Fixed-function OpenGL (1.0 to 1.5 and its classic extensions) in software: no GPU, no driver, no JIT. The library keeps
//! GL's state machine, transforms, lights, textures and rasterises as the specification says, and gives the same bytes on
//! every machine, at every instruction set and with any number of threads.
//!
//! ```
//! use fixedgl::c::*;
//!
//! make_current(fixedgl::Context::new(64, 64));
//! glClearColor(0.0, 0.0, 0.5, 1.0);
//! glClear(GL_COLOR_BUFFER_BIT);
//! glBegin(GL_TRIANGLES);
//! glColor3f(1.0, 1.0, 0.0);
//! glVertex2f(-0.5, -0.5);
//! glVertex2f(0.5, -0.5);
//! glVertex2f(0.0, 0.5);
//! glEnd();
//! let mut context = take_current().expect("the context from above");
//! let pixels = context.pixels(); // RGBA, rows from the bottom up
//! assert_eq!(&pixels[4 * (32 * 64 + 32)..][..4], &[255, 255, 0, 255]);
//! ```
//!
//! # Three interfaces, one engine
//! A [`Context`] is one owned value that can be sent to another thread. Its methods are the commands with GL's names in
//! snake case ([`Context::tex_image_2d`]). [`c`] has the same commands under their C names on a current context of the
//! thread, for programs that are ported line by line. With the cargo feature `capi` the crate builds a shared library with
//! `gl*`, `glu*` and `OSMesa*` symbols, so that C programs run unchanged. All three are made from one table of commands.
//!
//! A command that is wrong changes nothing and records an error, as in GL: [`Context::get_error`] reads it,
//! [`Context::check`] gives it as a `Result` with a sentence, and a callback ([`Context::set_debug_callback`]) gets the
//! sentence with the file and line of the call. It also hears why a texture is incomplete.
//!
//! # What is where
//! - [`Context`], [`c`]: the commands as methods and under their C names; `capi`: the exported symbols (feature `capi`)
//! - [`args`], [`enums`]: types of arguments, GL's constants
//! - [`glu`]: mipmaps, image scaling, projections, quadrics
//! - [`explain`]: which stages and which span kernel the present state needs and why, counters of what was done
//! - [`math`]: sine and cosine that are the same everywhere
//! - `image_io`, `obj`: textures and meshes from files (features `image` and `tobj`)
//!
//! All else is private. The repository's `ARCHITECTURE.md` is a map of it on one page: a call passes `context`, `vertex`,
//! `raster` and `fragment` (with `texture`), and ends in `framebuffer`.
//!
//! The pages of [`spec_notes`] tell how each chapter of the specification is done; begin with
//! [how a vertex becomes a pixel](spec_notes::how_a_vertex_becomes_a_pixel).

#![cfg_attr(docsrs, feature(doc_cfg))]

pub mod c;
#[cfg(feature = "capi")]
pub mod capi;
mod context;
pub mod enums;
mod error;
pub mod explain;
mod fragment;
mod framebuffer;
pub mod glu;
#[cfg(feature = "image")]
pub mod image_io;
mod limits;
mod num;
#[cfg(feature = "tobj")]
pub mod obj;
mod pixels;
mod raster;
mod simd;
#[cfg(doc)]
pub mod spec_notes;
mod state;
mod texture;
mod vertex;

pub use context::{Call, Config, Context, DebugCallback, DebugMessage, Error, NULL, TraceCallback};
pub use error::FileError;
pub use framebuffer::FramebufferFormat;
pub use simd::SimdLevel;

pub mod args {
    //! What the commands of [`Context`](crate::Context) take: conversions of numbers that C does by itself
    //! ([`IntoGl`]), memory that is read or written ([`InSlice`], [`OutSlice`], [`Pixels`]), and
    //! vertex arrays and indices, which are memory or an offset into the bound buffer object ([`ArrayData`],
    //! [`Indices`]). Programs seldom name them: arrays, slices, vectors, offsets and [`NULL`](crate::NULL) convert by
    //! themselves.

    pub use crate::context::{
        ArrayData, ClientAddress, Element, InSlice, IndexLists, Indices, IntoArray, IntoGl, IntoIndices, IntoPixels,
        IntoPixelsMut, Null, OutSlice, Pixels, PixelsMut,
    };
}

pub mod math {
    //! Sine and cosine with the same bits on every machine. `f64::sin` of the standard library is the platform's and may
    //! differ in the last bit; a program whose pictures must be the same bytes everywhere computes its vertices with
    //! these.

    pub use crate::num::{cos, sin, sin_cos, tan};
}

// The oracle of the tests names the crate from outside, in unit tests as well.
#[cfg(test)]
extern crate self as fixedgl;

#[cfg(doctest)]
mod soundness;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
