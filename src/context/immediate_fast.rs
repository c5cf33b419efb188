//! The common path of the commands of a vertex (OpenGL 1.5, sections 2.6 and 2.7): what all but a few of the calls between
//! Begin and End do is to store some numbers. Each function here stores them and says true, or changes nothing and says
//! false, where there is more to do: a batch that is full, a material that follows the colour, a unit that gets its first
//! q. The engine's commands of the same names begin with these functions and go on where they say false; so there is one
//! meaning, and a door that knows that nobody traces and no list is open may try them first. Nothing here can panic.

use super::engine::{Engine, Primitive};
use crate::enums::{GL_TEXTURE0, GLenum};

/// The common path of each command.
pub(crate) struct ImmediateFast;

impl ImmediateFast {
    /// A vertex that is not the last of its batch.
    #[inline(always)]
    pub(crate) fn vertex(engine: &mut Engine, position: [f32; 4]) -> bool {
        engine.primitive == Primitive::Inside && engine.pipe.vertex_at_once(position, &engine.state.current)
    }

    /// A colour that is not a material as well.
    #[inline(always)]
    pub(crate) fn color(engine: &mut Engine, color: [f32; 4]) -> bool {
        let at_once = !engine.state.lighting.color_material;
        if at_once {
            engine.state.current.color = color;
        }
        at_once
    }

    /// A secondary colour.
    #[inline(always)]
    pub(crate) fn secondary_color(engine: &mut Engine, color: [f32; 4]) -> bool {
        engine.state.current.secondary_color = color;
        true
    }

    /// A normal.
    #[inline(always)]
    pub(crate) fn normal(engine: &mut Engine, normal: [f32; 3]) -> bool {
        engine.state.current.normal = normal;
        true
    }

    /// Texture coordinates of unit 0.
    #[inline(always)]
    pub(crate) fn tex_coord(engine: &mut Engine, coordinates: [f32; 4]) -> bool {
        Self::multi_tex_coord(engine, GL_TEXTURE0, coordinates)
    }

    /// Texture coordinates of a unit that exists. A q that is not 1 must not be the first of the unit.
    #[inline(always)]
    pub(crate) fn multi_tex_coord(engine: &mut Engine, target: GLenum, coordinates: [f32; 4]) -> bool {
        let unit = target.wrapping_sub(GL_TEXTURE0);
        let Some(current) = engine.state.current.tex_coord.get_mut(unit as usize) else { return false };
        let at_once = coordinates[3] == 1.0 || engine.q_units & (1 << (unit % u32::BITS)) != 0;
        if at_once {
            *current = coordinates;
        }
        at_once
    }

    /// A fog coordinate.
    #[inline(always)]
    pub(crate) fn fog_coord(engine: &mut Engine, coordinate: f32) -> bool {
        engine.state.current.fog_coord = coordinate;
        true
    }

    /// A colour index.
    #[inline(always)]
    pub(crate) fn index(engine: &mut Engine, index: f32) -> bool {
        engine.state.current.index = index;
        true
    }

    /// An edge flag.
    #[inline(always)]
    pub(crate) fn edge_flag(engine: &mut Engine, flag: bool) -> bool {
        engine.state.current.edge_flag = flag;
        true
    }
}

/// The first of two pieces of code for a command that has a common path, the second one for all others.
#[cfg(feature = "capi")]
macro_rules! if_immediate_fast {
    (vertex, { $($yes:tt)* }, $no:tt) => { $($yes)* };
    (color, { $($yes:tt)* }, $no:tt) => { $($yes)* };
    (secondary_color, { $($yes:tt)* }, $no:tt) => { $($yes)* };
    (normal, { $($yes:tt)* }, $no:tt) => { $($yes)* };
    (tex_coord, { $($yes:tt)* }, $no:tt) => { $($yes)* };
    (multi_tex_coord, { $($yes:tt)* }, $no:tt) => { $($yes)* };
    (fog_coord, { $($yes:tt)* }, $no:tt) => { $($yes)* };
    (index, { $($yes:tt)* }, $no:tt) => { $($yes)* };
    (edge_flag, { $($yes:tt)* }, $no:tt) => { $($yes)* };
    ($op:ident, $yes:tt, { $($no:tt)* }) => { $($no)* };
}
#[cfg(feature = "capi")]
pub(crate) use if_immediate_fast;
