//! From the bits of a mask to the lanes or pixels that they stand for, eight at a time.

/// The set bits of each byte: their places, a byte each from the lowest on, and how many there are.
#[derive(Debug)]
pub struct Bits {
    /// The places.
    pub columns: [[u8; 8]; 256],
    /// Their number.
    pub count: [u8; 256],
}

/// Those of all bytes.
pub static BITS: Bits = {
    let mut bits = Bits { columns: [[0; 8]; 256], count: [0; 256] };
    let mut i = 0;
    while i < 256 * 8 {
        let (byte, column) = (i / 8, i % 8);
        if byte >> column & 1 != 0 {
            bits.columns[byte][bits.count[byte] as usize] = column as u8;
            bits.count[byte] += 1;
        }
        i += 1;
    }
    bits
};

/// How many bits of a mask are set. Not every processor has an instruction for that.
#[inline]
#[must_use]
pub fn count(bits: u64) -> usize {
    let half = |bits: u64| -> usize {
        let [a, b, c, d] = (bits as u32).to_le_bytes().map(|byte| usize::from(BITS.count[usize::from(byte)]));
        (a + b) + (c + d)
    };
    half(bits) + if bits >> 32 != 0 { half(bits >> 32) } else { 0 }
}
