//! The current raster position (OpenGL 1.5, section 2.12): RasterPos sends a point through the vertex stages and keeps what
//! comes out; WindowPos takes window coordinates and the current attributes as they are. Pixel rectangles and bitmaps are
//! drawn there, with the colour, the texture coordinates and the distance that belong to it.

use super::engine::Engine;
use crate::fragment::planes::{Layout, UnitSlots};
use crate::limits::MAX_TEXTURE_UNITS;
use crate::num::clamp01;
use crate::raster::vertex::{Vertex, outcode};
use crate::simd::{Lanes, Level};
use crate::state::current::RasterPos;
use crate::state::fog::FogCoordSource;
use crate::vertex::batch::VertexBatch;
use crate::vertex::plan::{VertexPlan, Wants};

/// Where the values of a whole vertex stand: primary colour, secondary colour, fog coordinate, then s, t, r, q of each unit.
pub(crate) struct WholeSlots {
    pub(crate) color: usize,
    secondary: usize,
    fog: usize,
    pub(crate) coordinates: usize,
}

/// The one order of them.
pub(crate) const SLOTS: WholeSlots = WholeSlots { color: 0, secondary: 4, fog: 7, coordinates: 8 };

/// Everything that a vertex can have, each in a slot.
pub(crate) fn whole_layout() -> Layout {
    let slots = |unit: usize| {
        let base = SLOTS.coordinates + 4 * unit;
        UnitSlots { base, count: 3, has_q: true, period: [0; 3], size: [1; 3], cube: false }
    };
    let count = SLOTS.coordinates + 4 * MAX_TEXTURE_UNITS;
    Layout {
        color: Some(SLOTS.color),
        secondary: Some(SLOTS.secondary),
        fog: Some(SLOTS.fog),
        units: std::array::from_fn(|unit| Some(slots(unit))),
        count,
        back: None,
        stride: count,
    }
}

/// What RasterPos works with, made when it is called first.
#[derive(Debug)]
pub(crate) struct RasterPosProcessor {
    plan: VertexPlan,
    batch: Box<VertexBatch>,
    layout: Layout,
}

impl RasterPosProcessor {
    fn new(level: Level) -> Self {
        Self { plan: VertexPlan::new(level), batch: VertexBatch::new(), layout: whole_layout() }
    }
}

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

/// A raster position as a vertex: the position, and the values of a layout's slots.
pub(crate) fn raster_vertex(raster: &RasterPos, layout: &Layout) -> (Vertex, Vec<f32>) {
    let [x, y, z, _] = raster.position;
    let head = Vertex { clip: [0.0, 0.0, 0.0, 1.0], window: [x, y, z], ..Vertex::default() };
    let mut slots = vec![0.0; layout.stride];
    let mut put = |slot: Option<usize>, values: &[f32]| {
        if let Some(to) = slot.and_then(|slot| slots.get_mut(slot..slot + values.len())) {
            to.copy_from_slice(values);
        }
    };
    put(layout.color, &raster.color);
    put(layout.back, &raster.color);
    put(layout.secondary, &raster.secondary_color[..3]);
    put(layout.fog, &[raster.distance]);
    for (unit, coordinates) in layout.units.iter().zip(&raster.tex_coord) {
        let Some(unit) = unit else { continue };
        put(Some(unit.base), &coordinates[..unit.count.min(3)]);
        if unit.has_q {
            put(Some(unit.base + unit.count), &coordinates[3..]);
        }
    }
    (head, slots)
}
