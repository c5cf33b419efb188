//! What the rasteriser needs to know of the state (OpenGL 1.5, sections 2.13, 3.3 to 3.5, 4.1.2): rectangles, facing and
//! culling, polygon modes and offset, widths and stipples, as numbers that setup uses without looking anything up.

use crate::limits::{LINE_WIDTH_RANGE, POINT_SIZE_RANGE};
use crate::state::State;
use crate::state::lighting::ShadeModel;
use crate::state::raster::{PolygonMode, Winding};

/// What one unit of polygon offset adds to a depth, in steps of the depth buffer: the constant r of section 3.5.5. Of two depths
/// that are exactly one step apart, each rounded to the nearest step, both may become the same. It exceeds a step by more than
/// rounding errors can take from the difference of two polygons in one plane, and by so little that 500 units are still 500
/// steps.
pub(super) const RESOLVABLE: f64 = 1.0 + 1.0 / 1024.0;

/// A rectangle of pixels: x0 <= x < x1, y0 <= y < y1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rect {
    /// First column.
    pub x0: i32,
    /// First row.
    pub y0: i32,
    /// Column after the last.
    pub x1: i32,
    /// Row after the last.
    pub y1: i32,
}

impl Rect {
    /// The rectangle at (x, y) of a size, cut where a coordinate would not fit.
    #[must_use]
    pub const fn sized(x: i32, y: i32, width: i32, height: i32) -> Self {
        Self { x0: x, y0: y, x1: x.saturating_add(width), y1: y.saturating_add(height) }
    }

    /// The pixels that are in both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            x0: self.x0.max(other.x0),
            y0: self.y0.max(other.y0),
            x1: self.x1.min(other.x1),
            y1: self.y1.min(other.y1),
        }
    }

    /// Whether a position, in 1/256 pixel, is in it or on its border.
    #[must_use]
    pub fn holds(self, p: [i32; 2]) -> bool {
        let [x, y] = p.map(i64::from);
        let within = |v: i64, low: i32, high: i32| v >= i64::from(low) * 256 && v <= i64::from(high) * 256;
        within(x, self.x0, self.x1) && within(y, self.y0, self.y1)
    }

    /// Whether no pixel is in it.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.x0 >= self.x1 || self.y0 >= self.y1
    }
}

/// The rasteriser's part of a draw.
#[derive(Clone, Debug, PartialEq)]
pub struct RasterState {
    /// The viewport, in pixels.
    pub viewport: Rect,
    /// Where points and lines may write: scissor and framebuffer.
    pub clip: Rect,
    /// Where polygons may write: scissor, framebuffer and viewport.
    pub area: Rect,
    /// Whether front, back faces are culled.
    pub cull: [bool; 2],
    /// Whether a counter-clockwise polygon is a front face.
    pub ccw_is_front: bool,
    /// Modes of front and back faces.
    pub mode: [PolygonMode; 2],
    /// Whether depth is offset in modes point, line and fill (indexed by [`PolygonMode`]).
    pub offset: [bool; 3],
    /// Offset per unit of slope.
    pub offset_factor: f64,
    /// Offset in steps of the depth buffer.
    pub offset_units: f64,
    /// The depth buffer's largest value: window depths are multiplied by it.
    pub depth_scale: f64,
    /// Flat shading.
    pub flat: bool,
    /// Smooth points, lines, polygons.
    pub smooth: [bool; 3],
    /// Where points are sprites: bit u says that unit u takes the place within the point as its coordinates.
    pub sprite: Option<u32>,
    /// Line width, limited to what there is.
    pub line_width: f32,
    /// Line stipple pattern and factor where stippling is enabled.
    pub line_stipple: Option<(u16, u32)>,
    /// Polygon stipple where it is enabled, row by row from below; bit 31 is the leftmost pixel.
    pub polygon_stipple: Option<Box<[u32; 32]>>,
}

impl RasterState {
    /// Whether triangles are culled whose area in the window is positive (counter-clockwise), or is not.
    #[must_use]
    pub fn culls(&self) -> [bool; 2] {
        let faces = if self.ccw_is_front { [self.cull[0], self.cull[1]] } else { [self.cull[1], self.cull[0]] };
        // An area of zero is a back face (section 2.14.1), whichever way is the front.
        [faces[0], faces[1] && self.cull[1]]
    }

    /// What the state says, for a framebuffer of a size and with so many depth bits.
    #[must_use]
    pub fn build(state: &State, width: u32, height: u32, depth_bits: u32) -> Self {
        let side = |n: u32| i32::try_from(n).unwrap_or(i32::MAX);
        let frame = Rect { x0: 0, y0: 0, x1: side(width), y1: side(height) };
        let s = &state.scissor;
        let clip = if s.enabled { frame.and(Rect::sized(s.x, s.y, s.width, s.height)) } else { frame };
        let v = &state.viewport;
        let viewport = Rect::sized(v.x, v.y, v.width, v.height);
        let p = &state.polygon;
        let line = &state.line;
        let factor = line.stipple_factor.clamp(1, 256).unsigned_abs();
        let finite = |x: f32| if x.is_finite() { f64::from(x) } else { 0.0 };
        Self {
            viewport,
            clip,
            area: clip.and(viewport),
            cull: p.cull_face.chosen().map(|chosen| chosen && p.cull),
            ccw_is_front: p.front_face == Winding::CounterClockwise,
            mode: p.mode,
            offset: p.offset,
            offset_factor: finite(p.offset_factor),
            offset_units: finite(p.offset_units) * RESOLVABLE,
            depth_scale: ((1u64 << depth_bits.min(32)) - 1) as f64,
            flat: state.lighting.shade_model == ShadeModel::Flat,
            smooth: [state.point.smooth, line.smooth, p.smooth],
            sprite: state.point.sprite.then(|| {
                let units = state.texture.units.iter().zip(0..);
                units.fold(0, |mask, (unit, u)| mask | u32::from(unit.env.coord_replace) << u)
            }),
            line_width: limited(line.width, LINE_WIDTH_RANGE),
            line_stipple: line.stipple.then_some((line.stipple_pattern, factor)),
            polygon_stipple: p.stipple.then(|| Box::new(state.polygon_stipple.0)),
        }
    }
}

/// A width or size within its range; NaN is the least.
#[must_use]
pub fn limited(size: f32, [low, high]: [f32; 2]) -> f32 {
    if size > high {
        high
    } else if size >= low {
        size
    } else {
        low
    }
}

/// A point size within its range.
#[must_use]
pub fn limited_point(size: f32) -> f32 {
    limited(size, POINT_SIZE_RANGE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_initial_state_fills_both_faces_of_the_whole_viewport() {
        let mut state = State::default();
        (state.viewport.width, state.viewport.height) = (70, 50);
        let rs = RasterState::build(&state, 64, 64, 24);
        assert_eq!(rs.area, Rect { x0: 0, y0: 0, x1: 64, y1: 50 });
        assert_eq!(rs.clip, Rect { x0: 0, y0: 0, x1: 64, y1: 64 });
        assert_eq!((rs.cull, rs.ccw_is_front, rs.mode), ([false; 2], true, [PolygonMode::Fill; 2]));
        assert_eq!(rs.depth_scale, 16_777_215.0);
        assert!(!rs.flat && rs.line_stipple.is_none() && rs.polygon_stipple.is_none());
    }

    #[test]
    fn scissor_cuts_and_odd_numbers_do_no_harm() {
        let mut state = State::default();
        (state.viewport.width, state.viewport.height) = (i32::MAX, i32::MAX);
        state.scissor.enabled = true;
        (state.scissor.x, state.scissor.y) = (10, i32::MAX);
        (state.scissor.width, state.scissor.height) = (i32::MAX, i32::MAX);
        state.polygon.front_face = Winding::Clockwise;
        state.polygon.cull = true;
        state.line.width = f32::NAN;
        state.polygon.offset_factor = f32::INFINITY;
        let rs = RasterState::build(&state, 64, 64, 32);
        assert!(rs.area.is_empty());
        assert_eq!((rs.cull, rs.ccw_is_front), ([false, true], false));
        assert_eq!((rs.line_width, rs.offset_factor, rs.depth_scale), (1.0, 0.0, 4_294_967_295.0));
    }
}
