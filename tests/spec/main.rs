//! The tests of the specification: one module a chapter, each from the initial state to a small picture, with the f64
//! oracle of `tests/oracle` as the judge of numbers. The figures that are measured are printed with `--nocapture`. What
//! needs the oracle as well is in the same program, since each one that is linked takes its time.

#[path = "../support/allocator.rs"]
mod allocator;
#[path = "../support/everywhere.rs"]
mod everywhere;
#[path = "../oracle/mod.rs"]
mod oracle;
#[path = "../support/mod.rs"]
mod support;

#[path = "../stability/mod.rs"]
mod stability;

mod absurd;
mod anisotropy;
mod arrays;
mod attrib;
mod blend;
mod clip;
mod combine;
mod commands;
mod cube;
mod depth;
mod display_lists;
mod env;
mod errors;
mod evaluators;
mod everything;
mod filter;
mod fog;
mod fuzz;
mod glu;
mod glu_numbers;
mod hostile;
mod imaging;
mod lighting;
mod lines;
mod lists;
mod lod;
mod pixel_rectangles;
mod pixels;
mod rasterisation;
mod render_modes;
mod shadow;
mod sprites;
mod state;
mod tess;
mod texgen;
mod texture_images;
mod texture_objects;
mod transform;
mod vertex_array_objects;
mod vertex_arrays;
mod vertices;
mod words;
mod wrap;
