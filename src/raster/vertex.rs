//! A vertex as the vertex stages hand it to clipping and setup (OpenGL 1.5, section 2.11 end): clip coordinates, the
//! window position where it has one, an outcode, and the varyings, one slot each of the
//! [`Layout`](crate::fragment::planes::Layout).

/// Position part of a processed vertex. w lies beside the window position, so that both are copied at once.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Vertex {
    /// Clip coordinates.
    pub clip: [f64; 4],
    /// Window x, y in pixels and depth in [0, 1] before offset; meaningful only where `outcode` has no bit of
    /// [`outcode::NEEDS_CLIP`].
    pub window: [f64; 3],
    /// Window position in 1/256 pixel, rounded to nearest.
    pub snapped: [i32; 2],
    /// Which half-spaces the vertex is outside of; bits of [`outcode`].
    pub outcode: u32,
    /// Whether an edge that starts here is a boundary edge (polygon modes LINE and POINT).
    pub edge: bool,
    /// Point size derived for this vertex.
    pub point_size: f32,
}

/// A processed vertex as setup reads it.
#[derive(Clone, Copy, Debug)]
pub struct VertexRef<'a> {
    /// The position part.
    pub head: &'a Vertex,
    /// The values of its slots, at least the layout's stride of them.
    pub slots: &'a [f32],
}

/// What culling needs of a vertex, in one word: the outcode in the low 16 bits, then window x and y in 1/256 pixel with 24
/// bits each. That is enough for positions within the guard band; those of other vertices mean nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ScreenPosition(pub u64);

impl ScreenPosition {
    /// The word.
    #[inline(always)]
    #[must_use]
    pub const fn new([x, y]: [i32; 2], outcode: u32) -> Self {
        Self(((y as u32 as u64) << 40) | (((x as u32 & 0xFF_FFFF) as u64) << 16) | (outcode & 0xFFFF) as u64)
    }

    /// Window position in 1/256 pixel.
    #[inline(always)]
    #[must_use]
    pub const fn snapped(self) -> [i32; 2] {
        [((self.0 << 24) as i64 >> 40) as i32, (self.0 as i64 >> 40) as i32]
    }

    /// The outcode.
    #[inline(always)]
    #[must_use]
    pub const fn outcode(self) -> u32 {
        self.0 as u32 & 0xFFFF
    }
}

/// Bits of [`Vertex::outcode`]; there are 16.
pub mod outcode {
    /// x < -w.
    pub const LEFT: u32 = 1;
    /// x > w.
    pub const RIGHT: u32 = 2;
    /// y < -w.
    pub const BOTTOM: u32 = 4;
    /// y > w.
    pub const TOP: u32 = 8;
    /// z < -w.
    pub const NEAR: u32 = 16;
    /// z > w.
    pub const FAR: u32 = 32;
    /// User clip plane i is `USER << i`.
    pub const USER: u32 = 64;
    /// Window x or y outside the guard band of +-32767: a triangle with such a vertex is clipped against the guard band.
    pub const GUARD: u32 = 1 << 12;
    /// w is not positive enough for a division, or a coordinate is not finite.
    pub const BEHIND: u32 = 1 << 13;
    /// A coordinate is NaN: the primitive is dropped.
    pub const NAN: u32 = 1 << 14;
    /// The six planes of the view volume.
    pub const FRUSTUM: u32 = 63;
    /// All user planes.
    pub const USER_ALL: u32 = 63 * USER;
    /// A triangle with any of these bits in any vertex must be clipped; left, right, bottom and top alone need no
    /// clipping, since the rasteriser cuts at the viewport's edge inside the guard band.
    pub const NEEDS_CLIP: u32 = NEAR | FAR | USER_ALL | GUARD | BEHIND;
}

/// Processed vertices: position parts and, `stride` floats for each, their slots.
#[derive(Clone, Debug, Default)]
pub struct Vertices {
    /// Position parts.
    pub head: Vec<Vertex>,
    /// Slots, vertex by vertex, and at least four more.
    pub slots: Vec<f32>,
    /// Floats of one vertex.
    pub stride: usize,
}

impl Vertices {
    /// The slots of vertex `i`; empty where there is no such vertex.
    #[must_use]
    pub fn slots(&self, i: usize) -> &[f32] {
        self.slots.get(i * self.stride..(i + 1) * self.stride).unwrap_or(&[])
    }

    /// Forgets all vertices and sets the stride of those to come.
    pub fn clear(&mut self, stride: usize) {
        self.head.clear();
        self.slots.clear();
        self.stride = stride;
    }
}

/// Twice the area in units of the grid, 1/65536 square pixel, positive where the triangle winds counter-clockwise. Exact for
/// positions within the guard band.
#[inline]
pub(crate) fn twice_area(p: &[[i32; 2]; 3]) -> i64 {
    let side = |i: usize, k: usize| i64::from(p[i][k]) - i64::from(p[0][k]);
    side(1, 0) * side(2, 1) - side(2, 0) * side(1, 1)
}
