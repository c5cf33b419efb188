//! What the chapter tests share: a random number generator with a fixed sequence, test images, the bridge that gives an
//! oracle scene to the crate as GL commands, and the comparison of the two pictures.

#![allow(dead_code, reason = "every test binary that includes these helpers uses another part of them")]

pub mod bridge;
pub mod compare;
pub mod images;
pub mod scenes;

use fixedgl::Context;

/// A small generator of numbers (xorshift): the same sequence everywhere.
pub struct Random(pub u64);

impl Random {
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    /// A number from `low` to `high` that an f32 holds exactly.
    pub fn range(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.bits() >> 40) as f64 / (1u64 << 24) as f64;
        f64::from((low + unit * (high - low)) as f32)
    }

    /// A whole number from 0 to n - 1.
    pub fn below(&mut self, n: u64) -> u64 {
        (self.bits() >> 20) % n
    }

    /// One of a list.
    pub fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len() as u64) as usize]
    }
}

/// The error code since the last question, and a check in words that there is none.
#[track_caller]
pub fn no_error(cx: &mut Context) {
    let code = cx.get_error();
    assert_eq!(code, 0, "an unexpected GL error: {}", fixedgl::enums::name(code));
}

/// The command must raise exactly this error.
#[track_caller]
pub fn raises(cx: &mut Context, code: u32, command: impl FnOnce(&mut Context)) {
    no_error(cx);
    command(cx);
    let got = cx.get_error();
    assert_eq!(got, code, "want {}, got {}", fixedgl::enums::name(code), fixedgl::enums::name(got));
}

/// One integer of state.
#[track_caller]
pub fn get_i(cx: &mut Context, what: u32) -> i32 {
    let mut v = [0i32; 16];
    cx.get_integerv(what, &mut v);
    no_error(cx);
    v[0]
}

/// Several floats of state.
#[track_caller]
pub fn get_f<const N: usize>(cx: &mut Context, what: u32) -> [f32; N] {
    let mut v = [0f32; 16];
    cx.get_floatv(what, &mut v);
    no_error(cx);
    std::array::from_fn(|i| v[i])
}

/// The colour buffer as RGBA bytes, rows from the bottom.
#[track_caller]
pub fn pixels(cx: &mut Context, width: u32, height: u32) -> Vec<[u8; 4]> {
    let mut bytes = vec![[0u8; 4]; (width * height) as usize];
    cx.read_pixels(
        0,
        0,
        width as i32,
        height as i32,
        fixedgl::enums::GL_RGBA,
        fixedgl::enums::GL_UNSIGNED_BYTE,
        &mut bytes,
    );
    no_error(cx);
    bytes
}
