//! Points (OpenGL 1.5, section 3.3): aliased ones are squares of a rounded size, smooth ones discs with coverage. All
//! values are those of the vertex, so their planes have no slope. A point is drawn or not by its centre; its square may
//! reach beyond the viewport.

use super::VertexRef;
use super::geometry::{Context, Cover, Geometry, index};
use super::plane::{Basis, Values};
use super::setup::within_limit;
use super::state::{Rect, limited_point};
use crate::fragment::planes::{Linear, Planes};

/// A point on its way to being filed.
#[derive(Clone, Copy)]
pub(super) struct Dot<'a> {
    pub v: VertexRef<'a>,
    pub provoking: &'a [f32],
    /// Whether the colours of back faces are taken (vertices of polygons).
    pub back: bool,
    /// What is added to the depth, in units of the depth buffer.
    pub offset: f64,
}

/// A smooth point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Pixels that may be touched.
    pub rect: Rect,
    /// The pixel that the centre is relative to.
    pub origin: [i32; 2],
    /// The centre, in pixels from the lower left corner of the origin pixel.
    pub center: [f64; 2],
    /// Radius in pixels.
    pub radius: f64,
}

impl Disc {
    /// How much of a pixel the disc covers: the mean, over 16 lines through the pixel, of the part of the line that is in
    /// the disc. Off by 2^-9 at most.
    #[must_use]
    pub fn coverage(&self, x: i32, y: i32) -> f32 {
        let left = f64::from(x - self.origin[0]) - self.center[0];
        let low = f64::from(y - self.origin[1]) - self.center[1];
        let far = |a: f64| if a + 0.5 > 0.0 { a + 1.0 } else { -a };
        let (fx, fy) = (far(left), far(low));
        let square = self.radius * self.radius;
        if fx * fx + fy * fy <= square {
            return 1.0;
        }
        let mut sum = 0.0;
        for line in 0..16 {
            let dy = low + (f64::from(line) + 0.5) * (1.0 / 16.0);
            let rest = square - dy * dy;
            if rest > 0.0 {
                let half = rest.sqrt();
                let part = (left + 1.0).min(half) - left.max(-half);
                sum += part.max(0.0);
            }
        }
        (sum * (1.0 / 16.0)) as f32
    }
}

/// The pixels of an aliased point: a square of `size` pixels around the pixel of the centre (odd sizes) or around the
/// corner nearest to the centre (even sizes).
fn square(center: [i32; 2], size: i32) -> Rect {
    let low = center.map(|c| if size % 2 == 1 { (c >> 8) - size / 2 } else { ((c + 128) >> 8) - size / 2 });
    Rect::sized(low[0], low[1], size, size)
}

impl Geometry {
    /// Sets up a point and files it.
    pub(super) fn point(&mut self, cx: &Context, dot: &Dot) {
        let head = dot.v.head;
        let center = head.snapped;
        if !within_limit(&[center]) {
            return;
        }
        let origin = center.map(|c| c >> 8);
        let size = limited_point(head.point_size);
        let cover = if cx.rs.smooth[0] {
            let radius = f64::from(size) * 0.5;
            let reach = (size * 0.5) as i32 + 2;
            let around = Rect::sized(origin[0] - reach, origin[1] - reach, 2 * reach + 1, 2 * reach + 1);
            let rect = around.and(cx.rs.clip);
            if rect.is_empty() {
                return;
            }
            let at = [0, 1].map(|k: usize| f64::from(center[k] - (origin[k] << 8)) * (1.0 / 256.0));
            self.discs.push(Disc { rect, origin, center: at, radius });
            Cover::Disc(index(self.discs.len() - 1))
        } else {
            let rect = square(center, ((size + 0.5) as i32).max(1)).and(cx.rs.clip);
            if rect.is_empty() {
                return;
            }
            Cover::Rect(rect)
        };
        let at = head.window[2] * cx.rs.depth_scale + dot.offset;
        let z = Linear { at: if at.is_finite() { at } else { 0.0 }, x: 0.0, y: 0.0 };
        let mut planes = Planes { origin, z, ..Planes::default() };
        let slots = dot.v.slots;
        let values = Values { corner: [slots; 3], provoking: dot.provoking, back: dot.back, w: [head.clip[3]; 3] };
        cx.recipe.planes(&Basis::default(), &values, &mut planes, &mut self.pool);
        self.file(cover, cx.draw, planes, (size * size) as u64 + 1);
    }
}
