//! Which pixels a primitive covers (OpenGL 1.5, sections 3.3 to 3.5), by its shape: a triangle's edges, an aliased line,
//! the disc of a smooth point, the outline of a smooth line or polygon.

pub(super) mod disc;
pub(super) mod edges;
pub(super) mod line;
pub(super) mod outline;
