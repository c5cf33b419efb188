//! What a texture environment makes of the texels of a span (OpenGL 1.5, section 3.8.13), and what follows it: rounding, or
//! blending by a pair of factors that has a loop of its own (section 4.1.7).

use crate::fragment::batch::Segment;
use crate::fragment::key::{EnvStep, LinearTexture};
use crate::fragment::plane_eval::{Extent, LinearEval, PlaneEval, Positions};
use crate::fragment::planes::{Plane, Planes};
use crate::fragment::reference::blend::pair;
use crate::fragment::reference::pack::{whole, whole_pixel};
use crate::fragment::uniforms::{FragUniforms, Work};
use crate::texture::filter::linear_rgba8::RGB;

/// Where alpha comes from.
#[derive(Clone, Copy)]
enum Alpha {
    /// It is the texel's.
    Texel,
    /// The texel's is multiplied with that of the primary colour.
    Product(PlaneEval<f32>),
    /// It is that of the primary colour.
    Primary(PlaneEval<f32>),
    /// It is the same in all of the part, and among the bits that are set in each pixel.
    Constant,
}

/// The environment of a part.
pub struct Environment {
    /// Planes by which red, green and blue are multiplied, if they are.
    pub color: Option<[PlaneEval<f32>; 3]>,
    alpha: Alpha,
    /// Bits that are set in each pixel.
    or: u32,
    /// The number of the pair of factors that it is blended by, if it is, and the unit of the store.
    blend: Option<(u32, f32)>,
}

impl Environment {
    /// That of a texture; `None` where something is interpolated that needs `f64`.
    #[inline(always)]
    pub fn new<const K: usize, const FORMAT: u8>(
        u: &FragUniforms,
        w: &Work<'_, '_>,
        (segment, extent, planes): (&Segment, Extent, &Planes),
        texture: &LinearTexture<K, FORMAT>,
    ) -> Option<Self> {
        let colors = u.layout.color.and_then(|slot| w.primitive::<4>(segment, slot)).map(|(_, planes)| planes);
        let environment = Self::of_planes(texture, colors, extent.row(), (u.scale, u.packed_or))?;
        let wide = environment.interpolates() && planes.wide & Planes::WIDE_W != 0;
        (!wide).then_some(environment)
    }

    /// What the steps come to with these planes of the primary colour, in a row if there is one.
    #[inline(always)]
    fn of_planes<const K: usize, const FORMAT: u8>(
        texture: &LinearTexture<K, FORMAT>,
        planes: Option<&[Plane; 4]>,
        row: Option<f32>,
        (scale, or): (f32, u32),
    ) -> Option<Self> {
        let ([color, alpha], blend) = (texture.steps, texture.blend.map(|number| (number, scale)));
        let color = match color {
            EnvStep::Texel => None,
            EnvStep::Product => {
                let [r, g, b, _] = planes?;
                // A product with 1 is what it was.
                let white = [r, g, b].iter().all(|p| p.min == 1.0 && p.max == 1.0);
                (!white).then(|| [PlaneEval::new(r, row), PlaneEval::new(g, row), PlaneEval::new(b, row)])
            }
            EnvStep::Keep => return None,
        };
        // The texel's alpha is exactly 1 where it is not filtered.
        let one = FORMAT == RGB;
        let (alpha, constant) = match alpha {
            EnvStep::Texel if one => (Alpha::Constant, 1.0),
            EnvStep::Texel => (Alpha::Texel, 0.0),
            step => {
                let a = &planes?[3];
                let known = a.min == a.max;
                match step {
                    EnvStep::Product if !one && a.min == 1.0 && known => (Alpha::Texel, 0.0),
                    EnvStep::Product if !one => (Alpha::Product(PlaneEval::new(a, row)), 0.0),
                    _ if known => (Alpha::Constant, a.max),
                    _ => (Alpha::Primary(PlaneEval::new(a, row)), 0.0),
                }
            }
        };
        if blend.is_some() {
            let alpha = if let Alpha::Constant = alpha { Alpha::Primary(PlaneEval::constant(constant)) } else { alpha };
            return Some(Self { color, alpha, or, blend });
        }
        Some(Self { color, alpha, or: or | whole(255.0 * constant) << 24, blend })
    }

    /// Whether what is there before is blended with.
    #[inline(always)]
    pub fn blends(&self) -> bool {
        self.blend.is_some()
    }

    /// D, if coordinates (`divides`) or what is interpolated here are divided by it in `f32`.
    #[inline(always)]
    pub fn divisor(&self, divides: bool, planes: &Planes, extent: Extent) -> Option<LinearEval<f32>> {
        ((divides || self.interpolates()) && !planes.affine).then(|| LinearEval::new(&planes.d, extent.row()))
    }

    /// Whether it reads planes that are interpolated.
    fn interpolates(&self) -> bool {
        self.color.is_some() || matches!(self.alpha, Alpha::Product(_) | Alpha::Primary(_))
    }

    /// The pixels of texels in 0..=1; `rw` is 1 / D, or 1 where `even` says that w is the same everywhere.
    #[inline(always)]
    pub fn pixels<const N: usize, P: Positions<N>>(
        &self,
        texels: &mut [[f32; N]; 4],
        at: P,
        (rw, even): (&[f32; N], bool),
        below: &[u32; N],
        out: &mut [u32; N],
    ) {
        let [r, g, b, a] = texels;
        match &self.alpha {
            Alpha::Texel => {}
            Alpha::Product(plane) => {
                let primary = plane.at(at, rw, even);
                for i in 0..N {
                    a[i] *= primary[i];
                }
            }
            Alpha::Primary(plane) => *a = plane.at(at, rw, even),
            Alpha::Constant => *a = [0.0; N],
        }
        let or = self.or;
        if let Some((number, scale)) = self.blend {
            if let Some(planes) = &self.color {
                for (channel, plane) in [r, g, b].into_iter().zip(planes) {
                    let primary = plane.at(at, rw, even);
                    for i in 0..N {
                        channel[i] *= primary[i];
                    }
                }
            }
            return pair(texels, below, (scale, or), out, number);
        }
        if let Some([red, green, blue]) = &self.color {
            let red = red.at(at, rw, even);
            let green = green.at(at, rw, even);
            let blue = blue.at(at, rw, even);
            for i in 0..N {
                let (r, g, b) = (r[i] * red[i], g[i] * green[i], b[i] * blue[i]);
                out[i] = whole_pixel(255.0 * r, 255.0 * g, 255.0 * b, 255.0 * a[i]) | or;
            }
        } else {
            for i in 0..N {
                out[i] = whole_pixel(255.0 * r[i], 255.0 * g[i], 255.0 * b[i], 255.0 * a[i]) | or;
            }
        }
    }
}
