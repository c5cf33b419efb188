//! From (s, t, r) to a filtered texel (OpenGL 1.5, sections 3.8.6 to 3.8.9 and 3.8.14): wrap modes, NEAREST and LINEAR in
//! one, two and three dimensions, rectangles, cube faces, border texels and the depth comparison. Images are plain lists of
//! [f64; 4], already expanded to RGBA (a depth texel stands in the first component), so a texel is what it reads.

use super::lod::{Footprint, Levels, LodState, lambda, levels};
use super::{V3, V4, add, length, mix, scale};
use fixedgl::enums::*;

/// One level of one face. `texels` holds the border, too: texel (i, j, k), from -border to size + border - 1 each.
#[derive(Clone, Debug)]
pub struct Image {
    /// Interior width, height and depth; 1 for dimensions that the target has not.
    pub size: [i64; 3],
    /// Border width (0 or 1) in the dimensions that the target has.
    pub border: [i64; 3],
    pub texels: Vec<V4>,
}

impl Image {
    /// A two-dimensional image without border from a function of (i, j).
    pub fn from_fn(width: i64, height: i64, f: impl Fn(i64, i64) -> V4) -> Image {
        Image::new([width, height, 1], [0; 3], |[i, j, _]| f(i, j))
    }

    /// Any image from a function of (i, j, k), which is asked for border texels as well.
    pub fn new(size: [i64; 3], border: [i64; 3], f: impl Fn([i64; 3]) -> V4) -> Image {
        let mut texels = Vec::new();
        for k in -border[2]..size[2] + border[2] {
            for j in -border[1]..size[1] + border[1] {
                for i in -border[0]..size[0] + border[0] {
                    texels.push(f([i, j, k]));
                }
            }
        }
        Image { size, border, texels }
    }

    /// The texel, or nothing outside the image and its border.
    pub fn texel(&self, at: [i64; 3]) -> Option<V4> {
        let mut index = 0;
        for d in (0..3).rev() {
            let whole = self.size[d] + 2 * self.border[d];
            let p = at[d] + self.border[d];
            if !(0..whole).contains(&p) {
                return None;
            }
            index = index * whole + p;
        }
        self.texels.get(usize::try_from(index).ok()?).copied()
    }
}

/// A texture object: images, base format, parameters.
#[derive(Clone, Debug)]
pub struct Texture {
    pub target: GLenum,
    /// GL_RGBA, GL_LUMINANCE .. or GL_DEPTH_COMPONENT.
    pub base_format: GLenum,
    /// `levels[level][face]`; one face unless this is a cube map (+x, -x, +y, -y, +z, -z).
    pub levels: Vec<Vec<Image>>,
    /// TEXTURE_WRAP_S, _T, _R.
    pub wrap: [GLenum; 3],
    pub border_color: V4,
    pub lod: LodState,
    /// TEXTURE_COMPARE_MODE is COMPARE_R_TO_TEXTURE: the function.
    pub compare: Option<GLenum>,
    /// DEPTH_TEXTURE_MODE.
    pub depth_mode: GLenum,
}

impl Texture {
    /// A texture of the given levels with GL's initial parameters.
    pub fn new(target: GLenum, base_format: GLenum, levels: Vec<Vec<Image>>) -> Texture {
        let mut t = Texture {
            target,
            base_format,
            levels,
            wrap: [GL_REPEAT; 3],
            border_color: [0.0; 4],
            lod: LodState::default(),
            compare: None,
            depth_mode: GL_LUMINANCE,
        };
        if target == GL_TEXTURE_RECTANGLE_ARB {
            t.wrap = [GL_CLAMP_TO_EDGE; 3];
            t.lod.min_filter = GL_LINEAR;
        }
        t
    }

    /// One two-dimensional level.
    pub fn flat(base_format: GLenum, image: Image) -> Texture {
        Texture::new(GL_TEXTURE_2D, base_format, vec![vec![image]])
    }

    /// The number of coordinates.
    pub fn dimensions(&self) -> usize {
        match self.target {
            GL_TEXTURE_1D => 1,
            GL_TEXTURE_3D => 3,
            _ => 2,
        }
    }
}

/// What sampling found out on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampled {
    /// RGBA, expanded from the base format.
    pub color: V4,
    pub lambda: f64,
    pub levels: Levels,
    /// How far (in texels of the levels that were read) a coordinate is from a place where the texel of NEAREST changes.
    pub to_boundary: f64,
    /// Pmax / Pmin of the footprint: where that is a whole number, the number of taps hangs on the last digit.
    pub anisotropy: f64,
}

/// One coordinate after its wrap mode, in texels of a level of `n` texels; `s` has been multiplied by nothing yet.
pub fn wrapped(mode: GLenum, s: f64, n: i64) -> f64 {
    let size = n as f64;
    let half = 1.0 / (2.0 * size);
    let whole = s.floor();
    let mirrored = if whole.rem_euclid(2.0) == 0.0 { s - whole } else { 1.0 - (s - whole) };
    let s = match mode {
        GL_REPEAT => s - whole,
        GL_CLAMP => s.clamp(0.0, 1.0),
        GL_CLAMP_TO_EDGE => s.clamp(half, 1.0 - half),
        GL_CLAMP_TO_BORDER => s.clamp(-half, 1.0 + half),
        GL_MIRRORED_REPEAT => mirrored.clamp(half, 1.0 - half),
        // EXT_texture_mirror_clamp: |s| and then as the mode without the mirror, but 0 is not an edge.
        GL_MIRROR_CLAMP_EXT => s.abs().clamp(0.0, 1.0),
        GL_MIRROR_CLAMP_TO_EDGE_EXT => s.abs().clamp(half, 1.0 - half),
        GL_MIRROR_CLAMP_TO_BORDER_EXT => s.abs().clamp(0.0, 1.0 + half),
        other => panic!("the oracle has no wrap mode {other:#x}"),
    };
    s * size
}

/// The texel index of NEAREST (equations 3.19 to 3.21).
pub fn nearest_index(mode: GLenum, s: f64, n: i64) -> i64 {
    let u = wrapped(mode, s, n);
    let inside = !matches!(mode, GL_CLAMP_TO_BORDER | GL_MIRROR_CLAMP_TO_BORDER_EXT);
    if inside && u >= n as f64 { n - 1 } else { u.floor() as i64 }
}

/// The two texel indices of LINEAR and the weight of the second (equations 3.22 to 3.26).
pub fn linear_indices(mode: GLenum, s: f64, n: i64) -> (i64, i64, f64) {
    let u = wrapped(mode, s, n) - 0.5;
    let i0 = u.floor();
    let (a, b) = (i0 as i64, i0 as i64 + 1);
    let mirror = |i: i64| if i < 0 { -1 - i } else { i };
    match mode {
        GL_REPEAT => (a.rem_euclid(n), b.rem_euclid(n), u - i0),
        GL_MIRROR_CLAMP_EXT | GL_MIRROR_CLAMP_TO_EDGE_EXT | GL_MIRROR_CLAMP_TO_BORDER_EXT => (mirror(a), b, u - i0),
        _ => (a, b, u - i0),
    }
}

/// The face and (s, t) of a direction (table 3.19). Ties are the implementation's to break: here z before y before x.
pub fn cube_face(r: V3) -> (usize, [f64; 2]) {
    let [x, y, z] = r;
    let (ax, ay, az) = (x.abs(), y.abs(), z.abs());
    let (face, sc, tc, ma) = if az >= ay && az >= ax {
        if z >= 0.0 { (4, x, -y, az) } else { (5, -x, -y, az) }
    } else if ay >= ax {
        if y >= 0.0 { (2, x, z, ay) } else { (3, x, -z, ay) }
    } else if x >= 0.0 {
        (0, -z, -y, ax)
    } else {
        (1, z, -y, ax)
    };
    if ma == 0.0 { (face, [0.5, 0.5]) } else { (face, [(sc / ma + 1.0) / 2.0, (tc / ma + 1.0) / 2.0]) }
}

/// COMPARE_R_TO_TEXTURE (3.8.14): 1 where r passes against the texel's depth.
pub fn compare(func: GLenum, r: f64, depth: f64) -> f64 {
    let r = r.clamp(0.0, 1.0);
    let pass = match func {
        GL_LEQUAL => r <= depth,
        GL_GEQUAL => r >= depth,
        GL_LESS => r < depth,
        GL_GREATER => r > depth,
        GL_EQUAL => r == depth,
        GL_NOTEQUAL => r != depth,
        GL_ALWAYS => true,
        GL_NEVER => false,
        other => panic!("the oracle has no comparison {other:#x}"),
    };
    f64::from(u8::from(pass))
}

impl Texture {
    fn fetch(&self, image: &Image, at: [i64; 3], reference: f64) -> V4 {
        let texel = image.texel(at).unwrap_or(self.border_color);
        if self.base_format != GL_DEPTH_COMPONENT {
            return texel;
        }
        let d = self.compare.map_or(texel[0], |func| compare(func, reference, texel[0]));
        match self.depth_mode {
            GL_LUMINANCE => [d, d, d, 1.0],
            GL_INTENSITY => [d; 4],
            _ => [0.0, 0.0, 0.0, d],
        }
    }

    /// One level filtered with NEAREST or LINEAR at (s, t, r), s etc. from 0 to 1 (a rectangle's divided by its size).
    pub fn filter(&self, level: u32, face: usize, filter: GLenum, str_: V3, reference: f64) -> V4 {
        let image = &self.levels[level as usize][face];
        let n = self.dimensions();
        if filter == GL_NEAREST {
            let index = |d| if d < n { nearest_index(self.wrap[d], str_[d], image.size[d]) } else { 0 };
            return self.fetch(image, std::array::from_fn(index), reference);
        }
        let pairs: [(i64, i64, f64); 3] =
            std::array::from_fn(
                |d| {
                    if d < n { linear_indices(self.wrap[d], str_[d], image.size[d]) } else { (0, 0, 0.0) }
                },
            );
        let mut sum = [0.0; 4];
        for corner in 0..1usize << n {
            let high = |d: usize| corner >> d & 1 == 1;
            let at = std::array::from_fn(|d| if high(d) { pairs[d].1 } else { pairs[d].0 });
            let weight: f64 = (0..n).map(|d| if high(d) { pairs[d].2 } else { 1.0 - pairs[d].2 }).product();
            sum = add(sum, scale(self.fetch(image, at, reference), weight));
        }
        sum
    }

    /// How far the coordinates are from a place where NEAREST changes its mind, at a level.
    fn to_boundary(&self, level: u32, face: usize, str_: V3) -> f64 {
        let image = &self.levels[level as usize][face];
        let distance = |d: usize| {
            let u = str_[d] * image.size[d] as f64;
            (u - u.round()).abs()
        };
        (0..self.dimensions()).map(distance).fold(f64::INFINITY, f64::min)
    }

    /// The factor from a coordinate to texels of the base level.
    pub fn texels(&self, d: usize) -> f64 {
        let base = &self.levels[self.lod.base_level as usize][0];
        if self.target == GL_TEXTURE_RECTANGLE_ARB { 1.0 } else { base.size[d] as f64 }
    }

    /// The texture's value at (s, t, r) (after division by q) with the derivatives of (s, t, r) by x and by y.
    /// Of a cube map (s, t, r) is the direction.
    pub fn sample(&self, str_: V3, by_x: V3, by_y: V3) -> Sampled {
        let base = &self.levels[self.lod.base_level as usize][0];
        let n = self.dimensions();
        let (mut coords, mut dx, mut dy, mut face) = (str_, by_x, by_y, 0);
        if self.target == GL_TEXTURE_CUBE_MAP {
            let (f, st) = cube_face(str_);
            face = f;
            coords = [st[0], st[1], 0.0];
            dx = face_derivative(f, str_, by_x);
            dy = face_derivative(f, str_, by_y);
        }
        let texels = |v: V3| -> V3 { std::array::from_fn(|d| if d < n { v[d] * self.texels(d) } else { 0.0 }) };
        let footprint = Footprint { by_x: texels(dx), by_y: texels(dy) };
        if self.target == GL_TEXTURE_RECTANGLE_ARB {
            coords = std::array::from_fn(|d| coords[d] / base.size[d] as f64);
        }
        let (taps, rho) =
            if self.lod.anisotropy > 1.0 { footprint.anisotropic(self.lod.anisotropy) } else { (1, footprint.rho()) };
        let lambda = lambda(&self.lod, rho);
        let largest = base.size.iter().max().copied().unwrap_or(1);
        let read = levels(&self.lod, lambda, u32::try_from(largest).unwrap_or(1));
        let offsets = footprint.taps(taps);
        let reference = str_[2];
        let one = |level: u32, filter: GLenum| {
            let tap =
                |o: &V3| std::array::from_fn(|d| coords[d] + if d < n { o[d] / base.size[d] as f64 } else { 0.0 });
            let sum = offsets.iter().fold([0.0; 4], |s, o| add(s, self.filter(level, face, filter, tap(o), reference)));
            scale(sum, 1.0 / f64::from(taps))
        };
        let (color, to_boundary) = match read {
            Levels::One { level, filter } => (one(level, filter), self.to_boundary(level, face, coords)),
            Levels::Two { d1, d2, t, filter } => {
                let d = self.to_boundary(d1, face, coords).min(self.to_boundary(d2, face, coords));
                (mix(one(d1, filter), one(d2, filter), t), d)
            }
        };
        let [longer, shorter] = [f64::max, f64::min].map(|pick| pick(length(&footprint.by_x), length(&footprint.by_y)));
        Sampled { color, lambda, levels: read, to_boundary, anisotropy: longer / shorter }
    }
}

/// The derivative of the face coordinates (s, t) of a direction `r` that changes by `d`, the face being kept.
fn face_derivative(face: usize, r: V3, d: V3) -> V3 {
    // s = (sc / |ma| + 1) / 2, so ds = (dsc |ma| - sc d|ma|) / (2 ma^2).
    let pick = |v: V3| match face {
        0 => [-v[2], -v[1], v[0]],
        1 => [v[2], -v[1], -v[0]],
        2 => [v[0], v[2], v[1]],
        3 => [v[0], -v[2], -v[1]],
        4 => [v[0], -v[1], v[2]],
        _ => [-v[0], -v[1], -v[2]],
    };
    let ([sc, tc, ma], [dsc, dtc, dma]) = (pick(r), pick(d));
    [(dsc * ma - sc * dma) / (2.0 * ma * ma), (dtc * ma - tc * dma) / (2.0 * ma * ma), 0.0]
}

#[cfg(test)]
#[path = "texel_tests.rs"]
mod tests;
