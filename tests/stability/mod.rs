//! Stiff and extreme cases: every row of the catalogue on `spec-notes/stability.md` is a test here. What is expected comes
//! from formulas in f64, from whole numbers or from the oracle, never from the library. Where the specification leaves
//! the result open it must be a number, the documented one and the same at every instruction set, number of threads,
//! batch cut and plan (`common::everywhere`).
//!
//! `cargo test --test spec stability -- --nocapture --test-threads=1 | grep '^| '` prints the lines of the page's tables;
//! `FIXEDGL_BLESS=1 cargo test --test spec the_page` writes them into the page.

mod clip;
mod common;
mod coords;
mod fragment;
mod lod;
mod page;
mod raster;
mod row;
mod texels;
mod vertex;
