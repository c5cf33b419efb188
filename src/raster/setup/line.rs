//! Setup of lines (OpenGL 1.5, section 3.4): the pixels of an aliased one and the planes of both kinds.

use super::SetupContext;
use super::basis::{Basis, CornerValues};
use super::depth::Depth;
use super::position::{relative, relative_snapped, within_limit};
use crate::fragment::planes::Planes;
use crate::raster::coverage::line::{AliasedLine, minor_axis};
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
        if cx.rs.line_stipple.is_some() {
            *stipple = stipple.wrapping_add(advance);
        }
        let Some(line) = line else { return };
        let mut planes = None;
        // Section 3.4.2: the fragments across a line are copies of the lowest one. Its planes move along with the line.
        for by in 0..width {
            let Some(line) = line.raised(by, cx.rs.clip) else { continue };
            let lowest = *planes.get_or_insert_with(|| self.line_planes(cx, s, width));
            let mut planes = lowest;
            planes.origin[minor_axis([p[1][0] - p[0][0], p[1][1] - p[0][1]])] += by;
            self.lines.push(line);
            let cover = Coverage::Line(index(self.lines.len() - 1));
            self.push(cover, cx.draw, planes, u64::from((line.to - line.from).unsigned_abs()));
        }
    }

    /// The planes of the lowest fragments of a line that is `width` fragments wide: those of the line moved down by
    /// (width - 1) / 2. The planes of its slots go to the plane buffer.
    pub(crate) fn line_planes(&mut self, cx: &SetupContext, s: &LineInput, width: i32) -> Planes {
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
        let minor = minor_axis([b.snapped[0] - a.snapped[0], b.snapped[1] - a.snapped[1]]);
        let line = |mut a: [f64; 2], mut b: [f64; 2]| {
            let down = f64::from(width - 1) * 0.5;
            a[minor] -= down;
            b[minor] -= down;
            Basis::line(a, b)
        };
        let snapped = line(relative_snapped(a.snapped, origin), relative_snapped(b.snapped, origin));
        let exact = line(relative(a.window, origin), relative(b.window, origin));
        let basis = if (exact.b[0].x + exact.b[0].y).is_finite() { exact } else { snapped };
        let corner = [a, b, b].map(|v| v.window[2] * cx.rs.depth_scale);
        let z = Depth::new(cx.rs, basis.linear(corner), corner, 0.0, s.offset);
        let mut planes = Planes { origin, z: z.plane, z_range: z.range, back: s.back, ..Planes::default() };
        let corner = [s.v[0].slots, s.v[1].slots, s.v[1].slots];
        let values = CornerValues { corner, provoking: s.provoking, back: s.back, w: [wa, wb, wb] };
        cx.plan.planes(&basis, &values, &mut planes, &mut self.pool);
        planes
    }
}
