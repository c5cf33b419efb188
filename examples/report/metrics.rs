//! How far a picture is from another: the greatest error of a channel, its root mean square, the peak signal-to-noise
//! ratio, the share of pixels that are off by more than 1 LSB, the error that one pixel in a thousand exceeds, and the
//! structural similarity (Wang, Bovik, Sheikh and Simoncelli 2004: means, variances and covariance under a Gaussian of
//! 11 x 11). LSB are steps of an 8-bit channel.

/// Colours in LSB, rows from the bottom: what a picture ought to be.
pub type Ideal = Vec<[f32; 4]>;

/// The figures of one comparison.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Error {
    /// The greatest error of a channel, in LSB.
    pub max: f64,
    /// Root of the mean square over R, G and B.
    pub rmse: f64,
    /// 20 log10(255 / rmse).
    pub psnr: f64,
    /// The share of pixels with a byte that is more than 1 away from the rounded ideal.
    pub off: f64,
    /// What a thousandth of the pixels exceeds.
    pub p999: f64,
    /// How many pixels were compared.
    pub pixels: usize,
}

/// The value that a thousandth of the numbers exceeds.
pub fn p999(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let place = (values.len() as f64 * 0.999).ceil() as usize;
    values.get(place.saturating_sub(1)).copied().unwrap_or(0.0)
}

/// The decibels of a root mean square of LSB.
pub fn psnr(rmse: f64) -> f64 {
    if rmse == 0.0 { f64::INFINITY } else { 20.0 * (255.0 / rmse).log10() }
}

impl Error {
    /// Compares the pixels that `counts` says yes to.
    pub fn of(picture: &[[u8; 4]], ideal: &[[f32; 4]], counts: impl Fn(usize) -> bool) -> Error {
        let (mut squares, mut off, mut worst) = (0.0, 0, Vec::new());
        let pairs = picture.iter().zip(ideal).enumerate();
        for (_, (got, want)) in pairs.filter(|(i, _)| counts(*i)) {
            let error = |c: usize| (f64::from(got[c]) - f64::from(want[c])).abs();
            squares += (0..3).map(|c| error(c).powi(2)).sum::<f64>();
            off += usize::from((0..3).any(|c| (f64::from(got[c]) - f64::from(want[c].round())).abs() > 1.0));
            worst.push((0..3).map(error).fold(0.0, f64::max));
        }
        let n = worst.len().max(1) as f64;
        let rmse = (squares / (3.0 * n)).sqrt();
        Error {
            max: worst.iter().copied().fold(0.0, f64::max),
            rmse,
            psnr: psnr(rmse),
            off: off as f64 / n,
            pixels: worst.len(),
            p999: p999(worst),
        }
    }
}

/// What a pixel weighs in brightness.
fn luma(c: [f32; 4]) -> f64 {
    0.299 * f64::from(c[0]) + 0.587 * f64::from(c[1]) + 0.114 * f64::from(c[2])
}

/// A plane of numbers under a Gaussian of sigma 1.5, 11 x 11; only places where the whole of it fits.
fn blurred(plane: &[f64], [width, height]: [usize; 2]) -> Vec<f64> {
    let weights: [f64; 11] = std::array::from_fn(|i| (-(i as f64 - 5.0).powi(2) / 4.5).exp());
    let sum: f64 = weights.iter().sum();
    let weights = weights.map(|w| w / sum);
    let (w, h) = (width - 10, height - 10);
    let mut rows = vec![0.0; w * height];
    for (i, to) in rows.iter_mut().enumerate() {
        let at = i / w * width + i % w;
        *to = weights.iter().zip(&plane[at..]).map(|(a, b)| a * b).sum();
    }
    (0..w * h).map(|i| weights.iter().enumerate().map(|(k, a)| a * rows[i + k * w]).sum()).collect()
}

/// The mean structural similarity of the brightness of two pictures: 1 for equal ones.
pub fn ssim(a: &[[f32; 4]], b: &[[f32; 4]], [width, height]: [u32; 2]) -> f64 {
    let size = [width as usize, height as usize];
    if size[0] < 11 || size[1] < 11 {
        return 1.0;
    }
    let (a, b): (Vec<f64>, Vec<f64>) = (a.iter().map(|&c| luma(c)).collect(), b.iter().map(|&c| luma(c)).collect());
    let product = |x: &[f64], y: &[f64]| blurred(&x.iter().zip(y).map(|(p, q)| p * q).collect::<Vec<_>>(), size);
    let (ma, mb) = (blurred(&a, size), blurred(&b, size));
    let (aa, bb, ab) = (product(&a, &a), product(&b, &b), product(&a, &b));
    let (c1, c2) = ((0.01f64 * 255.0).powi(2), (0.03f64 * 255.0).powi(2));
    let at = |i: usize| {
        let (m, n) = (ma[i], mb[i]);
        let (va, vb, cov) = (aa[i] - m * m, bb[i] - n * n, ab[i] - m * n);
        (2.0 * m * n + c1) * (2.0 * cov + c2) / ((m * m + n * n + c1) * (va + vb + c2))
    };
    (0..ma.len()).map(at).sum::<f64>() / ma.len() as f64
}

/// Bytes as the colours that `ssim` takes.
pub fn as_floats(picture: &[[u8; 4]]) -> Ideal {
    picture.iter().map(|c| c.map(f32::from)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_those_worked_out_by_hand() {
        // Errors of 0, 0.5 (a rounding) and 3 in one channel each.
        let ideal = vec![[10.0, 20.0, 30.0, 0.0], [10.5, 20.0, 30.0, 0.0], [10.0, 23.0, 30.0, 0.0]];
        let picture = [[10, 20, 30, 255]; 3];
        let e = Error::of(&picture, &ideal, |_| true);
        assert_eq!((e.max, e.pixels), (3.0, 3));
        assert!((e.rmse - (9.25f64 / 9.0).sqrt()).abs() < 1e-12);
        assert!((e.off - 1.0 / 3.0).abs() < 1e-12);
        assert!((e.psnr - 20.0 * (255.0 / e.rmse).log10()).abs() < 1e-12);
        assert_eq!(Error::of(&picture, &ideal, |i| i == 0).max, 0.0);
        // 10.5 is rounded up to 11: a byte of 10 is 1 away, which is not more than 1; one of 9 would be.
        assert_eq!(Error::of(&picture[..1], &ideal[1..2], |_| true).off, 0.0);
        assert_eq!(Error::of(&[[9, 20, 30, 255]], &ideal[1..2], |_| true).off, 1.0);
    }

    #[test]
    fn the_worst_in_a_thousand_is_left_out() {
        let values: Vec<f64> = (1..=2000).map(f64::from).collect();
        assert_eq!(p999(values), 1998.0);
        assert_eq!((p999(vec![7.0]), p999(Vec::new())), (7.0, 0.0));
        assert_eq!((psnr(0.0), psnr(255.0)), (f64::INFINITY, 0.0));
    }

    #[test]
    fn similarity_is_one_for_the_same_and_negative_for_the_opposite() {
        let size = [32, 24];
        let wave = |phase: f32| -> Ideal {
            (0..32 * 24).map(|i| [128.0 + 100.0 * ((i % 32) as f32 * 0.7 + phase).sin(); 4]).collect()
        };
        let (a, b) = (wave(0.0), wave(std::f32::consts::PI));
        assert!((ssim(&a, &a, size) - 1.0).abs() < 1e-12);
        // Opposite phase: the covariance is minus the variance.
        assert!(ssim(&a, &b, size) < -0.5);
        let brighter: Ideal = a.iter().map(|c| c.map(|v| v + 10.0)).collect();
        let s = ssim(&a, &brighter, size);
        // Only the first factor changes: (2 m n + c1) / (m^2 + n^2 + c1) with n = m + 10, near m = 128.
        assert!(s > 0.98 && s < 1.0, "{s}");
        // Two flat pictures of 100 and 110: (22000 + 6.5025) / (22100 + 6.5025).
        let flat = |v: f32| vec![[v; 4]; 32 * 24];
        let want = (2.0 * 100.0 * 110.0 + 6.5025) / (100.0 * 100.0 + 110.0 * 110.0 + 6.5025);
        assert!((ssim(&flat(100.0), &flat(110.0), size) - want).abs() < 1e-6);
    }
}
