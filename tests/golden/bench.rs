//! The scenes of the benchmark, small: what was measured is also what must keep its bytes.

#![allow(dead_code, reason = "the tests need no targets, repetitions or counts")]

#[path = "../../examples/bench/scenes.rs"]
mod scenes;
#[path = "../../examples/bench/setups.rs"]
mod setups;
#[path = "../../examples/bench/stage.rs"]
pub mod stage;

pub use scenes::{SCENES, Scene};
