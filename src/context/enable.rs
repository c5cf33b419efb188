//! Enable, Disable and IsEnabled: one table of capabilities (OpenGL 1.5, table 6.8 and following, the rows of type B
//! with "IsEnabled"). A row says which boolean of the state a capability is and what its change makes stale; the three
//! commands only look it up.

use super::arrays::is_array;
use super::engine::Engine;
use crate::enums::*;
use crate::error::{Outcome, invalid_enum};
use crate::limits::{MAX_CLIP_PLANES, MAX_LIGHTS};
use crate::state::imaging::{FilterTarget, TableTarget};
use crate::state::texture::Target;
use crate::state::{Dirty, State};

const VERTEX: Dirty = Dirty { vertex: true, fragment: false, raster: false };
const FRAGMENT: Dirty = Dirty { vertex: false, fragment: true, raster: false };
const RASTER: Dirty = Dirty { vertex: false, fragment: false, raster: true };
const NONE: Dirty = Dirty::NONE;

/// The boolean that a capability stands for, and what it makes stale.
fn capability(state: &mut State, cap: GLenum) -> Option<(&mut bool, Dirty)> {
    let s = state;
    Some(match cap {
        GL_ALPHA_TEST => (&mut s.color_buffer.alpha_test, FRAGMENT),
        GL_AUTO_NORMAL => (&mut s.eval.auto_normal, NONE),
        GL_BLEND => (&mut s.color_buffer.blend, FRAGMENT),
        GL_COLOR_LOGIC_OP => (&mut s.color_buffer.logic_op_enabled, FRAGMENT),
        GL_COLOR_MATERIAL => (&mut s.lighting.color_material, VERTEX),
        GL_COLOR_SUM => (&mut s.fog.color_sum, Dirty::ALL),
        GL_CULL_FACE => (&mut s.polygon.cull, RASTER),
        GL_DEPTH_TEST => (&mut s.depth.test, FRAGMENT),
        GL_DITHER => (&mut s.color_buffer.dither, FRAGMENT),
        GL_FOG => (&mut s.fog.enabled, Dirty::ALL),
        GL_HISTOGRAM => (&mut s.pixel.imaging.histogram, NONE),
        GL_MINMAX => (&mut s.pixel.imaging.minmax, NONE),
        GL_INDEX_LOGIC_OP => (&mut s.color_buffer.index_logic_op_enabled, FRAGMENT),
        GL_LIGHTING => (&mut s.lighting.enabled, Dirty::ALL),
        GL_LINE_SMOOTH => (&mut s.line.smooth, Dirty::ALL),
        GL_LINE_STIPPLE => (&mut s.line.stipple, RASTER),
        GL_MULTISAMPLE => (&mut s.multisample.enabled, FRAGMENT),
        GL_NORMALIZE => (&mut s.transform.normalize, VERTEX),
        GL_POINT_SMOOTH => (&mut s.point.smooth, Dirty::ALL),
        GL_POINT_SPRITE_ARB => (&mut s.point.sprite, RASTER),
        GL_POLYGON_OFFSET_POINT => (&mut s.polygon.offset[0], RASTER),
        GL_POLYGON_OFFSET_LINE => (&mut s.polygon.offset[1], RASTER),
        GL_POLYGON_OFFSET_FILL => (&mut s.polygon.offset[2], RASTER),
        GL_POLYGON_SMOOTH => (&mut s.polygon.smooth, Dirty::ALL),
        GL_POLYGON_STIPPLE => (&mut s.polygon.stipple, RASTER),
        GL_RESCALE_NORMAL => (&mut s.transform.rescale_normal, VERTEX),
        GL_SAMPLE_ALPHA_TO_COVERAGE => (&mut s.multisample.alpha_to_coverage, FRAGMENT),
        GL_SAMPLE_ALPHA_TO_ONE => (&mut s.multisample.alpha_to_one, FRAGMENT),
        GL_SAMPLE_COVERAGE => (&mut s.multisample.coverage, FRAGMENT),
        GL_SCISSOR_TEST => (&mut s.scissor.enabled, RASTER),
        GL_STENCIL_TEST => (&mut s.stencil.test, FRAGMENT),
        _ => return indexed(s, cap),
    })
}

/// Capabilities that come in numbers: lights, clip planes, evaluators, what belongs to the active texture unit.
fn indexed(s: &mut State, cap: GLenum) -> Option<(&mut bool, Dirty)> {
    let nth = |first: GLenum, count: usize| {
        let i = cap.wrapping_sub(first) as usize;
        (i < count).then_some(i)
    };
    if let Some(i) = nth(GL_LIGHT0, MAX_LIGHTS) {
        return Some((&mut s.lighting.lights[i].enabled, VERTEX));
    }
    if let Some(i) = nth(GL_CLIP_PLANE0, MAX_CLIP_PLANES) {
        return Some((&mut s.transform.clip_plane_enabled[i], VERTEX));
    }
    if let Some(table) = TableTarget::from_gl(cap) {
        return Some((&mut s.pixel.imaging.tables[table as usize], NONE));
    }
    if let Some(filter) = FilterTarget::from_gl(cap) {
        return Some((&mut s.pixel.imaging.convolutions[filter as usize], NONE));
    }
    if let Some(i) = nth(GL_MAP1_COLOR_4, 9) {
        return Some((&mut s.eval.map1_enabled[i], NONE));
    }
    if let Some(i) = nth(GL_MAP2_COLOR_4, 9) {
        return Some((&mut s.eval.map2_enabled[i], NONE));
    }
    let unit = &mut s.texture.units[s.texture.active];
    if let Some(i) = nth(GL_TEXTURE_GEN_S, 4) {
        return Some((&mut unit.generation[i].enabled, Dirty::ALL));
    }
    texture_target(cap).map(|target| (&mut unit.enabled[target as usize], Dirty::ALL))
}

/// The target that a texture capability (or a bindable target name) stands for.
pub(crate) const fn texture_target(value: GLenum) -> Option<Target> {
    Some(match value {
        GL_TEXTURE_1D => Target::D1,
        GL_TEXTURE_2D => Target::D2,
        GL_TEXTURE_RECTANGLE_ARB => Target::Rectangle,
        GL_TEXTURE_3D => Target::D3,
        GL_TEXTURE_CUBE_MAP => Target::Cube,
        _ => return None,
    })
}

fn unknown(cap: GLenum) -> crate::error::GlError {
    invalid_enum(format!("{} is not something that can be enabled; see table 6.8 and following", name(cap)))
}

impl Engine {
    pub(crate) fn enable(&mut self, cap: GLenum) -> Outcome {
        self.set_capability(cap, true)
    }

    pub(crate) fn disable(&mut self, cap: GLenum) -> Outcome {
        self.set_capability(cap, false)
    }

    fn set_capability(&mut self, cap: GLenum, on: bool) -> Outcome {
        if is_array(cap) {
            return self.set_client_state(cap, on);
        }
        let (flag, stale) = capability(&mut self.state, cap).ok_or_else(|| unknown(cap))?;
        if *flag != on {
            *flag = on;
            self.dirty.add(stale);
            if cap == GL_COLOR_MATERIAL {
                self.track_color();
            }
        }
        Ok(())
    }

    pub(crate) fn is_enabled(&mut self, cap: GLenum) -> Outcome<bool> {
        match capability(&mut self.state, cap) {
            Some((flag, _)) => Ok(*flag),
            // SampleCoverage sets it, not Enable.
            None if cap == GL_SAMPLE_COVERAGE_INVERT => Ok(self.state.multisample.coverage_invert),
            None => self.client_capability(cap).ok_or_else(|| unknown(cap)),
        }
    }

    /// A capability of the state as it is now, for Get.
    pub(crate) fn capability(&mut self, cap: GLenum) -> Option<bool> {
        capability(&mut self.state, cap).map(|(flag, _)| *flag)
    }
}
