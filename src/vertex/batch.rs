//! A batch of 64 vertices as a structure of arrays (OpenGL 1.5, sections 2.7 and 2.8): attributes (f32), what stages work
//! on (positions in f64, colours in f32), and an array for each slot of the varyings. Stages never write to the attributes,
//! so one that is the same for all vertices of a draw is filled in once.

use crate::fragment::planes::GROUP;
use crate::limits::{MAX_CLIP_PLANES, MAX_TEXTURE_UNITS};
use crate::raster::vertex::ScreenPosition;
pub use crate::simd::Lanes;
use crate::simd::{LANES, boxed};
use crate::state::current::Current;
use crate::state::primitive::PrimitiveMode;

/// One f64 for each lane.
pub type F64Lanes = [f64; LANES];

/// The greatest number of slots of a layout: colours, fog coordinate, coordinates of all units, back colours.
pub const MAX_SLOTS: usize = 4 + 3 + 1 + 4 * MAX_TEXTURE_UNITS + 4 + 3;

/// Vertices of a batch of separate triangles: as many as a triangle batch takes.
pub const LIST_VERTICES: usize = 3 * GROUP;
/// How many vertices of a primitive make a batch.
#[must_use]
pub const fn block(mode: PrimitiveMode) -> usize {
    if matches!(mode, PrimitiveMode::Triangles) { LIST_VERTICES } else { LANES }
}

/// Which attributes a plan reads; the others are not even copied into a batch.
pub mod needs {
    /// The normal.
    pub const NORMAL: u32 = 1;
    /// The primary colour.
    pub const COLOR: u32 = 2;
    /// The secondary colour.
    pub const SECONDARY: u32 = 4;
    /// The fog coordinate.
    pub const FOG: u32 = 8;
    /// The edge flag.
    pub const EDGE: u32 = 16;
    /// Texture coordinates of unit i are `TEX << i`.
    pub const TEX: u32 = 256;
    /// Texture coordinates of all units.
    pub const TEX_ALL: u32 = 0xFF * TEX;
}

/// Values of one face while a vertex is lit: sums over the lights before the material multiplies them.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct FaceSums {
    /// Ambient light that depends on the vertex (attenuated lights).
    pub ambient: [Lanes; 3],
    /// Diffuse light.
    pub diffuse: [Lanes; 3],
    /// Specular light.
    pub specular: [Lanes; 3],
}

/// Triangles of transformed vertices, and what culling makes of them.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct CullBatch {
    /// Positions of the corners.
    pub corners: [[ScreenPosition; LANES]; 3],
    /// What becomes of each triangle: a bit of the cull stage.
    pub(super) fate: [u64; LANES],
    /// How many there are.
    pub n: usize,
    /// A bit for each triangle that may be visible.
    pub seen: u64,
    /// Those of them that must be clipped.
    pub clipped: u64,
    /// Those that are outside of the view volume.
    pub outside: u64,
    /// Those that are inside, and culled.
    pub culled: u64,
}

impl CullBatch {
    /// No triangles.
    const EMPTY: Self = {
        let corners = [[ScreenPosition(0); LANES]; 3];
        Self { corners, fate: [0; LANES], n: 0, seen: 0, clipped: 0, outside: 0, culled: 0 }
    };
}

/// 64 vertices.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct VertexBatch {
    /// Object coordinates x, y, z, w.
    pub position: [Lanes; 4],
    /// Normal.
    pub normal: [Lanes; 3],
    /// Primary colour.
    pub color: [Lanes; 4],
    /// Secondary colour.
    pub secondary: [Lanes; 3],
    /// Fog coordinate.
    pub fog: Lanes,
    /// Texture coordinates s, t, r, q of each unit.
    pub tex: [[Lanes; 4]; MAX_TEXTURE_UNITS],
    /// Edge flag.
    pub edge: [bool; LANES],

    /// Eye coordinates.
    pub eye: [F64Lanes; 4],
    /// Eye coordinates divided by w.
    pub point: [F64Lanes; 3],
    /// Clip coordinates.
    pub clip: [F64Lanes; 4],
    /// Distances to the enabled user clip planes.
    pub user: [F64Lanes; MAX_CLIP_PLANES],
    /// Window coordinates.
    pub window: [F64Lanes; 3],
    /// Window x, y in 1/256 pixel and outcode.
    pub screen: [ScreenPosition; LANES],
    /// Derived point size.
    pub point_size: Lanes,
    /// Normal in eye coordinates.
    pub eye_normal: [Lanes; 3],
    /// Reflection vector in eye coordinates.
    pub reflection: [F64Lanes; 3],
    /// Unit vector to the viewer.
    pub to_viewer: [Lanes; 3],
    /// Unit vector to the light at hand.
    pub to_light: [Lanes; 3],
    /// Attenuation and spot factor of the light at hand.
    pub attenuation: Lanes,
    /// n . l of the light at hand.
    pub n_dot_l: Lanes,
    /// n . h of the light at hand.
    pub n_dot_h: Lanes,
    /// Sums of front and back face.
    pub faces: [FaceSums; 2],
    /// Texture coordinates of the unit at hand.
    pub coord: [F64Lanes; 4],
    /// The varyings, slot by slot, then four arrays for a colour that no slot takes.
    pub out: [Lanes; MAX_SLOTS + 4],
    /// Triangles of transformed vertices.
    pub triangles: CullBatch,
    /// How many lanes are in use.
    pub n: usize,
    /// How many lanes stages compute: `n` rounded up to a multiple of 16.
    pub span: usize,
    /// Whether w is 1 in every position.
    pub w_is_one: bool,
}

impl VertexBatch {
    const EMPTY: Self = {
        const Z: Lanes = [0.0; LANES];
        const W: F64Lanes = [0.0; LANES];
        let face = FaceSums { ambient: [Z; 3], diffuse: [Z; 3], specular: [Z; 3] };
        Self {
            n: 0,
            span: 0,
            w_is_one: true,
            position: [Z; 4],
            normal: [Z; 3],
            color: [Z; 4],
            secondary: [Z; 3],
            fog: Z,
            tex: [[Z; 4]; MAX_TEXTURE_UNITS],
            edge: [true; LANES],
            eye: [W; 4],
            point: [W; 3],
            clip: [W; 4],
            user: [W; MAX_CLIP_PLANES],
            window: [W; 3],
            screen: [ScreenPosition(0); LANES],
            point_size: Z,
            eye_normal: [Z; 3],
            reflection: [W; 3],
            to_viewer: [Z; 3],
            to_light: [Z; 3],
            attenuation: Z,
            n_dot_l: Z,
            n_dot_h: Z,
            faces: [face; 2],
            coord: [W; 4],
            out: [Z; MAX_SLOTS + 4],
            triangles: CullBatch::EMPTY,
        }
    };

    /// An empty batch.
    #[must_use]
    pub fn new() -> Box<Self> {
        static EMPTY: VertexBatch = VertexBatch::EMPTY;
        boxed(&EMPTY)
    }

    /// Forgets all vertices.
    #[inline]
    pub fn clear(&mut self) {
        self.n = 0;
        self.w_is_one = true;
    }

    /// Appends a vertex with the current attributes that are needed. A full batch takes nothing.
    #[inline(always)]
    pub fn push(&mut self, position: [f32; 4], current: &Current, needs: u32) {
        let i = self.n;
        if i >= LANES {
            return;
        }
        self.n = i + 1;
        for (lanes, value) in self.position.iter_mut().zip(position) {
            lanes[i] = value;
        }
        self.w_is_one &= position[3] == 1.0;
        if needs & needs::COLOR != 0 {
            for (lanes, value) in self.color.iter_mut().zip(current.color) {
                lanes[i] = value;
            }
        }
        if needs & needs::NORMAL != 0 {
            for (lanes, value) in self.normal.iter_mut().zip(current.normal) {
                lanes[i] = value;
            }
        }
        if needs & needs::TEX_ALL == needs::TEX {
            for (lanes, value) in self.tex[0].iter_mut().zip(current.tex_coord[0]) {
                lanes[i] = value;
            }
        } else if needs & needs::TEX_ALL != 0 {
            let mut units = needs & needs::TEX_ALL;
            while units != 0 {
                let unit = (units.trailing_zeros() - needs::TEX.trailing_zeros()) as usize % MAX_TEXTURE_UNITS;
                units &= units - 1;
                for (lanes, value) in self.tex[unit].iter_mut().zip(current.tex_coord[unit]) {
                    lanes[i] = value;
                }
            }
        }
        if needs & (needs::SECONDARY | needs::FOG | needs::EDGE) != 0 {
            self.push_rare(i, current);
        }
    }

    /// The attributes of a lane, as far as they have been pushed.
    #[must_use]
    pub fn current(&self, lane: usize) -> Current {
        fn at<const N: usize>(lanes: &[Lanes; N], lane: usize) -> [f32; N] {
            lanes.each_ref().map(|lanes| lanes.get(lane).copied().unwrap_or(0.0))
        }
        let [r, g, b] = at(&self.secondary, lane);
        Current {
            color: at(&self.color, lane),
            secondary_color: [r, g, b, 1.0],
            normal: at(&self.normal, lane),
            tex_coord: self.tex.each_ref().map(|tex| at(tex, lane)),
            fog_coord: at(&[self.fog], lane)[0],
            ..Current::default()
        }
    }

    fn push_rare(&mut self, i: usize, current: &Current) {
        for (lanes, value) in self.secondary.iter_mut().zip(current.secondary_color) {
            lanes[i] = value;
        }
        self.fog[i] = current.fog_coord;
        self.edge[i] = current.edge_flag;
    }

    /// Fills whole arrays with the current values of the needed attributes, for vertices that come from arrays which do
    /// not give them.
    pub fn splat(&mut self, current: &Current, needs: u32) {
        if needs & needs::COLOR != 0 {
            self.color = current.color.map(|v| [v; LANES]);
        }
        if needs & needs::NORMAL != 0 {
            self.normal = current.normal.map(|v| [v; LANES]);
        }
        if needs & needs::SECONDARY != 0 {
            let [r, g, b, _] = current.secondary_color;
            self.secondary = [r, g, b].map(|v| [v; LANES]);
        }
        if needs & needs::FOG != 0 {
            self.fog = [current.fog_coord; LANES];
        }
        if needs & needs::EDGE != 0 {
            self.edge = [current.edge_flag; LANES];
        }
        for (unit, (tex, value)) in self.tex.iter_mut().zip(current.tex_coord).enumerate() {
            if needs & (needs::TEX << unit) != 0 {
                *tex = value.map(|v| [v; LANES]);
            }
        }
    }
}
