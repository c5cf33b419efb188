//! Setup of lines (OpenGL 1.5, section 3.4): the pixels of an aliased one and the planes of both kinds.

use super::SetupContext;
use super::basis::{Basis, CornerValues};
use super::position::{finite, relative, relative_snapped, within_limit};
use crate::fragment::planes::Planes;
use crate::raster::coverage::line::AliasedLine;
use crate::raster::geometry::{Coverage, SceneGeometry, index};
use crate::raster::vertex::VertexRef;

/// A line to be set up.
#[derive(Clone, Copy)]
pub(crate) struct LineInput<'a> {
    pub v: [VertexRef<'a>; 2],
    pub provoking: &'a [f32],
    /// Whether the colours of back faces are taken (boundary edges of polygons).
    pub back: bool,
    /// What is added to the depth, in units of the depth buffer.
    pub offset: f64,
}

impl SceneGeometry {
    /// Sets up a line. The stipple counter goes on.
    pub(crate) fn line(&mut self, cx: &SetupContext, s: &LineInput, stipple: &mut u32) {
        let p = s.v.map(|v| v.head.snapped);
        if !within_limit(&p) {
            return;
        }
        if cx.rs.smooth[1] {
            self.smooth_line(cx, s, stipple);
            return;
        }
        let width = ((cx.rs.line_width + 0.5) as i32).max(1);
        let (line, advance) = AliasedLine::new(p[0], p[1], width, *stipple, cx.rs);
        *stipple = stipple.wrapping_add(advance);
        let Some(line) = line else { return };
        self.lines.push(line);
        let cover = Coverage::Line(index(self.lines.len() - 1));
        let planes = self.line_planes(cx, s);
        self.push(cover, cx.draw, planes, u64::from((line.to - line.from).unsigned_abs()) * width as u64);
    }

    /// The planes of a line; those of its slots go to the plane buffer.
    pub(crate) fn line_planes(&mut self, cx: &SetupContext, s: &LineInput) -> Planes {
        let [a, b] = s.v.map(|v| v.head);
        let (wa, wb) = (a.clip[3], b.clip[3]);
        let from = if wb > 2.0 * wa {
            b.snapped
        } else if wa > 2.0 * wb {
            a.snapped
        } else {
            [0, 1].map(|k: usize| (a.snapped[k] + b.snapped[k]) >> 1)
        };
        let origin = from.map(|x| x >> 8);
        let snapped = Basis::line(relative_snapped(a.snapped, origin), relative_snapped(b.snapped, origin));
        let exact = Basis::line(relative(a.window, origin), relative(b.window, origin));
        let basis = if (exact.b[0].x + exact.b[0].y).is_finite() { exact } else { snapped };
        let scale = cx.rs.depth_scale;
        let mut z = finite(snapped.linear([a.window[2] * scale, b.window[2] * scale, b.window[2] * scale]));
        z.at += s.offset;
        let mut planes = Planes { origin, z, back: s.back, ..Planes::default() };
        let corner = [s.v[0].slots, s.v[1].slots, s.v[1].slots];
        let values = CornerValues { corner, provoking: s.provoking, back: s.back, w: [wa, wb, wb] };
        cx.plan.planes(&basis, &values, &mut planes, &mut self.pool);
        planes
    }
}
