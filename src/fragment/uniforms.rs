//! What the fragment stages are told: the numbers of the state, already in the form in which the stages use them. Which
//! stages run is the program's matter; nothing here selects code apart from table indices.

use super::batch::FragmentBatch;
use super::planes::{Layout, Plane, Planes};
use crate::framebuffer::Band;

/// The numbers behind a program.
#[derive(Clone, Debug, Default)]
pub struct FragUniforms {
    /// Which slot holds what.
    pub layout: Layout,
    /// The largest depth value, as a float.
    pub depth_max: f64,
    /// Bits that are set in every packed pixel: alpha where the format has none.
    pub packed_or: u32,
    /// Bits of a packed pixel that may be written.
    pub color_mask: u32,
}

/// What a stage works with besides the batch: the primitives of the scene and the rows of the framebuffer.
#[derive(Debug)]
pub struct Work<'a, 'b> {
    /// What fragments need to know of each primitive.
    pub planes: &'a [Planes],
    /// The planes of the primitives' slots.
    pub pool: &'a [Plane],
    /// The rows that are drawn into.
    pub band: &'a mut Band<'b>,
}

/// A fragment stage.
pub type FragFn = for<'a, 'b> unsafe fn(&mut FragmentBatch, &FragUniforms, &mut Work<'a, 'b>, u32);
