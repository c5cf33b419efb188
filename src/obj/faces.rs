//! Polygons to triangles. A convex face becomes a fan from its first corner; one with a notch is cut by ears (the crate
//! `earcut`) in the plane on which it covers the largest area.

/// A face with more corners than this is a fan in any case: cutting ears can take time by the square of their number.
const MOST: usize = 1024;

/// Cuts faces into triangles; keeps its memory from one to the next.
#[derive(Default)]
pub(super) struct Cutter {
    ears: earcut::Earcut<f64>,
    flat: Vec<[f64; 2]>,
    /// The triangles of the last face: numbers of its corners.
    pub triangles: Vec<[u32; 3]>,
    indices: Vec<u32>,
}

impl Cutter {
    /// Cuts a face. Whether its notches are kept: false if there are too many corners for that.
    pub fn cut(&mut self, corners: &[[f64; 3]]) -> bool {
        self.triangles.clear();
        let count = u32::try_from(corners.len()).unwrap_or(u32::MAX);
        let concave = count > 3 && self.project(corners) && is_concave(&self.flat);
        if concave && corners.len() <= MOST {
            self.ears.earcut_slice(&self.flat, &[], &mut self.indices);
            self.triangles.extend_from_slice(self.indices.as_chunks::<3>().0);
        }
        if self.triangles.is_empty() {
            self.triangles.extend((2..count).map(|i| [0, i - 1, i]));
        }
        !concave || corners.len() <= MOST
    }

    /// Projects the face along the axis that its normal (by Newell's sums) leans to most, so that it is wound
    /// counterclockwise. False if it has no area.
    fn project(&mut self, corners: &[[f64; 3]]) -> bool {
        let origin = corners.first().copied().unwrap_or_default();
        let at = |p: [f64; 3]| [p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]];
        let mut normal = [0.0; 3];
        let next = corners.iter().cycle().skip(1);
        for (&a, &b) in corners.iter().zip(next) {
            let (a, b) = (at(a), at(b));
            for i in 0..3 {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                normal[i] += a[j] * b[k] - a[k] * b[j];
            }
        }
        let axis = (0..3).fold(0, |best, i| if normal[i].abs() > normal[best].abs() { i } else { best });
        let (mut u, mut v) = ((axis + 1) % 3, (axis + 2) % 3);
        if normal[axis] < 0.0 {
            (u, v) = (v, u);
        }
        self.flat.clear();
        self.flat.extend(corners.iter().map(|&p| [at(p)[u], at(p)[v]]));
        normal[axis] != 0.0
    }
}

/// Whether a face that is wound counterclockwise turns right anywhere.
fn is_concave(flat: &[[f64; 2]]) -> bool {
    let n = flat.len();
    (0..n).any(|i| {
        let (a, b, c) = (flat[(i + n - 1) % n], flat[i], flat[(i + 1) % n]);
        let (e, f) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
        let turn = e[0] * f[1] - e[1] * f[0];
        // Corners on a straight edge may lean either way by rounding.
        let size = (e[0] * f[1]).abs() + (e[1] * f[0]).abs();
        turn < -1e-9 * size
    })
}
