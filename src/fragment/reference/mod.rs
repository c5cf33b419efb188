//! The reference path (OpenGL 1.5, sections 3.8 to 3.10 and chapter 4): stages over batches of 64 fragments, in the
//! order of the specification. Every program has it; spans of large primitives may take a shorter way.

pub mod alpha;
pub mod blend;
pub mod depth;
pub mod early_depth;
pub mod env_pack;
pub mod float_store;
pub mod fog;
pub mod interpolate;
pub mod lanes;
pub mod logic_op;
pub mod pack;
pub mod pixel_rect;
pub mod places;
pub mod stencil;
pub mod texcoord;
