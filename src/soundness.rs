//! What safe code must not be able to do: each program below would reach undefined behaviour, and is refused by the
//! compiler. They are tests of the documentation, so that a room that becomes public, or a level that can be made of
//! nothing, is noticed.
//!
//! A level that the processor lacks cannot be named:
//! ```compile_fail,E0599
//! #![forbid(unsafe_code)]
//! let config = fixedgl::Config::default().with_level(fixedgl::SimdLevel::Avx512);
//! ```
//! nor made from a number or from its inside:
//! ```compile_fail,E0423
//! #![forbid(unsafe_code)]
//! let level = fixedgl::SimdLevel(2);
//! ```
//! The rooms with stages, plans and batches cannot be reached:
//! ```compile_fail,E0603
//! #![forbid(unsafe_code)]
//! use fixedgl::simd::Step;
//! ```
//! ```compile_fail,E0603
//! #![forbid(unsafe_code)]
//! let plan = fixedgl::vertex::plan::VertexPlan::new(fixedgl::SimdLevel::detect());
//! ```
//! ```compile_fail,E0603
//! #![forbid(unsafe_code)]
//! use fixedgl::texture::env::EnvPlan;
//! ```
//! ```compile_fail,E0603
//! #![forbid(unsafe_code)]
//! use fixedgl::texture::mipmap::levels;
//! ```
//! ```compile_fail,E0603
//! #![forbid(unsafe_code)]
//! use fixedgl::framebuffer::UserMemory;
//! ```
//! An address of a C program's memory is made by an unsafe function only:
//! ```compile_fail,E0133
//! #![forbid(unsafe_code)]
//! let array = fixedgl::args::ArrayData::Client(fixedgl::args::ClientAddress::new(16));
//! ```
//! ```compile_fail,E0423
//! #![forbid(unsafe_code)]
//! let address = fixedgl::args::ClientAddress(16);
//! ```
//! and what a draw reads of it is the draw's affair alone:
//! ```compile_fail,E0624
//! #![forbid(unsafe_code)]
//! fn beyond(array: &fixedgl::args::ArrayData) -> Option<&[u8]> {
//!     array.bytes(1 << 40, 1 << 20)
//! }
//! ```
//! This one compiles, so the ones above fail for the reason that is named:
//! ```
//! #![forbid(unsafe_code)]
//! use fixedgl::{Config, SimdLevel, args::{ArrayData, IntoArray}};
//! for level in SimdLevel::available() {
//!     let cx = fixedgl::Context::with_config(4, 4, Config::default().with_level(level));
//!     assert_eq!(cx.config().level, level);
//! }
//! let lowered = SimdLevel::from_name("avx512").expect("a name");
//! assert!(lowered <= SimdLevel::detect());
//! let array: ArrayData = (&[0.0f32; 3]).into_array();
//! assert!(matches!(array, ArrayData::Values(_)));
//! ```
