//! The oracle: the equations of the OpenGL 1.5 specification in f64, written to be read and compared with the
//! specification line by line. It is slow on purpose, knows nothing of how the crate works and shares no code with it,
//! only the values of the enumerants. What it computes is the ideal: the tests measure how far the crate is from it.
//! `spec-notes/oracle.md` says which equation stands in which file and how near the crate has to come.

#![allow(dead_code, reason = "every test binary that includes the oracle uses another part of it")]

pub mod clip;
pub mod env;
pub mod fragment;
pub mod light;
pub mod lod;
pub mod matrix;
pub mod raster;
pub mod scene;
pub mod texel;
pub mod vertex;

/// Two, three and four numbers.
pub type V2 = [f64; 2];
/// Three numbers: a direction, a normal, (s, t, r).
pub type V3 = [f64; 3];
/// Four numbers: a homogeneous position, a colour, (s, t, r, q).
pub type V4 = [f64; 4];

/// a . b
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The length of a vector.
pub fn length(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// The vector of length 1 in the direction of `a`; the zero vector stays zero (the specification leaves it open).
pub fn normalize(a: V3) -> V3 {
    let l = length(&a);
    if l == 0.0 { a } else { a.map(|x| x / l) }
}

/// a - b, component by component.
pub fn sub<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| a[i] - b[i])
}

/// a + b, component by component.
pub fn add<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| a[i] + b[i])
}

/// a * b, component by component.
pub fn mul<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| a[i] * b[i])
}

/// a * k.
pub fn scale<const N: usize>(a: [f64; N], k: f64) -> [f64; N] {
    a.map(|x| x * k)
}

/// a (1 - t) + b t.
pub fn mix<const N: usize>(a: [f64; N], b: [f64; N], t: f64) -> [f64; N] {
    std::array::from_fn(|i| a[i] * (1.0 - t) + b[i] * t)
}

/// The right-handed vector product.
pub fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Every component limited to [0, 1].
pub fn clamp01<const N: usize>(a: [f64; N]) -> [f64; N] {
    a.map(|x| x.clamp(0.0, 1.0))
}

/// Panics unless the two agree to `eps` in every component: the comparison of the oracle's own tests.
#[track_caller]
pub fn assert_near(a: &[f64], b: &[f64], eps: f64) {
    assert_eq!(a.len(), b.len());
    for (x, y) in a.iter().zip(b) {
        assert!((x - y).abs() <= eps, "{a:?} is not {b:?} (to {eps})");
    }
}
