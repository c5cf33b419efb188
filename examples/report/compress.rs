//! What TEXTURE_COMPRESSION_HINT could choose between: this crate's S3TC encoder, which is asked through TexImage2D, and a
//! prototype of a slower one. A DXT1 block has two colours and two mixtures of them. The prototype starts from the two
//! colours that lie farthest apart, and twice solves for the pair that fits the texels best (least squares) given what
//! each texel has chosen.

use super::oracle::fragment::to_byte;
use super::oracle::texel::Image;

type Rgb = [f64; 3];

fn distance2(a: Rgb, b: Rgb) -> f64 {
    (0..3).map(|c| (a[c] - b[c]).powi(2)).sum()
}

/// What 5, 6 and 5 bits keep of a colour.
fn to_565(c: Rgb) -> Rgb {
    let bits = [31.0, 63.0, 31.0];
    std::array::from_fn(|k| (c[k].clamp(0.0, 255.0) / 255.0 * bits[k]).round() / bits[k] * 255.0)
}

/// The four colours of a block, with the share of the first in each.
const SHARES: [f64; 4] = [1.0, 2.0 / 3.0, 1.0 / 3.0, 0.0];

fn palette([a, b]: [Rgb; 2]) -> [Rgb; 4] {
    let (a, b) = (to_565(a), to_565(b));
    SHARES.map(|t| std::array::from_fn(|c| t * a[c] + (1.0 - t) * b[c]))
}

fn choose(texels: &[Rgb; 16], ends: [Rgb; 2]) -> ([usize; 16], f64) {
    let palette = palette(ends);
    let best = |t: Rgb| {
        let nearest = |&a: &usize, &b: &usize| distance2(t, palette[a]).total_cmp(&distance2(t, palette[b]));
        (0..4).min_by(nearest).unwrap_or(0)
    };
    let choice = texels.map(best);
    (choice, (0..16).map(|i| distance2(texels[i], palette[choice[i]])).sum())
}

/// The pair of colours that fits what the texels have chosen, if it is determined.
fn fit(texels: &[Rgb; 16], choice: &[usize; 16]) -> Option<[Rgb; 2]> {
    let (mut aa, mut ab, mut bb, mut at, mut bt) = (0.0, 0.0, 0.0, [0.0; 3], [0.0; 3]);
    for (texel, &k) in texels.iter().zip(choice) {
        let (s, r) = (SHARES[k], 1.0 - SHARES[k]);
        (aa, ab, bb) = (aa + s * s, ab + s * r, bb + r * r);
        at = std::array::from_fn(|c| at[c] + s * texel[c]);
        bt = std::array::from_fn(|c| bt[c] + r * texel[c]);
    }
    let det = aa * bb - ab * ab;
    let solve = |x: f64, y: f64, p: f64, q: f64| (p * x - q * y) / det;
    (det.abs() > 1e-9).then(|| {
        [std::array::from_fn(|c| solve(at[c], bt[c], bb, ab)), std::array::from_fn(|c| solve(bt[c], at[c], aa, ab))]
    })
}

/// The squared error of a block after `rounds` of fitting.
fn block(texels: &[Rgb; 16], rounds: u32) -> f64 {
    let pairs = (0..16).flat_map(|i| (i + 1..16).map(move |j| [texels[i], texels[j]]));
    let mut ends = pairs.max_by(|p, q| distance2(p[0], p[1]).total_cmp(&distance2(q[0], q[1]))).unwrap_or_default();
    let (mut choice, mut error) = choose(texels, ends);
    for _ in 0..rounds {
        let Some(next) = fit(texels, &choice) else { break };
        let (c, e) = choose(texels, next);
        if e >= error {
            break;
        }
        (ends, choice, error) = (next, c, e);
    }
    let _ = ends;
    error
}

/// Root of the mean square error over R, G and B of an image as DXT1 blocks, in LSB.
pub fn prototype(image: &Image, rounds: u32) -> f64 {
    let [w, h, _] = image.size;
    let mut sum = 0.0;
    for y in (0..h).step_by(4) {
        for x in (0..w).step_by(4) {
            let texel = |i: usize| -> Rgb {
                let c = image.texel([x + (i as i64 & 3), y + (i as i64 >> 2), 0]).unwrap_or_default();
                std::array::from_fn(|k| f64::from(to_byte(c[k])))
            };
            sum += block(&std::array::from_fn(texel), rounds);
        }
    }
    (sum / (3 * w * h) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_colours_that_fit_are_kept() {
        let texels: [Rgb; 16] =
            std::array::from_fn(|i| if i % 3 == 0 { [255.0, 0.0, 255.0] } else { [0.0, 255.0, 0.0] });
        assert!(block(&texels, 0) < 1e-9);
    }

    #[test]
    fn fitting_never_makes_it_worse() {
        let texels: [Rgb; 16] = std::array::from_fn(|i| {
            let v = i as f64 * 16.0;
            [v, 255.0 - v * 0.7, (v * 7.0) % 255.0]
        });
        assert!(block(&texels, 3) <= block(&texels, 0));
        // A ramp between two grey ends: the fit gives the ends back.
        let ramp: [Rgb; 16] = std::array::from_fn(|i| palette([[0.0; 3], [255.0; 3]])[i % 4]);
        let (choice, error) = choose(&ramp, [[0.0; 3], [255.0; 3]]);
        assert!(error < 1e-9);
        let ends = fit(&ramp, &choice).unwrap();
        assert!(distance2(ends[0], [0.0; 3]) < 1e-9 && distance2(ends[1], [255.0; 3]) < 1e-9);
    }
}
