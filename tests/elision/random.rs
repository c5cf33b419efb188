//! Random numbers with a seed (xorshift), so that a failing case can be drawn again.

/// A generator of random numbers.
#[derive(Clone)]
pub struct Random(u64);

impl Random {
    /// The generator of a case.
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// A number below `n`.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() >> 11) as usize % n
    }

    /// True once in `n` times.
    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// One of these.
    pub fn of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// A number in `low..high`.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.next() >> 40) as f32 / 16_777_216.0
    }

    /// Four numbers in [0, 1], now and then exactly 0 or 1.
    pub fn color(&mut self) -> [f32; 4] {
        std::array::from_fn(|_| match self.below(4) {
            0 => self.of(&[0.0, 1.0]),
            _ => self.between(0.0, 1.0),
        })
    }
}
