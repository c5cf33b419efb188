//! A vertex with every value that there is (OpenGL 1.5, section 2.12): what RasterPos computes, and a raster position as
//! setup and feedback read it.

use crate::fragment::planes::{Layout, UnitSlots};
use crate::limits::MAX_TEXTURE_UNITS;
use crate::raster::vertex::Vertex;
use crate::simd::Level;
use crate::state::current::RasterPos;
use crate::vertex::batch::VertexBatch;
use crate::vertex::plan::VertexPlan;

/// Where the values of a whole vertex stand: primary colour, secondary colour, fog coordinate, then s, t, r, q of each unit.
pub(crate) struct WholeSlots {
    pub(crate) color: usize,
    pub(crate) secondary: usize,
    pub(crate) fog: usize,
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
    pub(super) plan: VertexPlan,
    pub(super) batch: Box<VertexBatch>,
    pub(super) layout: Layout,
}

impl RasterPosProcessor {
    pub(super) fn new(level: Level) -> Self {
        Self { plan: VertexPlan::new(level), batch: VertexBatch::new(), layout: whole_layout() }
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
