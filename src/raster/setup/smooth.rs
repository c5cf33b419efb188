//! Setup of smooth triangles and lines (OpenGL 1.5, sections 3.4.2 and 3.5.6): a convex [`Outline`] and planes. A smooth
//! line is a rectangle around the segment; a stipple cuts it into shorter ones.

use super::SetupContext;
use super::line::LineInput;
use super::position::relative_snapped;
use super::triangle::TriangleInput;
use crate::raster::coverage::outline::Outline;
use crate::raster::geometry::{Coverage, SceneGeometry, index};
use crate::state::raster::PolygonMode;

impl SceneGeometry {
    /// Adds a smooth filled triangle.
    pub(crate) fn smooth_triangle(&mut self, cx: &SetupContext, t: &TriangleInput, area: i64, back: bool) {
        if area == 0 {
            return;
        }
        let first = self.pool.len();
        let planes = self.triangle_planes(cx, t, area, back, PolygonMode::Fill);
        let mut corners = t.v.map(|v| relative_snapped(v.head.snapped, planes.origin));
        if area < 0 {
            corners.swap(1, 2);
        }
        let outline = Outline::new(planes.origin, &corners, cx.rs.area);
        if outline.rect.is_empty() {
            self.pool.truncate(first);
            return;
        }
        self.outlines.push(outline);
        let cover = Coverage::Outline(index(self.outlines.len() - 1));
        self.push(cover, cx.draw, planes, area.unsigned_abs() >> 17);
    }

    /// Adds a smooth line: one rectangle, or one for each run of ones in the stipple.
    pub(crate) fn smooth_line(&mut self, cx: &SetupContext, s: &LineInput, stipple: &mut u32) {
        let planes = self.line_planes(cx, s, 1);
        let [a, b] = s.v.map(|v| relative_snapped(v.head.snapped, planes.origin));
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = (dx * dx + dy * dy).sqrt();
        if length == 0.0 {
            self.pool.truncate(planes.first as usize);
            return;
        }
        let (ux, uy) = (dx / length, dy / length);
        let half = f64::from(cx.rs.line_width) * 0.5;
        let (nx, ny) = (-uy * half, ux * half);
        let units = length.ceil() as u32;
        let mut rectangle = |from: f64, to: f64| {
            let at = |t: f64, side: f64| [a[0] + ux * t + nx * side, a[1] + uy * t + ny * side];
            let corners = [at(from, -1.0), at(to, -1.0), at(to, 1.0), at(from, 1.0)];
            let outline = Outline::new(planes.origin, &corners, cx.rs.clip);
            if !outline.rect.is_empty() {
                self.outlines.push(outline);
                let cover = Coverage::Outline(index(self.outlines.len() - 1));
                self.push(cover, cx.draw, planes, ((to - from) * (2.0 * half + 2.0)) as u64 + 1);
            }
        };
        match cx.rs.line_stipple {
            None => rectangle(0.0, length),
            Some((pattern, factor)) => {
                let on = |unit: u32| (pattern >> ((stipple.wrapping_add(unit) / factor) & 15)) & 1 != 0;
                let mut unit = 0;
                while unit < units {
                    let first = unit;
                    while unit < units && on(unit) {
                        unit += 1;
                    }
                    if unit > first {
                        rectangle(f64::from(first), f64::from(unit).min(length));
                    }
                    while unit < units && !on(unit) {
                        unit += 1;
                    }
                }
            }
        }
        if cx.rs.line_stipple.is_some() {
            *stipple = stipple.wrapping_add(units);
        }
    }
}
