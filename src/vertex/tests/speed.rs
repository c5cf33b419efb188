//! How long a vertex takes: `cargo test --release vertex::tests::speed -- --ignored --nocapture`.

use super::*;
use crate::enums::*;
use crate::vertex::batch::VertexBatch;
use crate::vertex::lane::{Order, SourceDraw};
use crate::vertex::{Keys, Source};
use std::hint::black_box;
use std::time::Instant;

/// Counts and throws away.
#[derive(Default)]
struct Count(usize);

impl Assembled for Count {
    #[inline]
    fn triangle(&mut self, corners: [VertexRef<'_>; 3], _: usize, _: [bool; 3]) {
        black_box(corners);
        self.0 += 1;
    }
    fn line(&mut self, _: [VertexRef<'_>; 2], _: usize, _: bool) {}
    fn point(&mut self, _: VertexRef<'_>) {}
}

/// Batches that are full already.
struct Full;

impl Source for Full {
    fn places(&self, keys: &Keys<'_>, batch: &mut VertexBatch) {
        batch.n = keys.len();
    }
    fn values(&self, _: &Keys<'_>, _: &mut VertexBatch) {}
}

fn measure(name: &str, state: &State, layout: &Layout) {
    for level in Level::available() {
        let mut pipe = Pipe::new(level, 64);
        pipe.rebuild(state, layout, Wants::default());
        let current = Current { normal: [0.0, 0.6, 0.8], ..Current::default() };
        let mut sink = Count::default();
        let vertices = 64 * 3 * 1000;
        let mut best = [f64::MAX; 2];
        for _ in 0..10 {
            let start = Instant::now();
            pipe.begin(GL_TRIANGLES);
            for i in 0..vertices {
                let x = (i % 64) as f32 / 64.0;
                if pipe.vertex(black_box([x, 0.5, 0.25, 1.0]), &current) {
                    pipe.run(&mut sink);
                }
            }
            pipe.end();
            pipe.run(&mut sink);
            best[0] = best[0].min(start.elapsed().as_secs_f64());
            let start = Instant::now();
            let draw = SourceDraw { plan: &pipe.plan, source: &Full, mode: GL_TRIANGLES, cut: 64 };
            pipe.lane.draw(&draw, Order::Range(0..vertices), &mut sink, |_| {});
            best[1] = best[1].min(start.elapsed().as_secs_f64());
        }
        let ns = best.map(|t| t * 1e9 / f64::from(vertices));
        println!("{name:24} {level:?}: begin/end {:.1}, batches {:.1} ns/vertex", ns[0], ns[1]);
    }
}

#[test]
#[ignore = "a measurement"]
fn vertices_a_second() {
    measure("colour", &plain_state(), &color_layout());
    let mut layout = color_layout();
    layout.units[0] =
        Some(UnitSlots { base: 4, count: 2, has_q: false, period: [1, 1, 0], size: [64, 64, 1], cube: false });
    (layout.count, layout.stride) = (6, 6);
    measure("colour, texture", &plain_state(), &layout);
    let mut state = plain_state();
    state.lighting.enabled = true;
    state.lighting.lights[0].enabled = true;
    measure("lit, texture", &state, &layout);
    state.lighting.materials[0].specular = [0.5; 4];
    state.lighting.materials[0].shininess = 20.0;
    measure("lit specular, texture", &state, &layout);
    state.lighting.lights[0].position = [0.0, 0.0, 2.0, 1.0];
    state.lighting.lights[0].attenuation = [1.0, 0.1, 0.0];
    measure("lit by a lamp", &state, &layout);
    let mut state = plain_state();
    for generation in &mut state.texture.units[0].generation[..2] {
        generation.enabled = true;
        generation.mode = GL_SPHERE_MAP;
    }
    measure("sphere map", &state, &layout);
    clipped();
}

/// Triangles that all cross the near plane.
fn clipped() {
    for level in Level::available() {
        let mut pipe = Pipe::new(level, 64);
        pipe.rebuild(&plain_state(), &color_layout(), Wants::default());
        let mut sink = Count::default();
        let triangles = 30_000;
        let mut best = f64::MAX;
        for _ in 0..10 {
            sink.0 = 0;
            let start = Instant::now();
            pipe.begin(GL_TRIANGLES);
            for i in 0..3 * triangles {
                let z = if i % 3 == 0 { -3.0 } else { 0.5 };
                let position = [(i % 7) as f32 / 8.0, (i % 5) as f32 / 8.0, z, 1.0];
                if pipe.vertex(black_box(position), &Current::default()) {
                    pipe.run(&mut sink);
                }
            }
            pipe.end();
            pipe.run(&mut sink);
            best = best.min(start.elapsed().as_secs_f64());
        }
        assert_eq!(sink.0, 2 * triangles);
        println!("clipped {level:?}: {:.0} ns/triangle, its three vertices included", best * 1e9 / triangles as f64);
    }
}
