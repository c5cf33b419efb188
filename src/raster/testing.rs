//! For the tests of this room: a shader that counts how often each pixel is hit and can write down every value that it
//! is told to interpolate, and helpers that make vertices of window positions.

use super::vertex::Vertex;
use super::vertex::VertexRef;
use super::{Draw, FragmentProgram, PrimitiveSink, RasterState, Scene};
use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::planes::{Layout, Plane, PlanePool, Planes};
use crate::framebuffer::{Band, Framebuffer, FramebufferFormat};
use crate::simd::Level;
use crate::state::State;
use std::sync::{Arc, Mutex};

/// A fragment as a test sees it: x, y relative to the primitive's origin, the primitive's plane set, and its coverage.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    pub at: [i32; 2],
    pub z: f64,
    pub values: Vec<f32>,
    pub coverage: f32,
}

/// Counts hits in the colour buffer; notes what it saw where `note` is set.
#[derive(Debug, Default)]
pub struct Counter {
    pub layout: Layout,
    pub note: bool,
    pub seen: Mutex<Vec<Seen>>,
}

/// The value of a plane as the fragment stages compute it.
pub fn value(plane: &Plane, planes: &Planes, dx: f32, dy: f32) -> f32 {
    let linear = |at: f64, x: f64, y: f64| (at as f32 + y as f32 * dy) + x as f32 * dx;
    let rw = if planes.affine { 1.0 } else { 1.0 / linear(planes.d.at, planes.d.x, planes.d.y) };
    let f = plane.c + linear(plane.n0, plane.nx, plane.ny) * rw;
    f.max(plane.min).min(plane.max)
}

impl FragmentProgram for Counter {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn ordered(&self) -> bool {
        true
    }

    fn coverage(&self) -> bool {
        self.note
    }

    fn draws_nothing(&self) -> bool {
        false
    }

    fn run(&self, b: &mut FragmentBatch, planes: &[Planes], pool: PlanePool<'_>, band: &mut Band<'_>) {
        let mut seen = self.seen.lock().unwrap();
        let mut offsets = Vec::new();
        let mut lane = 0;
        for s in &b.segments[..b.segment_count] {
            assert_eq!(s.start as usize, lane, "segments follow each other");
            assert!(s.len > 0);
            let of = &planes[s.prim as usize];
            for i in 0..s.len as usize {
                let (offset, dx, dy) = if s.row {
                    let x = s.x + i as i32 - of.origin[0];
                    (s.offset + i as u32, x as f32, (s.y - of.origin[1]) as f32)
                } else {
                    (b.offset[lane + i], b.dx[lane + i], b.dy[lane + i])
                };
                let at = [of.origin[0] + dx as i32, of.origin[1] + dy as i32];
                assert_eq!(band.offset(at[0] as u32, at[1] as u32), offset, "offset of {at:?}");
                offsets.push(offset);
                if self.note {
                    let slots = (0..self.layout.count).filter_map(|slot| pool.plane(of, slot));
                    let values = slots.map(|p| value(&p, of, dx, dy)).collect();
                    let z = of.z.at + of.z.y * f64::from(dy) + of.z.x * f64::from(dx);
                    let z = z.clamp(of.z_range[0], of.z_range[1]);
                    seen.push(Seen { at, z, values, coverage: b.coverage[lane + i] });
                }
            }
            lane += s.len as usize;
        }
        assert_eq!(b.tex.n, lane);
        for offset in &offsets {
            band.rgba8[*offset as usize] += 1;
        }
        offsets.sort_unstable();
        offsets.dedup();
        assert_eq!(offsets.len(), lane, "a pixel is twice in a batch");
    }

    fn row_from(&self) -> u32 {
        20
    }

    /// All but the last few pixels of a run.
    fn row(
        &self,
        b: &mut FragmentBatch,
        run: Segment,
        planes: &[Planes],
        pool: PlanePool<'_>,
        band: &mut Band<'_>,
    ) -> u32 {
        assert!(run.len >= 20 && run.start == 0 && run.row);
        let mut done = 0;
        while run.len - done >= 3 {
            b.clear();
            done += b.push_row(run.prim, run.x + done as i32, run.y, run.offset + done, run.len - done);
            self.run(b, planes, pool, band);
        }
        done
    }
}

/// A vertex at a window position.
pub fn vertex(x: f64, y: f64, z: f64, w: f64) -> Vertex {
    Vertex {
        clip: [0.0, 0.0, 0.0, w],
        window: [x, y, z],
        snapped: [x, y].map(|v| (v * 256.0).round_ties_even() as i32),
        edge: true,
        point_size: 1.0,
        ..Vertex::default()
    }
}

/// A scene, its framebuffer and the draw that fills it.
pub struct TestCanvas {
    pub scene: Scene<Counter>,
    pub framebuffer: Framebuffer,
    pub draw: Arc<Draw<Counter>>,
    pub threads: usize,
}

impl TestCanvas {
    /// A square canvas with changed state.
    pub fn new(side: u32, count: usize, threads: usize, cut: usize, change: impl FnOnce(&mut State)) -> Self {
        let layout = Layout { count, stride: count, ..Layout::default() };
        Self::with_layout(side, layout, threads, cut, change)
    }

    /// The same with a whole layout.
    pub fn with_layout(side: u32, layout: Layout, threads: usize, cut: usize, change: impl FnOnce(&mut State)) -> Self {
        let mut state = State::default();
        (state.viewport.width, state.viewport.height) = (side as i32, side as i32);
        change(&mut state);
        let raster = RasterState::build(&state, side, side, 24);
        let note = layout.count > 0;
        let draw = Arc::new(Draw { program: Arc::new(Counter { layout, note, ..Counter::default() }), raster });
        let mut scene = Scene::new(threads, cut, Level::detect());
        scene.begin_draw(draw.clone());
        let framebuffer = Framebuffer::new(side, side, FramebufferFormat::default()).unwrap();
        Self { scene, framebuffer, draw, threads }
    }

    /// Draws a triangle of vertices with their slots.
    pub fn triangle(&mut self, v: &[Vertex; 3], slots: &[Vec<f32>; 3]) {
        let r = [0, 1, 2].map(|i: usize| VertexRef { head: &v[i], slots: &slots[i] });
        self.scene.triangle(r, 2, [true; 3]);
    }

    /// Draws a triangle of positions.
    pub fn plain(&mut self, p: [[f64; 2]; 3]) {
        let v = p.map(|[x, y]| vertex(x, y, 0.5, 1.0));
        self.triangle(&v, &[vec![], vec![], vec![]]);
    }

    /// Draws a line of positions.
    pub fn line(&mut self, a: [f64; 2], b: [f64; 2]) {
        let v = [a, b].map(|[x, y]| vertex(x, y, 0.5, 1.0));
        let r = [0, 1].map(|i: usize| VertexRef { head: &v[i], slots: &[] });
        self.scene.restart_stipple();
        self.scene.line(r, 1);
    }

    /// Draws a point.
    pub fn point(&mut self, [x, y]: [f64; 2], size: f32) {
        let head = Vertex { point_size: size, ..vertex(x, y, 0.5, 1.0) };
        self.scene.point(VertexRef { head: &head, slots: &[] });
    }

    /// How often each pixel was hit, row by row from below.
    pub fn hits(&mut self) -> Vec<u32> {
        self.scene.make_room(&mut self.framebuffer, self.threads);
        self.framebuffer.band().rgba8.to_vec()
    }

    /// What the shader saw, in a fixed order.
    pub fn seen(&mut self) -> Vec<Seen> {
        self.scene.make_room(&mut self.framebuffer, self.threads);
        let mut seen = std::mem::take(&mut *self.draw.program.seen.lock().unwrap());
        seen.sort_by_key(|s| [s.at[1], s.at[0]]);
        seen
    }
}

/// Random numbers that are the same in every run.
pub struct Random(pub u64);

impl Random {
    /// The next one, in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let x = self.0 ^ (self.0 >> 29);
        (x.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
    }

    /// The next one between two limits.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + self.unit() * (high - low)
    }
}
