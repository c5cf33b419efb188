//! Leaving out what a scene does not need, and proof that it may be left out: random states and primitives are drawn by
//! the plan that leaves out what it can and by the general plan, which leaves nothing out; colour, depth and stencil must
//! be the same bytes. The specialised side changes its instruction set, threads and batch cut from case to case.

mod random;
mod rows;
mod same_bytes;
mod spans;
mod states;
mod table;
