//! The C ABI (cargo feature `capi`): the commands of the table as exported `gl*` functions with the signatures of the
//! ordinary headers, the OSMesa entry points, and `glu*`. Every `gl*` function is made from its row: pointers become
//! slices with the row's count, then the safe method of [`Context`](crate::Context) does the rest. No panic crosses the
//! boundary, and without a current context a command does nothing.
//!
//! `cargo rustc --release --lib --features capi --crate-type cdylib` builds `target/release/libfixedgl.so`.
#![expect(unsafe_code, reason = "C hands over raw pointers; `memory` and `current` say what is asked of them")]

mod current;
#[cfg(test)]
mod error_tests;
mod float_control;
mod glu;
mod manual;
mod memory;
mod osmesa;
#[cfg(test)]
mod osmesa_tests;
mod present;
mod proc_address;
#[cfg(test)]
mod quick_tests;
mod rows;
mod tess;
