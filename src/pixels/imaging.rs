//! What the imaging subset does to groups of colours (OpenGL 1.5, section 3.6.5): lookup in a colour table, convolution,
//! histogram and minmax, as functions on rows and images of f32 colours.

use super::zoom::zeroed;
use crate::error::Outcome;
use crate::num::clamp01;
use crate::state::imaging::ConvolutionBorder;

/// An image of colours, row by row.
#[derive(Clone, Debug, Default)]
pub struct ColorImage {
    pub size: [usize; 2],
    pub colors: Vec<[f32; 4]>,
}

impl ColorImage {
    /// Its size with slices below each other.
    #[must_use]
    pub fn size_3d(&self, depth: i32) -> [i32; 3] {
        let [width, height] = self.size.map(|n| i32::try_from(n).unwrap_or(i32::MAX));
        [width, if depth > 0 { height / depth } else { height }, depth]
    }
}

/// The entry of a table of `len` entries that a component selects: its fraction of the range, rounded to the nearest.
fn entry(component: f32, len: usize) -> usize {
    let last = len.saturating_sub(1);
    ((clamp01(component) * last as f32).round_ties_even() as usize).min(last)
}

/// Replaces components by those of a table's entries that they select. A table without entries replaces none.
pub fn look_up(entries: &[[f32; 4]], replaces: [bool; 4], colors: &mut [[f32; 4]]) {
    for color in colors {
        for c in (0..4).filter(|c| replaces[*c]) {
            if let Some(found) = entries.get(entry(color[c], entries.len())) {
                color[c] = found[c];
            }
        }
    }
}

/// A convolution filter.
#[derive(Clone, Debug, Default)]
pub struct Kernel {
    pub size: [usize; 2],
    /// Row by row.
    pub weights: Vec<[f32; 4]>,
    /// Which components it filters; the others are those of the group in its middle.
    pub filters: [bool; 4],
}

impl Kernel {
    /// The product of a row and a column.
    #[must_use]
    pub fn separable(row: &[[f32; 4]], column: &[[f32; 4]], filters: [bool; 4]) -> Self {
        let weights = column.iter().flat_map(|b| row.iter().map(|a| std::array::from_fn(|c| a[c] * b[c]))).collect();
        Self { size: [row.len(), column.len()], weights, filters }
    }
}

/// The image filtered. With [`ConvolutionBorder::Reduce`] it is smaller by the filter's size less one.
pub fn convolve(
    image: &ColorImage,
    kernel: &Kernel,
    border: ConvolutionBorder,
    border_color: [f32; 4],
) -> Outcome<ColorImage> {
    let [width, height] = image.size;
    let ([kw, kh], middle) = (kernel.size, kernel.size.map(|n| n / 2));
    if kw == 0 || kh == 0 {
        return Ok(image.clone());
    }
    let reduces = border == ConvolutionBorder::Reduce;
    let size = if reduces { [(width + 1).saturating_sub(kw), (height + 1).saturating_sub(kh)] } else { image.size };
    // The first group of the filter, less the place of the result.
    let shift = if reduces { [0, 0] } else { middle };
    let at = |x: isize, y: isize| -> [f32; 4] {
        let inside = |v: isize, n: usize| usize::try_from(v).ok().filter(|v| *v < n);
        let limited = |v: isize, n: usize| v.clamp(0, n as isize - 1) as usize;
        match (inside(x, width), inside(y, height), border) {
            (Some(x), Some(y), _) => image.colors[y * width + x],
            (.., ConvolutionBorder::Replicate) => image.colors[limited(y, height) * width + limited(x, width)],
            (.., ConvolutionBorder::Constant | ConvolutionBorder::Reduce) => border_color,
        }
    };
    let mut colors: Vec<[f32; 4]> = zeroed(size[0] * size[1])?;
    for (i, out) in colors.iter_mut().enumerate() {
        let [x, y] = [i % size[0], i / size[0]];
        let first = [x as isize - shift[0] as isize, y as isize - shift[1] as isize];
        let mut sum = [0.0; 4];
        for (m, row) in kernel.weights.chunks_exact(kw).enumerate() {
            for (n, weight) in row.iter().enumerate() {
                let color = at(first[0] + n as isize, first[1] + m as isize);
                for c in 0..4 {
                    sum[c] += color[c] * weight[c];
                }
            }
        }
        let kept = at(first[0] + middle[0] as isize, first[1] + middle[1] as isize);
        *out = std::array::from_fn(|c| if kernel.filters[c] { sum[c] } else { kept[c] });
    }
    Ok(ColorImage { size, colors })
}

/// Counts in which entry of a histogram each component falls.
pub fn count(bins: &mut [[u32; 4]], counts: [bool; 4], colors: &[[f32; 4]]) {
    let len = bins.len();
    for color in colors {
        for c in (0..4).filter(|c| counts[*c]) {
            if let Some(bin) = bins.get_mut(entry(color[c], len)) {
                bin[c] = bin[c].saturating_add(1);
            }
        }
    }
}

/// Widens the range of each component by colours.
pub fn widen([least, greatest]: &mut [[f32; 4]; 2], colors: &[[f32; 4]]) {
    for color in colors {
        for c in 0..4 {
            if color[c] < least[c] {
                least[c] = color[c];
            }
            if color[c] > greatest[c] {
                greatest[c] = color[c];
            }
        }
    }
}
