//! The masks of a batch of small triangles, a triangle a lane (OpenGL 1.5, section 3.5.1): the rule of [`edges`], for
//! pixels within 8 by 8 of a triangle's bounding box. The four columns of a row are the 16-bit digits of a u64, each with
//! 2^15 added to its edge function, so that a digit's top bit says "not negative" and one addition goes on to the next
//! row of all four.
//!
//! No digit leaves 0..2^16: |E| / 256 is at most the area of the square that holds triangle and pixels, in 1/256 pixel over
//! 256, which is below 23,700 (9.6 pixels squared).
//!
//! [`edges`]: crate::raster::coverage::edges

use super::lanes::I32x16;
use crate::fragment::planes::GROUP;

const ONES: u64 = 0x0001_0001_0001_0001;
const COUNT: u64 = 0x0003_0002_0001_0000;
const TOP: u64 = 0x8000_8000_8000_8000;

/// The edge function of a lane, E = b (y - py) + a (x - px) in 1/256 of the grid's unit: a, b and E at the pixel `first`. The edge runs between two corners of a triangle that winds counter-clockwise where `turn` is 0; where it is
/// all ones, the triangle winds clockwise and the edge runs the other way.
#[inline(always)]
pub(crate) fn edge_function(
    p: &[I32x16; 2],
    q: &[I32x16; 2],
    turn: &I32x16,
    first: &[I32x16; 2],
    i: usize,
) -> [i32; 3] {
    // E is 0 on the whole edge, so p may be either end.
    let (a, b) = (p[1][i] - q[1][i], q[0][i] - p[0][i]);
    let (a, b) = ((a ^ turn[i]) - turn[i], (b ^ turn[i]) - turn[i]);
    let (x, y) = ((first[0][i] << 8) + 128 - p[0][i], (first[1][i] << 8) + 128 - p[1][i]);
    let inclusive = (a > 0) | ((a == 0) & (b < 0));
    let c = b.wrapping_mul(y).wrapping_add(a.wrapping_mul(x)).wrapping_sub(i32::from(!inclusive)) >> 8;
    [a, b, c]
}

/// All ones where a triangle winds clockwise.
#[inline(always)]
pub(crate) fn turns(area: &I32x16) -> I32x16 {
    let mut turn = [0; GROUP];
    for i in 0..GROUP {
        turn[i] = area[i] >> 31;
    }
    turn
}

/// An edge of each triangle: its function at the first four pixels of a row, and its change to the next row.
struct MaskEdges {
    row: [u64; GROUP],
    /// What a step of four columns to the right adds.
    right: [u64; GROUP],
    /// What a step of one row up adds.
    up: [u64; GROUP],
}

impl MaskEdges {
    /// The edge between two corners, as [`edge_function`] has it. `first` is the pixel where masks begin.
    #[inline(always)]
    fn new(p: &[I32x16; 2], q: &[I32x16; 2], turn: &I32x16, first: &[I32x16; 2]) -> Self {
        let mut edge = Self { row: [0; GROUP], right: [0; GROUP], up: [0; GROUP] };
        for i in 0..GROUP {
            let [a, b, c] = edge_function(p, q, turn, first, i);
            let digits = |v: i32| (i64::from(v) as u64).wrapping_mul(ONES);
            edge.row[i] = digits(c + 0x8000).wrapping_add((i64::from(a) as u64).wrapping_mul(COUNT));
            edge.right[i] = digits(4 * a);
            edge.up[i] = digits(b);
        }
        edge
    }

    #[inline(always)]
    fn go_right(&mut self) {
        for i in 0..GROUP {
            self.row[i] = self.row[i].wrapping_add(self.right[i]);
        }
    }
}

/// Four columns of all masks: bit (16 column + row + `at`) is set where all three functions are not negative.
#[inline(always)]
fn columns([e0, e1, e2]: &[MaskEdges; 3], rows: u32, at: u32, out: &mut [u64; GROUP]) {
    let (mut r0, mut r1, mut r2) = (e0.row, e1.row, e2.row);
    for j in 0..rows.min(8) {
        let down = 15 - at - j;
        for i in 0..GROUP {
            out[i] |= (r0[i] & r1[i] & r2[i] & TOP) >> down;
            r0[i] = r0[i].wrapping_add(e0.up[i]);
            r1[i] = r1[i].wrapping_add(e1.up[i]);
            r2[i] = r2[i].wrapping_add(e2.up[i]);
        }
    }
}

/// Exchanges the bits under `mask` with those `by` places above.
#[inline(always)]
fn exchange(x: u64, mask: u64, by: u32) -> u64 {
    let t = (x ^ (x >> by)) & mask;
    x ^ t ^ (t << by)
}

/// From bit (16 (column mod 4) + 8 (column / 4) + row) to bit (8 row + column).
#[inline(always)]
fn in_rows(x: u64) -> u64 {
    let x = exchange(x, 0x00AA_00AA_00AA_00AA, 7);
    let x = exchange(x, 0x0000_CCCC_0000_CCCC, 14);
    let x = exchange(x, 0x0000_0000_F0F0_F0F0, 28);
    // Now each row's byte has bit (2 (column mod 4) + column / 4).
    exchange(exchange(x, 0x2222_2222_2222_2222, 1), 0x0C0C_0C0C_0C0C_0C0C, 2)
}

/// The covered pixels of triangles by their corners' snapped positions, bit (8 row + column) from the pixel `first` on,
/// which is the first one of the bounding box. `area` is positive where a triangle winds counter-clockwise; `width` and
/// `height` are those of the largest bounding box, at most 8.
#[inline(always)]
pub(crate) fn masks(
    p: &[[I32x16; 2]; 3],
    area: &I32x16,
    first: &[I32x16; 2],
    [width, height]: [u32; 2],
    out: &mut [u64; GROUP],
) {
    let turn = turns(area);
    let mut edges = [
        MaskEdges::new(&p[0], &p[1], &turn, first),
        MaskEdges::new(&p[1], &p[2], &turn, first),
        MaskEdges::new(&p[2], &p[0], &turn, first),
    ];
    *out = [0; GROUP];
    columns(&edges, height, 0, out);
    if width > 4 {
        edges.iter_mut().for_each(MaskEdges::go_right);
        columns(&edges, height, 8, out);
    }
    for i in 0..GROUP {
        out[i] = in_rows(out[i]);
    }
}
