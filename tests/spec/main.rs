//! The tests of the specification: one module a chapter, each from the initial state to a small picture, with the f64
//! oracle of `tests/oracle` as the judge of numbers. The figures that are measured are printed with `--nocapture`.

mod glu;
#[path = "../oracle/mod.rs"]
mod oracle;
mod pixels;
mod texture_images;
mod vertex_arrays;
mod vertices;
