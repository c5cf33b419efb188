//! What is interpolated across a primitive. A [`Layout`] says which values a draw needs and in which slot each stands;
//! the vertex stages write the slots, setup turns them into planes, fragments evaluate the planes. What the fragment plan
//! does not need has no slot, so it is not computed.
//!
//! With b0, b1, b2 the barycentric coordinates in the window and r_i = w_ref / w_i (w_ref the least w, so 0 < r_i <= 1):
//!
//! ```text
//!   D(x, y) = sum b_i r_i                      exactly 1 everywhere where all w are equal
//!   f(x, y) = c + N(x, y) / D(x, y)            N = sum b_i r_i (f_i - c), 0 everywhere where all f_i are equal
//!   unit with q:  s/q = c + N / Q              Q = sum b_i r_i q_i,  N = sum b_i r_i (s_i - c q_i)
//!   df/dx = (N_x - (N / D) D_x) / D
//! ```
//!
//! Every linear function is summed as `(at + y dy) + x dx`. For `wide` primitives D and N are f64 and 1/D is
//! `r (2 - D r)` with `r = 1 / (D as f32)`; else all is f32, from coefficients rounded to f32.
//!
//! x and y are pixels relative to the primitive's origin (an integer pixel in it), so that moving a primitive by whole
//! pixels changes no bit.

use crate::limits::MAX_TEXTURE_UNITS;

/// The slots of one texture unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnitSlots {
    /// Slot of s; t and r follow as far as `count` goes, then q where `has_q`.
    pub base: usize,
    /// How many of s, t, r the target uses: 1, 2 or 3.
    pub count: usize,
    /// Whether q may differ from 1. Without it q is 1 for every vertex and has no slot.
    pub has_q: bool,
    /// For each coordinate the whole number that may be taken off without changing the result: 0 none, 1 REPEAT,
    /// 2 MIRRORED_REPEAT.
    pub period: [u8; 3],
    /// Width, height, depth of the base level in texels: setup decides by it which precision a primitive needs.
    pub size: [u32; 3],
    /// Cube map: s, t, r are a direction and q is not used.
    pub cube: bool,
}

/// Which values are interpolated, and where each stands in a vertex's list of floats.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    /// Slot of the primary colour, 4 floats.
    pub color: Option<usize>,
    /// Slot of the secondary colour, 3 floats.
    pub secondary: Option<usize>,
    /// Slot of the fog coordinate, 1 float: z in eye coordinates, or the vertices' fog coordinate, as the state asks for.
    pub fog: Option<usize>,
    /// Slots of each unit's coordinates.
    pub units: [Option<UnitSlots>; MAX_TEXTURE_UNITS],
    /// How many slots are interpolated.
    pub count: usize,
    /// Slot, from `count` on, of the back-face colour (4 floats) and then, where `secondary` is, of the back-face
    /// secondary colour (3 floats): two-sided lighting. Setup puts them in place of the front ones for back faces.
    pub back: Option<usize>,
    /// Floats of one vertex: `count` plus the back-face ones.
    pub stride: usize,
}

/// The plane of one slot: `clamp(c + (n0 + nx dx + ny dy) * rw, min, max)`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Plane {
    /// Value that is taken off before interpolation.
    pub c: f32,
    /// Least value at a vertex (minus the period taken off), so that rounding never leaves the range.
    pub min: f32,
    /// Greatest value at a vertex.
    pub max: f32,
    /// Numerator at the origin.
    pub n0: f64,
    /// Numerator's change per pixel in x.
    pub nx: f64,
    /// Numerator's change per pixel in y.
    pub ny: f64,
}

impl Plane {
    /// N.
    #[inline(always)]
    #[must_use]
    pub fn numerator(&self) -> Linear {
        Linear { at: self.n0, x: self.nx, y: self.ny }
    }
}

/// How many small primitives share a [`PlaneGroup`].
pub const GROUP: usize = 16;

/// The planes of one slot of a group of small primitives, coefficient by coefficient and rounded to f32: none of them is
/// wide. So they are computed and written a primitive a lane, and a fragment stage reads of them no more than it uses.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(64))]
pub struct PlaneGroup {
    /// See [`Plane::c`].
    pub c: [f32; GROUP],
    /// See [`Plane::min`].
    pub min: [f32; GROUP],
    /// See [`Plane::max`].
    pub max: [f32; GROUP],
    /// See [`Plane::n0`].
    pub n0: [f32; GROUP],
    /// See [`Plane::nx`].
    pub nx: [f32; GROUP],
    /// See [`Plane::ny`].
    pub ny: [f32; GROUP],
}

#[cfg(test)]
impl PlaneGroup {
    /// The plane of a primitive of the group.
    #[must_use]
    pub fn plane(&self, member: u8) -> Plane {
        let i = member as usize % GROUP;
        let wide = |n: &[f32; GROUP]| f64::from(n[i]);
        let (n0, nx, ny) = (wide(&self.n0), wide(&self.nx), wide(&self.ny));
        Plane { c: self.c[i], min: self.min[i], max: self.max[i], n0, nx, ny }
    }
}

/// The planes of a scene's slots.
#[derive(Clone, Copy, Debug, Default)]
pub struct PlanePool<'a> {
    /// Those of primitives that stand alone.
    pub alone: &'a [Plane],
    /// Those of small ones in groups.
    pub groups: &'a [PlaneGroup],
}

#[cfg(test)]
impl PlanePool<'_> {
    /// The plane of a primitive's slot.
    #[must_use]
    pub fn plane(&self, of: &Planes, slot: usize) -> Option<Plane> {
        let at = (of.first as usize).checked_add(slot)?;
        match of.member {
            Some(member) => self.groups.get(at).map(|group| group.plane(member)),
            None => self.alone.get(at).copied(),
        }
    }
}

impl<'a> From<&'a Vec<Plane>> for PlanePool<'a> {
    fn from(alone: &'a Vec<Plane>) -> Self {
        Self { alone, groups: &[] }
    }
}

/// A linear function of the window position, f64.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Linear {
    /// Value at the origin.
    pub at: f64,
    /// Change per pixel in x.
    pub x: f64,
    /// Change per pixel in y.
    pub y: f64,
}

/// What fragments need to know of their primitive. The planes of its slots stand in the scene's pool.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Planes {
    /// The pixel that positions are relative to.
    pub origin: [i32; 2],
    /// Depth in units of the depth buffer, polygon offset included, not limited.
    pub z: Linear,
    /// Least and greatest depth of a fragment, within the range of the depth buffer.
    pub z_range: [f64; 2],
    /// Relative 1/w.
    pub d: Linear,
    /// Whether D is exactly 1 everywhere.
    pub affine: bool,
    /// Whether it is the back face of a polygon, or a part of one in polygon mode point or line.
    pub back: bool,
    /// Bit u: unit u's coordinates need f64 evaluation (their range in texels and of w is too wide for f32).
    /// [`Planes::WIDE_W`]: the range of w alone is too wide, so colours and fog coordinate need it too.
    pub wide: u32,
    /// Index of the first slot's [`Plane`] in the scene's pool; slot k is at `first + k`. The plane of a unit's q slot
    /// holds Q in n0, nx, ny.
    pub first: u32,
    /// Which one it is of a group, if it is in one: then `first` is the index of a [`PlaneGroup`].
    pub member: Option<u8>,
}

impl Planes {
    /// Bit of `wide`: 1/w varies so much over the primitive (by more than about 1000) that D must be summed in f64 for
    /// colours and the fog coordinate as well.
    pub const WIDE_W: u32 = 1 << 31;
}

/// One texture unit's planes of a primitive: those of its K coordinates, and the divisor.
#[derive(Clone, Copy, Debug)]
pub struct Unit<'a, const K: usize> {
    /// The primitive.
    pub planes: &'a Planes,
    /// Its coordinates.
    pub coords: &'a [Plane; K],
    /// Q, or D where the unit has no q.
    pub divisor: Linear,
    /// Whether it has.
    pub has_q: bool,
    /// Whether coordinates are evaluated in `f64`.
    pub wide: bool,
}

impl<const K: usize> Unit<'_, K> {
    /// Whether the derivatives are the same everywhere: those of the numerators.
    #[inline(always)]
    pub fn is_even(&self) -> bool {
        let d = &self.divisor;
        self.planes.affine && !self.has_q && d.at == 1.0 && d.x == 0.0 && d.y == 0.0
    }
}
