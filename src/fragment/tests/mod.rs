//! Tests of the fragment room. This file has what they share: random numbers, primitives given by their planes, and three
//! ways to bring the same fragments to a program (batches of rows, one batch a row, scattered lanes), which must not
//! matter.

mod equations;
mod interpolation;
mod invariance;
mod textured;

use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::planes::{Linear, Plane, Planes};
use crate::fragment::program::{Options, Program};
use crate::framebuffer::{Framebuffer, FramebufferFormat};
use crate::simd::{LANES, Level};
use crate::state::State;

/// A small generator of random numbers, the same everywhere.
pub(super) struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 >> 8
    }

    pub fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    pub fn bool(&mut self) -> bool {
        self.below(2) == 1
    }

    pub fn unit(&mut self) -> f64 {
        self.below(1 << 30) as f64 / f64::from(1 << 30)
    }

    pub fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len() as u64) as usize]
    }
}

/// Primitives with their planes, as setup would make them.
#[derive(Clone, Default)]
pub(super) struct Scene {
    pub planes: Vec<Planes>,
    pub pool: Vec<Plane>,
}

/// The greatest depth of 24 bits, to which the depths of primitives are limited.
pub(super) const DEPTH_MAX: f64 = 16_777_215.0;

/// A value at the corners (0, 0), (w, 0), (0, h) of a rectangle.
pub(super) type Corners = [f64; 3];

impl Scene {
    /// Appends a primitive with its origin at pixel (x, y) that has relative 1/w `r` and the values `slots` at the
    /// corners of a rectangle of `size` pixels. Divides as [`planes`](crate::fragment::planes) says; no slot is a q.
    pub fn push(&mut self, origin: [i32; 2], size: [f64; 2], z: Corners, r: Corners, slots: &[Corners]) -> u32 {
        let linear = |v: Corners| Linear { at: v[0], x: (v[1] - v[0]) / size[0], y: (v[2] - v[0]) / size[1] };
        let first = self.pool.len() as u32;
        for s in slots {
            // The value at the fourth corner decides the range as well.
            let fourth = s[1] + s[2] - s[0];
            let (min, max) = s.iter().fold((fourth, fourth), |(a, b), v| (a.min(*v), b.max(*v)));
            let c = s[0];
            let n = linear(std::array::from_fn(|i| r[i] * (s[i] - c)));
            self.pool.push(Plane { c: c as f32, min: min as f32, max: max as f32, n0: n.at, nx: n.x, ny: n.y });
        }
        let affine = r == [1.0; 3];
        self.planes.push(Planes {
            origin,
            z: linear(z),
            z_range: [0.0, DEPTH_MAX],
            d: linear(r),
            affine,
            back: false,
            wide: 0,
            first,
            member: None,
        });
        self.planes.len() as u32 - 1
    }
}

/// How fragments are brought to a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Feed {
    /// Row segments, batches filled to the end.
    Rows,
    /// Row segments, each in a batch of its own.
    SingleRows,
    /// Scattered lanes, batches filled to the end.
    Dense,
    /// Rows and scattered lanes in turn.
    Mixed,
    /// Whole rows as far as the program takes them, then scattered lanes.
    Runs,
    /// Rows of a primitive together, cut in two somewhere, if the program takes them, else scattered lanes.
    Together,
}

impl Feed {
    pub const ALL: [Self; 6] = [Self::Rows, Self::SingleRows, Self::Dense, Self::Mixed, Self::Runs, Self::Together];
}

/// Brings the pixels of a rectangle of a primitive to a program.
pub(super) fn draw(
    program: &Program,
    scene: &Scene,
    framebuffer: &mut Framebuffer,
    feed: Feed,
    rects: &[(u32, [u32; 4])],
) -> u64 {
    let mut samples = 0;
    for mut band in framebuffer.bands(7) {
        let rows = band.y0..band.y0 + band.rows;
        let mut b = Box::new(FragmentBatch::new());
        for &(prim, [x0, y0, w, h]) in rects {
            if feed == Feed::Together {
                let mut all = Box::new(FragmentBatch::new());
                for y in (y0..y0 + h).filter(|y| rows.contains(y)) {
                    let cut = 1 + (7 * y + w / 3) % w.max(2);
                    for (x, len) in [(x0, cut.min(w)), (x0 + cut, w.saturating_sub(cut))] {
                        let (start, offset) = (0, band.offset(x, y));
                        all.segments[all.segment_count] =
                            Segment { prim, start, len, x: x as i32, y: y as i32, offset, row: true };
                        all.segment_count += usize::from(len > 0);
                    }
                }
                if program.rows(&mut all, &scene.planes, &scene.pool, &mut band) {
                    continue;
                }
            }
            for y in (y0..y0 + h).filter(|y| rows.contains(y)) {
                let row = match feed {
                    Feed::Rows | Feed::SingleRows => true,
                    Feed::Dense | Feed::Runs | Feed::Together => false,
                    Feed::Mixed => y % 3 != 1,
                };
                let mut x = x0;
                if feed == Feed::Runs {
                    let (offset, start) = (band.offset(x, y), 0);
                    let run = Segment { prim, start, len: w, x: x as i32, y: y as i32, offset, row: true };
                    x += program.row(&mut Box::new(FragmentBatch::new()), run, &scene.planes, &scene.pool, &mut band);
                    assert!(x <= x0 + w);
                }
                while x < x0 + w {
                    let left = x0 + w - x;
                    if row {
                        let offset = band.offset(x, y);
                        x += b.push_row(prim, x as i32, y as i32, offset, left);
                    } else {
                        let n = left.min(b.room() as u32);
                        let (start, origin) = (b.tex.n, scene.planes[prim as usize].origin);
                        b.segments[b.segment_count] =
                            Segment { prim, start: start as u32, len: n, row: false, ..Segment::default() };
                        for i in 0..n {
                            let lane = start + i as usize;
                            b.offset[lane] = band.offset(x + i, y);
                            b.dx[lane] = ((x + i) as i32).wrapping_sub(origin[0]) as f32;
                            b.dy[lane] = (y as i32).wrapping_sub(origin[1]) as f32;
                        }
                        b.segment_count += 1;
                        b.tex.n += n as usize;
                        x += n;
                    }
                    if b.room() == 0 || feed == Feed::SingleRows {
                        program.run(&mut b, &scene.planes, &scene.pool, &mut band);
                        b.clear();
                    }
                }
            }
            // A pixel must not be twice in a batch.
            program.run(&mut b, &scene.planes, &scene.pool, &mut band);
            b.clear();
        }
        samples += band.samples;
    }
    samples
}

/// All colours, depths and stencil values as bits.
pub(super) fn contents(f: &Framebuffer) -> (Vec<[u32; 4]>, Vec<u64>, Vec<u8>) {
    let (w, h) = (f.width() as usize, f.height());
    let (mut color, mut depth, mut stencil) = (Vec::new(), Vec::new(), Vec::new());
    for y in 0..h as i32 {
        let (mut c, mut d, mut s) = (vec![[0.0; 4]; w], vec![0.0; w], vec![0; w]);
        f.read_float(0, y, &mut c);
        f.read_depth(0, y, &mut d);
        f.read_stencil(0, y, &mut s);
        color.extend(c.iter().map(|c| c.map(f32::to_bits)));
        depth.extend(d.iter().map(|d| d.to_bits()));
        stencil.extend(s);
    }
    (color, depth, stencil)
}

/// A program without textures.
pub(super) fn program(level: Level, state: &State, format: &FramebufferFormat, options: Options) -> Program {
    Program::build(level, state, [None; 8], format, options)
}

/// The color of one pixel.
pub(super) fn pixel(f: &Framebuffer, x: i32, y: i32) -> [f32; 4] {
    let mut c = [[0.0; 4]];
    f.read_float(x, y, &mut c);
    c[0]
}

/// A primitive of one colour that covers everything, at depth z of 2^24 - 1.
pub(super) fn flat(color: [f64; 4], z: f64) -> Scene {
    let mut scene = Scene::default();
    let slots = color.map(|c| [c; 3]);
    scene.push([0, 0], [64.0, 64.0], [z; 3], [1.0; 3], &slots);
    scene
}

#[test]
fn lanes_are_aligned() {
    let b = FragmentBatch::new();
    for at in
        [b.z.as_ptr().addr(), b.tex.mask.as_ptr().addr(), b.tex.previous.as_ptr().addr(), b.packed.as_ptr().addr()]
    {
        assert_eq!(at % 64, 0);
    }
    assert_eq!(LANES % crate::fragment::reference::lanes::CHUNK, 0);
}
