//! The tests of the specification: one module a chapter, each from the initial state to a small picture, with the f64
//! oracle of `tests/oracle` as the judge of numbers. The figures that are measured are printed with `--nocapture`.

#[path = "../oracle/mod.rs"]
mod oracle;
#[path = "../support/mod.rs"]
mod support;

mod absurd;
mod anisotropy;
mod arrays;
mod attrib;
mod blend;
mod clip;
mod combine;
mod cube;
mod env;
mod errors;
mod everything;
mod filter;
mod fog;
mod glu;
mod glu_numbers;
mod lighting;
mod lines;
mod lists;
mod lod;
mod pixels;
mod rasterisation;
mod shadow;
mod texgen;
mod texture_images;
mod texture_objects;
mod transform;
mod vertex_arrays;
mod vertices;
mod wrap;
