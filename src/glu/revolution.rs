//! Drawing a surface of revolution (GLU 1.3, chapter 6): every quadric is rings of points around the z axis.
//!
//! A quadric is a small table: where ring `j` is (radius and height), how its normal leans, and what its texture
//! coordinates are. What the draw styles do with rings and slices is written once, here, for any [`QuadricSink`]. Slices run from +y towards +x, as GLU's do.

use super::constants::*;
use crate::enums::*;
use crate::num::sin_cos_deg;

/// Receives the primitives: a context, or a list in the tests.
pub(super) trait QuadricSink {
    fn begin(&mut self, mode: GLenum);
    fn end(&mut self);
    fn normal(&mut self, n: [f64; 3]);
    fn tex_coord(&mut self, t: [f64; 2]);
    fn vertex(&mut self, v: [f64; 3]);
}

/// A ring: its radius and height, and the outward normal as (away from the axis, along the axis).
#[derive(Clone, Copy, Debug)]
pub(super) struct Ring {
    pub radius: f64,
    pub z: f64,
    pub normal: [f64; 2],
}

/// How texture coordinates lie on the surface.
#[derive(Clone, Copy, Debug)]
pub(super) enum Mapping {
    /// s around the axis from 1 at the first slice to 0 at the last; t from 0 at the first ring to 1 at the last.
    Around,
    /// The square of this half width around the axis, seen from +z.
    Flat(f64),
}

/// What is special about the ends of a surface and the order of its rings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// The first and the last ring are poles, which are no lines; drawn from the last ring to the first.
    Ball,
    /// Both ends are rings.
    Tube,
    /// All faces are coplanar, so that a silhouette has the outline only.
    Ring,
    /// A ring whose last ring is its centre: the innermost band is a fan.
    Disk,
}

/// A surface of revolution.
pub(super) struct Revolution<R: Fn(f64) -> Ring> {
    /// The ring at parameter 0..=rings; fractional parameters give the normals of facets.
    pub ring: R,
    /// How many bands there are between rings.
    pub bands: u32,
    /// How many slices there are around the axis.
    pub slices: u32,
    /// Where the first slice begins and how far all together reach, in degrees from +y towards +x.
    pub start: f64,
    pub sweep: f64,
    pub mapping: Mapping,
    pub shape: Shape,
}

/// How a quadric wants its surfaces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    pub style: GLenum,
    pub normals: GLenum,
    pub inside: bool,
    pub texture: bool,
}

impl<R: Fn(f64) -> Ring> Revolution<R> {
    /// Draws the surface as `look` says.
    pub fn draw(&self, look: Look, sink: &mut impl QuadricSink) {
        match look.style {
            GLU_POINT => self.points(look, sink),
            GLU_LINE | GLU_SILHOUETTE => self.lines(look, sink),
            _ => self.fill(look, sink),
        }
    }

    /// Numbers of rings or bands in the order of drawing.
    fn order(&self, count: u32) -> impl Iterator<Item = u32> + use<R> {
        let from_last = self.shape == Shape::Ball;
        (0..count).map(move |j| if from_last { count - 1 - j } else { j })
    }

    /// Bands of quads. The pair (ring j, ring j+1) faces outward in the order of the slices; inward the pair is swapped.
    fn fill(&self, look: Look, sink: &mut impl QuadricSink) {
        let hub = self.shape == Shape::Disk;
        let bands = if hub { self.bands - 1 } else { self.bands };
        if hub {
            self.fan(look, sink);
        }
        for j in self.order(bands) {
            let pair = if look.inside { [j + 1, j] } else { [j, j + 1] };
            sink.begin(GL_QUAD_STRIP);
            for i in 0..=self.slices {
                for ring in pair {
                    // A facet's normal is that of its middle, sent before the vertex that its flat colour comes from.
                    self.point(look, i, ring, [facet(i), f64::from(j) + 0.5], sink);
                }
            }
            sink.end();
        }
    }

    /// The innermost band of a disk without a hole.
    fn fan(&self, look: Look, sink: &mut impl QuadricSink) {
        sink.begin(GL_TRIANGLE_FAN);
        self.point(look, 0, self.bands, [0.0; 2], sink);
        for i in 0..=self.slices {
            let i = if look.inside { i } else { self.slices - i };
            self.point(look, i, self.bands - 1, [0.0; 2], sink);
        }
        sink.end();
    }

    /// Rings and slices as lines.
    fn lines(&self, look: Look, sink: &mut impl QuadricSink) {
        let silhouette = look.style == GLU_SILHOUETTE;
        let closed = self.sweep >= 360.0;
        let coplanar = matches!(self.shape, Shape::Ring | Shape::Disk);
        for j in self.order(self.bands + 1) {
            let end = j == 0 || j == self.bands;
            let is_point = match self.shape {
                Shape::Ball => end,
                Shape::Disk => j == self.bands,
                Shape::Tube | Shape::Ring => false,
            };
            let between = silhouette && !end && self.shape != Shape::Ball;
            if is_point || between {
                continue;
            }
            sink.begin(GL_LINE_STRIP);
            for i in 0..=self.slices {
                self.point(look, i, j, [facet(i), f64::from(j)], sink);
            }
            sink.end();
        }
        for i in 0..if closed { self.slices } else { self.slices + 1 } {
            let edge = !closed && (i == 0 || i == self.slices);
            if silhouette && coplanar && !edge {
                continue;
            }
            sink.begin(GL_LINE_STRIP);
            for j in self.order(self.bands + 1) {
                // The facet that a piece of this line ends is the one towards the ring drawn before.
                let middle = if self.shape == Shape::Ball { f64::from(j) + 0.5 } else { f64::from(j) - 0.5 };
                self.point(look, i, j, [f64::from(i), middle.clamp(0.0, f64::from(self.bands))], sink);
            }
            sink.end();
        }
    }

    /// Every vertex once.
    fn points(&self, look: Look, sink: &mut impl QuadricSink) {
        let look = Look { normals: if look.normals == GLU_NONE { GLU_NONE } else { GLU_SMOOTH }, ..look };
        let slices = if self.sweep >= 360.0 { self.slices } else { self.slices + 1 };
        sink.begin(GL_POINTS);
        for j in self.order(self.bands + 1) {
            for i in 0..slices {
                self.point(look, i, j, [0.0; 2], sink);
            }
        }
        sink.end();
    }

    /// The direction of slice `i` as (x, y). The last slice of a whole turn is the first, to the bit.
    fn direction(&self, i: f64) -> [f64; 2] {
        let slices = f64::from(self.slices);
        let i = if self.sweep >= 360.0 && i >= slices { i - slices } else { i };
        let (sin, cos) = sin_cos_deg(self.start + self.sweep * i / slices);
        [sin, cos]
    }

    /// Sends a vertex: slice `i` of ring `j`; a flat normal is that at the parameters `facet` (slice, ring).
    fn point(&self, look: Look, i: u32, j: u32, facet: [f64; 2], sink: &mut impl QuadricSink) {
        let (i, j) = (f64::from(i), f64::from(j));
        let ring = (self.ring)(j);
        let [x, y] = self.direction(i);
        if look.normals != GLU_NONE {
            let ([x, y], [across, along]) = if look.normals == GLU_FLAT {
                (self.direction(facet[0]), (self.ring)(facet[1]).normal)
            } else {
                ([x, y], ring.normal)
            };
            let sign = if look.inside { -1.0 } else { 1.0 };
            sink.normal([sign * across * x, sign * across * y, sign * along]);
        }
        if look.texture {
            sink.tex_coord(match self.mapping {
                Mapping::Around => [1.0 - i / f64::from(self.slices), j / f64::from(self.bands)],
                Mapping::Flat(half) => [x * ring.radius / half * 0.5 + 0.5, y * ring.radius / half * 0.5 + 0.5],
            });
        }
        sink.vertex([x * ring.radius, y * ring.radius, ring.z]);
    }
}

/// The middle of the slice that ends at `i`.
fn facet(i: u32) -> f64 {
    f64::from(i) - 0.5
}
