//! Points (OpenGL 1.5, section 3.3): aliased ones are squares of a rounded size, smooth ones discs with coverage, sprites
//! squares of their exact size (ARB_point_sprite). All values are those of the vertex, so their planes have no slope, but
//! for the texture coordinates of sprites. A point is drawn or not by its centre; its square may reach beyond the viewport.

use super::SetupContext;
use super::basis::{Basis, CornerValues};
use super::position::within_limit;
use crate::fragment::planes::{Linear, Planes};
use crate::raster::coverage::disc::Disc;
use crate::raster::geometry::{Coverage, SceneGeometry, index};
use crate::raster::state::{Rect, limited_point};
use crate::raster::vertex::VertexRef;

/// A point to be set up.
#[derive(Clone, Copy)]
pub(crate) struct PointInput<'a> {
    pub v: VertexRef<'a>,
    pub provoking: &'a [f32],
    /// Whether the colours of back faces are taken (vertices of polygons).
    pub back: bool,
    /// What is added to the depth, in units of the depth buffer.
    pub offset: f64,
}

impl<'a> PointInput<'a> {
    /// A point that belongs to no polygon.
    pub(crate) fn front(v: VertexRef<'a>) -> Self {
        Self { v, provoking: v.slots, back: false, offset: 0.0 }
    }
}

/// The pixels of an aliased point: a square of `size` pixels around the pixel of the centre (odd sizes) or around the
/// corner nearest to the centre (even sizes).
fn square(center: [i32; 2], size: i32) -> Rect {
    let low = center.map(|c| if size % 2 == 1 { (c >> 8) - size / 2 } else { ((c + 128) >> 8) - size / 2 });
    Rect::sized(low[0], low[1], size, size)
}

/// The pixels of a sprite: those whose centres lie in a square of the side `size` around the point.
fn sprite(center: [i32; 2], size: f32) -> Rect {
    // Pixel x is in it where low <= x + 1/2 < low + size.
    let first = |low: f64| (low - 0.5).ceil() as i32;
    let [x, y] = center.map(|c| f64::from(c) * (1.0 / 256.0) - f64::from(size) * 0.5);
    let (x0, y0) = (first(x), first(y));
    Rect { x0, y0, x1: first(x + f64::from(size)), y1: first(y + f64::from(size)) }
}

impl SceneGeometry {
    /// Sets up a point.
    pub(crate) fn point(&mut self, cx: &SetupContext, dot: &PointInput) {
        let head = dot.v.head;
        let center = head.snapped;
        if !within_limit(&[center]) {
            return;
        }
        let origin = center.map(|c| c >> 8);
        let size = limited_point(head.point_size);
        let cover = if cx.rs.sprite.is_some() {
            let rect = sprite(center, size).and(cx.rs.clip);
            if rect.is_empty() {
                return;
            }
            Coverage::Rect(rect)
        } else if cx.rs.smooth[0] {
            let radius = f64::from(size) * 0.5;
            let reach = (size * 0.5) as i32 + 2;
            let around = Rect::sized(origin[0] - reach, origin[1] - reach, 2 * reach + 1, 2 * reach + 1);
            let rect = around.and(cx.rs.clip);
            if rect.is_empty() {
                return;
            }
            let at = [0, 1].map(|k: usize| f64::from(center[k] - (origin[k] << 8)) * (1.0 / 256.0));
            self.discs.push(Disc { rect, origin, center: at, radius });
            Coverage::Disc(index(self.discs.len() - 1))
        } else {
            let rect = square(center, ((size + 0.5) as i32).max(1)).and(cx.rs.clip);
            if rect.is_empty() {
                return;
            }
            Coverage::Rect(rect)
        };
        let planes = self.point_planes(cx, dot, origin);
        if let Some(units) = cx.rs.sprite.filter(|units| *units != 0) {
            let middle = [0, 1].map(|k: usize| f64::from(center[k] - (origin[k] << 8)) * (1.0 / 256.0) - 0.5);
            cx.plan.sprite_planes(units, middle, f64::from(size), self.pool.last_mut(cx.plan.layout().count));
        }
        self.push(cover, cx.draw, planes, (size * size) as u64 + 1);
    }

    /// Planes of values that are the same everywhere; those of the slots go to the plane buffer.
    pub(super) fn point_planes(&mut self, cx: &SetupContext, dot: &PointInput, origin: [i32; 2]) -> Planes {
        let head = dot.v.head;
        let at = head.window[2] * cx.rs.depth_scale + dot.offset;
        let z = Linear { at: if at.is_finite() { at } else { 0.0 }, x: 0.0, y: 0.0 };
        let mut planes = Planes { origin, z, z_range: [0.0, cx.rs.depth_scale], back: dot.back, ..Planes::default() };
        let slots = dot.v.slots;
        let values =
            CornerValues { corner: [slots; 3], provoking: dot.provoking, back: dot.back, w: [head.clip[3]; 3] };
        cx.plan.planes(&Basis::default(), &values, &mut planes, &mut self.pool);
        cx.plan.point_footprint(self.pool.last_mut(cx.plan.layout().count));
        planes
    }
}

#[cfg(test)]
mod tests {
    use crate::raster::testing::{Random, TestCanvas};

    #[test]
    fn aliased_points_are_squares_around_their_centres() {
        let mut random = Random(21);
        for _ in 0..500 {
            let size = random.between(0.0, 9.0) as f32;
            let at = [random.between(-3.0, 35.0), random.between(-3.0, 35.0)].map(|v: f64| (v * 256.0).round() / 256.0);
            let mut canvas = TestCanvas::new(32, 0, 1, 7, |_| {});
            canvas.point(at, size);
            let n = (f64::from(size) + 0.5).floor().max(1.0);
            let hits = canvas.hits();
            for y in 0..32 {
                for x in 0..32 {
                    // The specification's centre: the pixel's for odd sizes, the nearest corner for even ones.
                    let middle = at.map(|v| if n % 2.0 == 1.0 { v.floor() + 0.5 } else { (v + 0.5).floor() });
                    let near = |k: usize, v: i32| (f64::from(v) + 0.5 - middle[k]).abs() < n / 2.0;
                    assert_eq!(hits[(y * 32 + x) as usize] == 1, near(0, x) && near(1, y), "{at:?} {size} {x} {y}");
                }
            }
        }
    }

    #[test]
    fn size_one_is_one_pixel() {
        for at in [[3.0, 3.0], [3.99, 3.01], [3.5, 3.5]] {
            for size in [0.0, 1.0, 1.4, f32::NAN, -5.0] {
                let mut canvas = TestCanvas::new(8, 0, 1, 64, |_| {});
                canvas.point(at, size);
                let hits = canvas.hits();
                assert_eq!((hits[3 * 8 + 3], hits.iter().sum::<u32>()), (1, 1), "{at:?} {size}");
            }
        }
    }
}
