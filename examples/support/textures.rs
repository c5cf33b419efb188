//! Textures made by code, so that the examples need no files.

use fixedgl::math::sin;

/// An RGB image, row by row from the bottom.
pub type Image = Vec<[u8; 3]>;

/// A board of squares of `cell` texels in two colours.
pub fn checks(size: usize, cell: usize, colors: [[u8; 3]; 2]) -> Image {
    (0..size * size).map(|i| colors[((i % size / cell) ^ (i / size / cell)) & 1]).collect()
}

/// Bricks in running bond with mortar between them.
pub fn bricks(size: usize) -> Image {
    let (w, h) = (size / 4, size / 8);
    let texel = |i: usize| {
        let (x, y) = (i % size, i / size);
        let shifted = x + if (y / h) % 2 == 0 { 0 } else { w / 2 };
        if y % h < 2 || shifted % w < 2 {
            return [190, 185, 175];
        }
        let grain = hash((shifted / w * 31 + y / h * 17) as u32) % 40 + hash(i as u32) % 20;
        [150 + grain as u8, 60 + grain as u8 / 2, 45 + grain as u8 / 2]
    };
    (0..size * size).map(texel).collect()
}

/// A soft spot of light in the middle, black outside.
pub fn spot(size: usize) -> Image {
    let half = size as f64 / 2.0;
    let texel = |i: usize| {
        let (x, y) = ((i % size) as f64 + 0.5 - half, (i / size) as f64 + 0.5 - half);
        let r = (x * x + y * y).sqrt() / half;
        let v = if r < 0.55 { 1.0 } else { ((0.95 - r) / 0.4).clamp(0.0, 1.0) };
        [(255.0 * v) as u8; 3]
    };
    (0..size * size).map(texel).collect()
}

/// Smooth noise on a lattice of whole numbers, in [0, 1].
pub fn noise([x, y, z]: [f64; 3]) -> f64 {
    let cell = [x.floor(), y.floor(), z.floor()];
    let f = [x - cell[0], y - cell[1], z - cell[2]].map(|t| t * t * (3.0 - 2.0 * t));
    let corner = |dx: i64, dy: i64, dz: i64| {
        let at = ((cell[0] as i64 + dx) * 73_856_093)
            ^ ((cell[1] as i64 + dy) * 19_349_663)
            ^ ((cell[2] as i64 + dz) * 83_492_791);
        f64::from(hash(at as u32) & 0xFFFF) / 65535.0
    };
    let mix = |a: f64, b: f64, t: f64| a + t * (b - a);
    let plane = |dz: i64| {
        mix(mix(corner(0, 0, dz), corner(1, 0, dz), f[0]), mix(corner(0, 1, dz), corner(1, 1, dz), f[0]), f[1])
    };
    mix(plane(0), plane(1), f[2])
}

/// Octaves of noise, each twice as fine and half as strong: marble veins are a sine disturbed by it.
pub fn marble(p: [f64; 3]) -> f64 {
    let turbulence: f64 = (0..4).map(|k| noise(p.map(|c| c * f64::from(1 << k))) / f64::from(1 << k)).sum();
    0.5 + 0.5 * sin(4.0 * p[0] + 5.0 * turbulence)
}

/// Mixes the bits of a number well enough for patterns.
pub fn hash(mut x: u32) -> u32 {
    x = (x ^ (x >> 15)).wrapping_mul(0x2C1B_3C6D);
    x = (x ^ (x >> 12)).wrapping_mul(0x297A_2D39);
    x ^ (x >> 15)
}
