//! Tests of the buffers: bands, clears, rows, the client's memory, the accumulation buffer.

use super::*;
use crate::enums::{GL_INVALID_OPERATION, GL_INVALID_VALUE, GL_OUT_OF_MEMORY};

fn format() -> FramebufferFormat {
    FramebufferFormat::default()
}

fn color(c: [f32; 4]) -> Clear {
    Clear { color: Some((c, [true; 4])), ..Clear::default() }
}

fn row(f: &Framebuffer, y: i32) -> Vec<u32> {
    let mut out = vec![0xDEAD_BEEF; f.width() as usize];
    f.read_rgba8(0, y, &mut out);
    out
}

#[test]
fn a_new_framebuffer_is_black_and_far() {
    let f = Framebuffer::new(5, 3, format()).unwrap();
    let (mut d, mut s) = ([0.0; 5], [9; 5]);
    f.read_depth(0, 2, &mut d);
    f.read_stencil(0, 2, &mut s);
    assert_eq!((row(&f, 2), d, s), (vec![0; 5], [1.0; 5], [0; 5]));
    let opaque = Framebuffer::new(1, 1, FramebufferFormat { color_bits: [8, 8, 8, 0], ..format() }).unwrap();
    assert_eq!(row(&opaque, 0), [0xFF00_0000]);
    assert_eq!(
        [0, 16, 24, 32].map(|depth_bits| FramebufferFormat { depth_bits, ..format() }.depth_max()),
        [0, 0xFFFF, 0xFF_FFFF, u32::MAX]
    );
}

#[test]
fn absurd_sizes_are_errors() {
    let code = |w, h| Framebuffer::new(w, h, format()).map(|_| ()).unwrap_err().code;
    assert_eq!(code(MAX_VIEWPORT_DIM + 1, 1), GL_INVALID_VALUE);
    assert_eq!(code(1, u32::MAX), GL_INVALID_VALUE);
    assert!(Framebuffer::new(0, 0, format()).is_ok());
    assert!(Framebuffer::new(0, 7, format()).unwrap().bands(2).iter().all(|b| b.rgba8.is_empty()));
    let mut memory = vec![0u32; 12];
    let mut with = |width, row_length, len| {
        #[expect(unsafe_code, reason = "memory of the test")]
        // SAFETY: the vector outlives the framebuffer, which is dropped at once, and has at least `len` pixels.
        let memory = unsafe { UserMemory::new(memory.as_mut_ptr(), len) }.unwrap();
        Framebuffer::with_user_memory(width, 3, row_length, false, format(), memory).map(|_| ()).map_err(|e| e.code)
    };
    assert_eq!(with(4, 4, 12), Ok(()));
    assert_eq!(with(2, 5, 12), Ok(()), "the last row may be short");
    assert_eq!(with(4, 4, 11), Err(GL_INVALID_VALUE));
    assert_eq!(with(4, 3, 12), Err(GL_INVALID_VALUE));
    assert_eq!(with(4, u32::MAX, 12), Err(GL_OUT_OF_MEMORY));
    #[expect(unsafe_code, reason = "addresses that are refused")]
    // SAFETY: neither address is ever read.
    let refused = unsafe {
        let odd = memory.as_mut_ptr().cast::<u8>().wrapping_add(1).cast::<u32>();
        UserMemory::new(std::ptr::null_mut(), 3).is_none() && UserMemory::new(odd, 1).is_none()
    };
    assert!(refused);
}

#[test]
fn bands_cover_every_row_once() {
    for flipped in [false, true] {
        for (height, rows) in [(10, 3), (9, 3), (1, 8), (7, 1), (6, 0)] {
            let mut memory = vec![0u32; 8 * height as usize];
            #[expect(unsafe_code, reason = "memory of the test")]
            // SAFETY: the vector outlives the framebuffer and is not touched meanwhile.
            let client = unsafe { UserMemory::new(memory.as_mut_ptr(), memory.len()) }.unwrap();
            let mut f = Framebuffer::with_user_memory(5, height, 8, flipped, format(), client).unwrap();
            let mut y = 0;
            for band in f.bands(rows) {
                assert_eq!(band.y0, y);
                assert_eq!(y / rows.max(1) * rows.max(1), y, "row y is in band y / rows");
                for row in y..y + band.rows {
                    for x in 0..5 {
                        band.rgba8[band.offset(x, row) as usize] += row * 10 + x + 1;
                        band.depth[band.offset(x, row) as usize] = row;
                        band.stencil[band.offset(x, row) as usize] += 1;
                    }
                }
                y += band.rows;
            }
            assert_eq!(y, height);
            for y in 0..height {
                assert_eq!(row(&f, y as i32), (0..5).map(|x| y * 10 + x + 1).collect::<Vec<_>>());
                let mut d = [0.0; 5];
                f.read_depth(0, y as i32, &mut d);
                assert_eq!(d, [f64::from(y) / 16_777_215.0; 5]);
            }
            let band = f.band();
            assert_eq!((band.y0, band.rows, band.samples), (0, height, 0));
            let at = band.offset(4, height - 1) as usize;
            assert_eq!(band.rgba8[at], (height - 1) * 10 + 5);
            band.rgba8[at] = 77;
            drop(f);
            let top = if flipped { 0 } else { height as usize - 1 };
            assert_eq!(memory[top * 8 + 4], 77, "the client sees it, flipped {flipped}");
            assert!(memory.iter().skip(5).step_by(8).all(|p| *p == 0), "nothing between the rows is touched");
        }
    }
}

#[test]
fn clears_are_masked_and_cut() {
    let mut f = Framebuffer::new(6, 4, format()).unwrap();
    f.clear(&color([1.0, 0.5, 0.2, 2.0]), None).unwrap();
    assert_eq!(row(&f, 3), [0xFF33_80FF; 6]);
    let rect = f.rect(-2, 1, 5, 2);
    assert_eq!(rect, Rect { x: 0, y: 1, width: 3, height: 2 });
    let clear = Clear {
        color: Some(([0.0; 4], [false, true, false, true])),
        depth: Some(0.25),
        stencil: Some((0xFF, 0x3C)),
        accum: None,
    };
    f.clear(&clear, Some(rect)).unwrap();
    assert_eq!(row(&f, 1), [0x0033_00FF, 0x0033_00FF, 0x0033_00FF, 0xFF33_80FF, 0xFF33_80FF, 0xFF33_80FF]);
    assert_eq!((row(&f, 0), row(&f, 3)), (vec![0xFF33_80FF; 6], vec![0xFF33_80FF; 6]));
    let (mut d, mut s) = ([0.0; 6], [0; 6]);
    f.read_depth(0, 2, &mut d);
    f.read_stencil(0, 2, &mut s);
    assert_eq!(d, [4_194_304.0 / 16_777_215.0; 3].into_iter().chain([1.0; 3]).collect::<Vec<_>>()[..]);
    assert_eq!(s, [0x3C, 0x3C, 0x3C, 0, 0, 0]);
    for (depth, want) in [(f64::NAN, 0), (-1.0, 0), (2.0, 16_777_215), (0.5, 8_388_608)] {
        assert_eq!(f.depth_value(depth), want, "{depth}");
    }
    // Boxes outside, empty and huge ones.
    for (x, y, w, h) in [(6, 0, 5, 5), (-9, -9, 9, 9), (0, 0, 0, 3), (i32::MAX, i32::MAX, i32::MAX, i32::MAX)] {
        let rect = f.rect(x, y, w, h);
        assert!(rect.width == 0 || rect.height == 0);
        f.clear(&color([0.0; 4]), Some(rect)).unwrap();
    }
    let beyond = Rect { x: 99, y: 99, width: u32::MAX, height: u32::MAX };
    f.clear(&color([0.0; 4]), Some(beyond)).unwrap();
    assert_eq!(row(&f, 3), [0xFF33_80FF; 6]);
}

#[test]
fn clears_leave_what_lies_behind_the_window_alone() {
    let mut memory = vec![5u32; 20];
    #[expect(unsafe_code, reason = "memory of the test")]
    // SAFETY: the vector outlives the framebuffer and is not touched meanwhile.
    let client = unsafe { UserMemory::new(memory.as_mut_ptr(), memory.len()) }.unwrap();
    let mut f = Framebuffer::with_user_memory(4, 3, 4, false, format(), client).unwrap();
    f.clear(&color([0.0; 4]), None).unwrap();
    drop(f);
    assert_eq!((memory[..12].to_vec(), memory[12..].to_vec()), (vec![0; 12], vec![5; 8]));
}

#[test]
fn alpha_that_is_not_there_stays_one() {
    for float in [false, true] {
        let format = FramebufferFormat { color_bits: [8, 8, 8, 0], float, ..format() };
        let mut f = Framebuffer::new(2, 1, format).unwrap();
        f.clear(&color([0.0; 4]), None).unwrap();
        f.write_float(0, 0, &[[1.0, 0.0, 0.0, 0.25]], [true; 4]);
        let mut out = [[0.0; 4]; 2];
        f.read_float(0, 0, &mut out);
        assert_eq!(out, [[1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.0, 1.0]]);
    }
}

#[test]
fn rows_may_reach_over_the_edges() {
    let mut f = Framebuffer::new(3, 2, format()).unwrap();
    let red = [1.0, 0.0, 0.0, 1.0];
    f.write_float(-1, 1, &[red, [0.0, 1.0, 0.0, 0.0], red, red, red], [true, false, true, true]);
    let mut out = [7u32; 6];
    f.read_rgba8(-2, 1, &mut out);
    assert_eq!(out, [7, 7, 0, 0xFF00_00FF, 0xFF00_00FF, 7]);
    for (x, y) in [(0, -1), (0, 2), (3, 0), (i32::MAX, 0), (i32::MIN, 1), (0, i32::MAX)] {
        let mut out = [7u32; 2];
        f.read_rgba8(x, y, &mut out);
        f.write_stencil(x, y, &[1, 1], 0xFF);
        f.write_depth(x, y, &[0.5, 0.5].map(|depth| f.format().quantised_depth(depth)));
        assert_eq!(out, [7, 7]);
    }
    f.write_depth(1, 0, &[0.5, f64::NAN].map(|depth| f.format().quantised_depth(depth)));
    f.write_stencil(0, 0, &[0xFF, 0x0F, 0xAA], 0x3C);
    let (mut d, mut s) = ([0.0; 3], [0; 3]);
    f.read_depth(0, 0, &mut d);
    f.read_stencil(0, 0, &mut s);
    assert_eq!((d, s), ([1.0, 8_388_608.0 / 16_777_215.0, 0.0], [0x3C, 0x0C, 0x28]));
}

#[test]
fn accumulation_keeps_what_it_adds() {
    for float in [false, true] {
        let mut f = Framebuffer::new(4, 2, FramebufferFormat { float, ..format() }).unwrap();
        let all = f.rect(0, 0, 4, 2);
        f.clear(&Clear { accum: Some([0.0; 4]), ..Clear::default() }, None).unwrap();
        for i in 0..64u8 {
            let level = f32::from(i * 4) / 255.0;
            f.clear(&color([level, 1.0, 0.0, 1.0]), None).unwrap();
            f.accumulate(AccumOp::Accumulate, 1.0 / 64.0, all, [true; 4]).unwrap();
        }
        let part = f.rect(1, 0, 2, 1);
        f.accumulate(AccumOp::Return, 1.0, part, [true, true, false, true]).unwrap();
        let mut out = [[0.0; 4]; 4];
        f.read_float(0, 0, &mut out);
        assert!((out[1][0] * 255.0 - 126.0).abs() < 0.01, "the mean of 0, 4, .. 252 is 126, not {}", out[1][0] * 255.0);
        assert_eq!((out[1][1], out[0][0]), (1.0, 252.0 / 255.0));
        f.accumulate(AccumOp::Multiply, 0.5, all, [true; 4]).unwrap();
        f.accumulate(AccumOp::Add, 0.25, all, [true; 4]).unwrap();
        f.accumulate(AccumOp::Return, 1.0, all, [true; 4]).unwrap();
        f.read_float(0, 1, &mut out);
        assert!((out[3][1] - 0.75).abs() < 0.002);
        f.accumulate(AccumOp::Load, -1.0, all, [true; 4]).unwrap();
        f.accumulate(AccumOp::Return, 1.0, all, [true; 4]).unwrap();
        f.read_float(0, 1, &mut out);
        assert_eq!(out[3], [0.0; 4], "negative values are kept, but not returned");
    }
    let mut f = Framebuffer::new(1, 1, FramebufferFormat { accum_bits: 0, ..format() }).unwrap();
    let all = f.rect(0, 0, 1, 1);
    let code = f.accumulate(AccumOp::Add, 1.0, all, [true; 4]).unwrap_err().code;
    assert_eq!(code, GL_INVALID_OPERATION);
    assert!(f.clear(&Clear { accum: Some([1.0; 4]), ..Clear::default() }, None).is_ok());
}

#[test]
fn resizing_starts_anew() {
    let mut f = Framebuffer::new(2, 2, format()).unwrap();
    f.clear(&color([1.0; 4]), None).unwrap();
    assert!(f.resize(MAX_VIEWPORT_DIM + 1, 2).is_err());
    assert_eq!((f.width(), row(&f, 0)), (2, vec![u32::MAX; 2]), "an error changes nothing");
    f.resize(3, 1).unwrap();
    assert_eq!((f.width(), f.height(), row(&f, 0)), (3, 1, vec![0; 3]));
}

#[test]
fn a_deferred_clear_is_a_clear_and_leaves_gaps_alone() {
    let clear = Clear {
        color: Some(([0.2, 0.4, 0.6, 0.8], [true; 4])),
        depth: Some(0.25),
        stencil: Some((7, 0xFF)),
        ..Clear::default()
    };
    for (flipped, stride) in [(false, 5), (true, 5), (false, 8), (true, 8)] {
        let mut memory = [[9u32; 8 * 6]; 2];
        for (later, memory) in memory.iter_mut().enumerate() {
            #[expect(unsafe_code, reason = "memory of the test")]
            // SAFETY: the array outlives the framebuffer and nobody else uses it meanwhile.
            let client = unsafe { UserMemory::new(memory.as_mut_ptr(), memory.len()) }.unwrap();
            let mut f = Framebuffer::with_user_memory(5, 6, stride, flipped, format(), client).unwrap();
            if later == 1 {
                f.defer_clear(&clear, None).unwrap();
                assert!(f.has_deferred_clear());
                f.bands(4).iter_mut().for_each(Band::apply_deferred_clear);
            } else {
                f.clear(&clear, None).unwrap();
            }
            assert!(!f.has_deferred_clear());
            let (mut d, mut s) = ([0.0; 5], [0; 5]);
            f.read_depth(0, 5, &mut d);
            f.read_stencil(0, 0, &mut s);
            assert!(d.iter().all(|d| (d - 0.25).abs() < 1e-6) && s == [7; 5]);
            assert!(f.hier_z.iter().all(|limit| *limit == f.depth_value(0.25)));
        }
        assert_eq!(memory[0], memory[1]);
        assert_ne!(memory[0][0], 9);
        assert_eq!(memory[0][5..8], if stride == 8 { [9; 3] } else { [memory[0][0]; 3] });
    }
    let mut f = Framebuffer::new(4, 4, format()).unwrap();
    for part in [
        Clear { color: Some(([1.0; 4], [true, false, true, true])), ..clear },
        Clear { stencil: Some((1, 0x7F)), ..clear },
    ] {
        f.defer_clear(&part, None).unwrap();
        assert!(!f.has_deferred_clear(), "a mask protects something");
    }
    f.defer_clear(&clear, Some(Rect { x: 0, y: 0, width: 4, height: 3 })).unwrap();
    assert!(!f.has_deferred_clear(), "a scissor box");
    f.defer_clear(&clear, Some(Rect { x: 0, y: 0, width: 4, height: 4 })).unwrap();
    assert!(f.has_deferred_clear());
    f.apply_deferred_clear();
    assert_eq!(row(&f, 3), [0xCC99_6633; 4]);
}

#[test]
fn depth_bounds_of_blocks_are_never_too_small() {
    let mut f = Framebuffer::new(150, 3, format()).unwrap();
    let depth = |value| Clear { depth: Some(value), ..Clear::default() };
    f.clear(&depth(0.5), None).unwrap();
    let [half, far] = [0.5, 0.75].map(|d| f.depth_value(d));
    assert_eq!(f.hier_z, [half; 9]);
    f.clear(&depth(0.25), Some(Rect { x: 60, y: 1, width: 70, height: 1 })).unwrap();
    let near = f.depth_value(0.25);
    assert_eq!(f.hier_z[3..6], [half, near, half], "only the block that is covered");
    f.clear(&depth(0.75), Some(Rect { x: 140, y: 2, width: 10, height: 1 })).unwrap();
    assert_eq!(f.hier_z[6..], [half, half, far]);
    f.write_depth(70, 1, &[f.format().quantised_depth(0.9)]);
    assert!(f.hier_z[3..6].iter().all(|limit| *limit == u32::MAX));
    let mut band = f.band();
    band.hier_z.invalidate();
    assert!(band.hier_z.row(2).iter().all(|limit| *limit == u32::MAX));
    band.hier_z.set(2, 1, 17);
    assert_eq!(band.hier_z.row(2), [u32::MAX, 17, u32::MAX]);
    assert_eq!(band.hier_z.row(3), [0; 0]);
}
