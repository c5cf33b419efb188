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
//! # Three doors, one engine
//! A [`Context`] is one owned value that can be sent to another thread. Its methods are the commands with GL's names in
//! snake case ([`Context::tex_image_2d`]). [`c`] has the same commands under their C names on a current context of the
//! thread, for programs that are ported line by line. With the cargo feature `capi` the crate builds a shared library with
//! `gl*`, `glu*` and `OSMesa*` symbols, so that C programs run unchanged. All three are made from one table of commands.
//!
//! A command that is wrong changes nothing and records an error, as in GL: [`Context::get_error`] reads it,
//! [`Context::check`] gives it as a `Result` with a sentence, and a callback ([`Context::set_debug_callback`]) gets the
//! sentence with the file and line of the call. It also hears why a texture is incomplete.
//!
//! # The map of the house
//! State is data; a plan is a list of stages; a batch is 64 of something. The rooms, from the top; each uses only what
//! stands below it:
//!
//! | room | what it does |
//! |---|---|
//! | `capi` | the C ABI (feature `capi`) |
//! | [`c`] | C's names as safe functions |
//! | [`teach`] | explains the plan of a state, counts what was done; used by nothing |
//! | `image_io`, `obj` | textures and pictures from image files, meshes from OBJ files (features `image`, `tobj`) |
//! | [`glu`] | mipmaps, image scaling, projections, quadrics |
//! | [`context`] | the table of commands, display lists, queries; the engine that ties the rest together |
//! | [`vertex`] | batches of vertices: transformation, lighting, texture generation, clipping, assembly |
//! | [`raster`] | setup, coverage of triangles, lines and points, the deferred scene, bands and threads |
//! | [`fragment`] | batches of fragments: interpolation, fog, tests, blending, the store |
//! | [`texture`] | images, completeness, addressing, level of detail, filters, environments |
//! | [`framebuffer`] | colour, depth, stencil and accumulation buffers |
//! | [`pixels`] | formats and types, unpack, pack, pixel transfer |
//! | [`state`] | a struct for each group of the state tables |
//! | [`simd`] | stages, plans, instruction sets |
//! | [`num`], [`enums`], [`error`], [`limits`] | numbers that are the same everywhere, GL's constants, errors, limits |
//!
//! The pages of `spec-notes/` tell how each chapter of the specification is done; begin with
//! `spec-notes/how-a-vertex-becomes-a-pixel.md`.

pub mod c;
#[cfg(feature = "capi")]
pub mod capi;
pub mod context;
pub mod enums;
pub mod error;
pub mod fragment;
pub mod framebuffer;
pub mod glu;
#[cfg(feature = "image")]
pub mod image_io;
pub mod limits;
pub mod num;
#[cfg(feature = "tobj")]
pub mod obj;
pub mod pixels;
pub mod raster;
pub mod simd;
pub mod state;
pub mod teach;
pub mod texture;
pub mod vertex;

pub use context::{Context, Error};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
