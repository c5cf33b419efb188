//! The current raster position (OpenGL 1.5, section 2.12): RasterPos sends a point through the vertex stages and keeps what
//! comes out; WindowPos takes window coordinates and the current attributes as they are. Pixel rectangles and bitmaps are
//! drawn there, with the colour, the texture coordinates and the distance that belong to it.

use super::engine::Engine;
use super::whole_vertex::{RasterPosProcessor, SLOTS};
use crate::num::clamp01;
use crate::raster::vertex::outcode;
use crate::simd::Lanes;
use crate::state::current::RasterPos;
use crate::state::fog::FogCoordSource;
use crate::vertex::plan::Wants;

/// The first lane of slots.
fn first_lane<const N: usize>(out: &[Lanes], slot: usize) -> [f32; N] {
    std::array::from_fn(|i| out.get(slot + i).map_or(0.0, |lanes| lanes[0]))
}

impl Engine {
    pub(crate) fn raster_pos(&mut self, position: [f32; 4]) {
        let level = self.config.level;
        let processor = self.raster_pos.get_or_insert_with(|| Box::new(RasterPosProcessor::new(level)));
        let RasterPosProcessor { plan, batch, layout } = &mut **processor;
        plan.build(&self.state, layout, Wants::default());
        batch.clear();
        batch.push(position, &self.state.current, plan.needs);
        plan.run(&plan.plan.steps, batch);
        let outside = outcode::FRUSTUM | outcode::USER_ALL | outcode::BEHIND | outcode::NAN;
        let raster = &mut self.state.current.raster;
        raster.valid = batch.screen[0].outcode() & outside == 0;
        if !raster.valid {
            return;
        }
        let [x, y, z] = batch.window.each_ref().map(|lanes| lanes[0]);
        let out = &batch.out[..];
        let [r, g, b] = first_lane(out, SLOTS.secondary);
        *raster = RasterPos {
            position: [x, y, z, batch.clip[3][0]],
            distance: first_lane::<1>(out, SLOTS.fog)[0],
            color: first_lane::<4>(out, SLOTS.color).map(clamp01),
            secondary_color: [r, g, b, 1.0].map(clamp01),
            index: self.state.current.index,
            tex_coord: std::array::from_fn(|unit| first_lane(out, SLOTS.coordinates + 4 * unit)),
            valid: true,
        };
        self.select_raster_position();
    }

    /// The depth range maps z from [0, 1]; the colours and texture coordinates are the current ones, neither lit nor
    /// generated nor transformed.
    pub(crate) fn window_pos(&mut self, [x, y, z]: [f32; 3]) {
        let (near, far) = (self.state.viewport.near, self.state.viewport.far);
        let current = &mut self.state.current;
        let depth = near + f64::from(clamp01(z)) * (far - near);
        let fog_coord = self.state.fog.coord_source == FogCoordSource::FogCoord;
        current.raster = RasterPos {
            position: [f64::from(x), f64::from(y), depth, 1.0],
            distance: if fog_coord { current.fog_coord } else { 0.0 },
            color: current.color.map(clamp01),
            secondary_color: current.secondary_color.map(clamp01),
            index: current.index,
            tex_coord: current.tex_coord,
            valid: true,
        };
        self.select_raster_position();
    }
}
