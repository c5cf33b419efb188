//! What a picture ought to be, in two senses that are never mixed. The oracle draws the same GL state in f64: the distance
//! from it is E_spec. And the continuous scene, filtered by the aperture of a pixel, is what sampling aims at: the
//! distance from that is E_samp. The continuous scene is level 0 of the textures, LINEAR, sampled k x k times a pixel into
//! floats; a pixel is the mean over its square, or under a Gaussian of sigma 1/2 that ends 2 pixels off. That this has
//! converged is shown by the distance between k and k/2.

use super::gl::{Gl, Library, Ours};
use super::knobs::Knobs;
use super::metrics::Ideal;
use super::oracle::fragment::stored;
use super::oracle::scene::{Scene, Story};
use super::translate;
use fixedgl::enums::*;

/// What the oracle makes of a scene in one setting.
pub struct Spec {
    /// The colours.
    pub ideal: Ideal,
    /// Pixels that may be either of two colours: NEAREST, and a coordinate within 2^-10 texel of a boundary; anisotropy,
    /// and a footprint whose sides are in the ratio of a whole number, so that there may be one tap more or less.
    pub doubtful: Vec<bool>,
    /// How many fragments were stored in each pixel.
    pub hits: Vec<u32>,
}

/// How near a boundary a coordinate has to be for NEAREST to be in doubt, in texels.
const DOUBT: f64 = 1.0 / 1024.0;

/// And how near a whole number the ratio of the sides of a footprint.
const RATIO: f64 = 1e-4;

fn doubtful(story: &Story, knobs: &Knobs) -> bool {
    let most = f64::from(knobs.anisotropy);
    let whole = |ratio: f64| ratio.round() < most && (ratio - ratio.round()).abs() <= RATIO * ratio;
    knobs.takes_nearest() && story.to_boundary <= DOUBT
        || knobs.anisotropy > 1 && story.samples.iter().flatten().any(|s| whole(s.anisotropy))
}

/// The oracle's picture.
pub fn spec(scene: &Scene, knobs: &Knobs) -> Spec {
    let mut scene = knobs.apply(scene);
    let upright = scene.vertex.projection;
    let pixels = (scene.width * scene.height) as usize;
    let mut sums = vec![[0.0; 4]; pixels];
    let mut spec = Spec { ideal: Vec::new(), doubtful: vec![false; pixels], hits: vec![0; pixels] };
    for by in knobs.shifts() {
        scene.vertex.projection = translate::moved(&scene, by);
        for (i, pixel) in scene.render().pixels.iter().enumerate() {
            // What is accumulated has been rounded to bytes; a single picture is compared before rounding.
            let color = if knobs.frames > 1 { stored(pixel.ideal) } else { pixel.ideal };
            sums[i] = std::array::from_fn(|c| sums[i][c] + 255.0 * color[c] / f64::from(knobs.frames));
            spec.hits[i] = spec.hits[i].max(pixel.hits);
            // Of several layers that are blended only the last one's story is known.
            let layers = knobs.takes_nearest() && scene.blend.is_some() && pixel.hits > 1;
            spec.doubtful[i] |= layers || pixel.story.as_ref().is_some_and(|story| doubtful(story, knobs));
        }
        scene.vertex.projection = upright;
    }
    spec.ideal = sums.iter().map(|c| c.map(|v| v as f32)).collect();
    spec
}

/// The scene through two apertures.
pub struct Filtered {
    /// The square of a pixel.
    pub square: Ideal,
    /// A Gaussian of sigma 1/2.
    pub gauss: Ideal,
}

/// How far the Gaussian reaches, in pixels.
const REACH: i64 = 2;

/// The weights of the samples at `offset` (from -1/2 to 1/2) in the pixels -2 .. 2 away.
fn gaussian(offset: f64) -> [f32; 5] {
    std::array::from_fn(|i| {
        let x = i as f64 - REACH as f64 + offset;
        if x.abs() <= REACH as f64 { (-2.0 * x * x).exp() as f32 } else { 0.0 }
    })
}

/// Adds to each pixel of `to` the five pixels of `from` around it along one axis, weighted; `step` is the distance of
/// neighbours on that axis, of which there are `n`. The fourth number of a pixel is the sum of its weights.
fn spread(from: &[[f32; 4]], to: &mut [[f32; 4]], weights: [f32; 5], step: usize, n: usize) {
    for (from, to) in from.chunks(step * n).zip(to.chunks_mut(step * n)) {
        for (k, weight) in weights.into_iter().enumerate() {
            let (before, after) = (2usize.saturating_sub(k) * step, k.saturating_sub(2) * step);
            let inside = from.len().saturating_sub(before + after);
            let pairs = to.iter_mut().skip(before).take(inside).zip(from.iter().skip(after));
            for (sum, texel) in pairs {
                *sum = std::array::from_fn(|c| sum[c] + weight * texel[c]);
            }
        }
    }
}

/// The scene, sampled k x k times a pixel.
pub fn filtered(ours: &Ours, scene: &Scene, k: u32) -> Filtered {
    let linear = Knobs { min: GL_LINEAR, ..super::knobs::settings(super::scenes::Depth::Short, true)[0].clone() };
    let scene = linear.apply(scene);
    let mut gl = ours.open([scene.width, scene.height], true);
    translate::state(gl.as_mut(), &scene);
    let (w, h) = (scene.width as usize, scene.height as usize);
    let blank = || vec![[0.0f32; 4]; w * h];
    let (mut square, mut gauss) = (vec![[0.0f64; 3]; w * h], blank());
    let offset = |i: u32| (f64::from(i) + 0.5) / f64::from(k) - 0.5;
    for i in 0..k {
        let mut column = blank();
        for j in 0..k {
            let samples = sample(gl.as_mut(), &scene, [offset(i), offset(j)]);
            for (sum, s) in square.iter_mut().zip(&samples) {
                *sum = std::array::from_fn(|c| sum[c] + f64::from(s[c]));
            }
            spread(&samples, &mut column, gaussian(offset(j)), w, h);
        }
        spread(&column, &mut gauss, gaussian(offset(i)), 1, w);
    }
    let n = f64::from(k * k);
    let square = square.iter().map(|s| [s[0], s[1], s[2], n].map(|v| (v * 255.0 / n) as f32)).collect();
    let gauss = gauss.iter().map(|s| [s[0], s[1], s[2], s[3]].map(|v| v * 255.0 / s[3])).collect();
    Filtered { square, gauss }
}

/// The scene at the points that lie (x, y) from the centres of the pixels; the fourth number is 1.
fn sample(gl: &mut dyn Gl, scene: &Scene, [x, y]: [f64; 2]) -> Vec<[f32; 4]> {
    translate::projection(gl, scene, [-x, -y]);
    translate::picture(gl);
    let mut samples = gl.floats();
    samples.iter_mut().for_each(|s| s[3] = 1.0);
    samples
}

/// The root of the mean square of the difference of two ideals over R, G and B.
pub fn distance(a: &Ideal, b: &Ideal) -> f64 {
    let squares = a.iter().zip(b).flat_map(|(p, q)| (0..3).map(move |c| f64::from(p[c] - q[c]).powi(2)));
    (squares.sum::<f64>() / (3.0 * a.len().max(1) as f64)).sqrt()
}

/// The distance of the samplings k and k / 2, for the square and for the Gaussian.
#[derive(Clone, Copy, Debug)]
pub struct Convergence {
    /// Samples along a side of a pixel.
    pub k: u32,
    /// The distances in LSB.
    pub square: f64,
    pub gauss: f64,
}

/// The ideal with `k` x `k` samples and how it has converged.
pub fn converged(ours: &Ours, scene: &Scene, k: u32) -> (Filtered, Vec<Convergence>) {
    let (mut previous, mut steps) = (filtered(ours, scene, k / 4), Vec::new());
    for k in [k / 2, k] {
        let next = filtered(ours, scene, k);
        let square = distance(&next.square, &previous.square);
        steps.push(Convergence { k, square, gauss: distance(&next.gauss, &previous.gauss) });
        previous = next;
    }
    (previous, steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gaussian_spreads_a_point_and_keeps_a_flat_picture() {
        let (w, h) = (7, 6);
        let mut point = vec![[0.0f32, 0.0, 0.0, 1.0]; w * h];
        point[3 * w + 3][0] = 1.0;
        let (mut column, mut both) = (vec![[0.0f32; 4]; w * h], vec![[0.0f32; 4]; w * h]);
        spread(&point, &mut column, gaussian(0.0), w, h);
        spread(&column, &mut both, gaussian(0.0), 1, w);
        let side = (-2.0f32).exp();
        let at = |x: usize, y: usize| both[y * w + x];
        assert!((at(3, 3)[0] - 1.0).abs() < 1e-6 && (at(2, 3)[0] - side).abs() < 1e-6);
        assert!((at(4, 2)[0] - side * side).abs() < 1e-6 && (at(3, 0)[0]).abs() < 1e-6);
        // The weights at a corner are those that fall inside: 3 x 3 of 5 x 5.
        let half = 1.0 + side + (-8.0f32).exp();
        assert!((at(0, 0)[3] - half * half).abs() < 1e-5);
        assert!((gaussian(0.5)[0] - (-4.5f32).exp()).abs() < 1e-7 && gaussian(0.5)[4] == 0.0);
    }
}
