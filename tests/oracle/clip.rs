//! Clipping (OpenGL 1.5, section 2.12): a convex polygon is cut by the planes of the clip volume and by the user's clip
//! planes, one after the other (Sutherland and Hodgman). What a cut makes is a point on the edge from P1 to P2 at the
//! parameter t where the plane's distance is zero; every associated value is taken at the same t, in clip coordinates.
//! Here a corner is its weights over the original corners, so that the caller can interpolate whatever it likes.

use super::{V4, dot};

/// One corner of a clipped polygon: clip coordinates and the weights of the three original corners (they sum to 1).
#[derive(Clone, Debug, PartialEq)]
pub struct Corner {
    pub clip: V4,
    pub weights: [f64; 3],
}

/// The six half spaces -w <= x, y, z <= w as planes over (x, y, z, w).
pub const VOLUME: [V4; 6] = [
    [1.0, 0.0, 0.0, 1.0],
    [-1.0, 0.0, 0.0, 1.0],
    [0.0, 1.0, 0.0, 1.0],
    [0.0, -1.0, 0.0, 1.0],
    [0.0, 0.0, 1.0, 1.0],
    [0.0, 0.0, -1.0, 1.0],
];

/// Keeps the part of a polygon where `distance` is not negative. `distance` must be linear over the polygon.
pub fn cut(polygon: &[Corner], distance: impl Fn(&Corner) -> f64) -> Vec<Corner> {
    let mut out = Vec::new();
    for (i, a) in polygon.iter().enumerate() {
        let b = &polygon[(i + 1) % polygon.len()];
        let (da, db) = (distance(a), distance(b));
        if da >= 0.0 {
            out.push(a.clone());
        }
        if (da >= 0.0) != (db >= 0.0) {
            let t = da / (da - db);
            let mix = |x: f64, y: f64| x + t * (y - x);
            out.push(Corner {
                clip: std::array::from_fn(|k| mix(a.clip[k], b.clip[k])),
                weights: std::array::from_fn(|k| mix(a.weights[k], b.weights[k])),
            });
        }
    }
    out
}

/// Clips a triangle to the clip volume (its near and far planes and, unless `guard_band`, its four sides) and to the user
/// planes, which are given in eye coordinates together with the eye coordinates of the three corners.
pub fn clip_triangle(clip: [V4; 3], eye: [V4; 3], user_planes: &[V4], guard_band: bool) -> Vec<Corner> {
    let unit = |i: usize| std::array::from_fn(|k| if k == i { 1.0 } else { 0.0 });
    let mut polygon: Vec<Corner> = (0..3).map(|i| Corner { clip: clip[i], weights: unit(i) }).collect();
    for plane in user_planes {
        let d: [f64; 3] = std::array::from_fn(|i| dot(plane, &eye[i]));
        polygon = cut(&polygon, |c| dot(&c.weights, &d));
    }
    let sides = if guard_band { &VOLUME[4..] } else { &VOLUME[..] };
    for plane in sides {
        polygon = cut(&polygon, |c| dot(plane, &c.clip));
    }
    // -w <= z <= w leaves w >= 0; a corner with w = 0 lies at infinity, where there is nothing to draw.
    let tiny = polygon.iter().map(|c| c.clip[3]).fold(0.0, f64::max) * 1e-12;
    cut(&polygon, |c| c.clip[3] - tiny)
}

/// The visible part of a line from `a` to `b` as parameters (t0, t1), if any.
pub fn clip_line(a: V4, b: V4, eye: [V4; 2], user_planes: &[V4]) -> Option<(f64, f64)> {
    let (mut t0, mut t1) = (0.0f64, 1.0f64);
    let user = user_planes.iter().map(|p| (dot(p, &eye[0]), dot(p, &eye[1])));
    let volume = VOLUME.iter().map(|p| (dot(p, &a), dot(p, &b)));
    for (da, db) in user.chain(volume) {
        if da < 0.0 && db < 0.0 {
            return None;
        }
        if da < 0.0 {
            t0 = t0.max(da / (da - db));
        } else if db < 0.0 {
            t1 = t1.min(da / (da - db));
        }
    }
    (t0 <= t1).then_some((t0, t1))
}

#[cfg(test)]
mod tests {
    use super::super::assert_near;
    use super::*;

    #[test]
    fn a_triangle_inside_stays_as_it_is() {
        let t = [[0.0, 0.0, 0.0, 1.0], [0.5, 0.0, 0.0, 1.0], [0.0, 0.5, 0.0, 1.0]];
        let out = clip_triangle(t, t, &[], false);
        assert_eq!(out.len(), 3);
        assert_eq!([out[0].clip, out[1].clip, out[2].clip], t);
    }

    #[test]
    fn one_corner_outside_makes_a_quad() {
        let t = [[0.0, -0.5, 0.0, 1.0], [2.0, 0.0, 0.0, 1.0], [0.0, 0.5, 0.0, 1.0]];
        let out = clip_triangle(t, t, &[], false);
        assert_eq!(out.len(), 4);
        assert_near(&out[1].clip, &[1.0, -0.25, 0.0, 1.0], 1e-15);
        assert_near(&out[1].weights, &[0.5, 0.5, 0.0], 1e-15);
        assert_near(&out[2].clip, &[1.0, 0.25, 0.0, 1.0], 1e-15);
        assert_eq!(clip_triangle(t, t, &[], true).len(), 3);
    }

    #[test]
    fn the_eye_plane_is_never_reached() {
        // From z = -3 in front to z = 3 behind the eye under a frustum with near 1, far 10: cut at z = -1.
        let p = |x: f64, z: f64| [x, 0.0, (-11.0 * z - 20.0) / 9.0, -z];
        let t = [p(-1.0, -3.0), p(1.0, -3.0), p(0.0, 3.0)];
        let out = clip_triangle(t, t, &[], true);
        assert_eq!(out.len(), 4);
        assert!(out.iter().all(|c| c.clip[3] >= 1.0 - 1e-12), "{out:?}");
        let behind = [p(0.0, 1.0), p(1.0, 2.0), p(2.0, 3.0)];
        assert!(clip_triangle(behind, behind, &[], true).is_empty());
    }

    #[test]
    fn a_user_plane_cuts_in_eye_coordinates() {
        let t = [[-1.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0]];
        let out = clip_triangle(t, t, &[[1.0, 0.0, 0.0, -0.5]], false);
        assert_eq!(out.len(), 3);
        assert!(out.iter().all(|c| c.clip[0] >= 0.5));
        let (t0, t1) =
            clip_line(t[0], [3.0, 0.0, 0.0, 1.0], [t[0], [3.0, 0.0, 0.0, 1.0]], &[[1.0, 0.0, 0.0, 0.0]]).unwrap();
        assert_near(&[t0, t1], &[0.25, 0.5], 1e-15);
    }
}
