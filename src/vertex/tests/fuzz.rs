//! Random states and vertices, wild numbers among them: nothing panics, what comes out is in range, and every level and
//! batch cut gives the same bits.

use super::*;
use crate::limits::MAX_TEXTURE_UNITS;
use crate::state::fog::{FogCoordSource, FogDistanceMode};
use crate::state::lighting::ColorControl;
use crate::state::lighting::MaterialColor;
use crate::state::lighting::ShadeModel;
use crate::state::primitive::PrimitiveMode;
use crate::state::raster::Face;
use crate::state::texture::TexGenMode;
use crate::vertex::batch::MAX_SLOTS;
use glam::DMat4;

/// Numbers that look random and are the same every time.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as u32
    }

    fn chance(&mut self, one_in: u32) -> bool {
        self.bits().is_multiple_of(one_in)
    }

    fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.bits() as usize % of.len()]
    }

    /// Mostly in -2..2, now and then something extreme.
    fn number(&mut self) -> f32 {
        match self.bits() % 64 {
            0 => self.pick(&[f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, 1e-42, -0.0]),
            1 | 2 => self.pick(&[0.0, 1.0, -1.0, 1e20, -1e-20, 1e6]),
            _ => self.bits() as f32 / (1u32 << 29) as f32 - 2.0,
        }
    }

    fn numbers<const N: usize>(&mut self) -> [f32; N] {
        std::array::from_fn(|_| self.number())
    }

    fn wide<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| f64::from(self.number()))
    }

    fn matrix(&mut self) -> DMat4 {
        match self.bits() % 4 {
            0 => DMat4::IDENTITY,
            1 => DMat4::from_cols_array(&[
                1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.5, -1.0, 0.0, 0.0, -1.0, 0.0,
            ]),
            _ => DMat4::from_cols_array(&self.wide()),
        }
    }

    fn state(&mut self) -> State {
        let mut s = plain_state();
        s.viewport.x = self.pick(&[0, -7, 20000, -40000, i32::MAX]);
        *s.transform.modelview.top_mut() = self.matrix();
        *s.transform.projection.top_mut() = self.matrix();
        s.transform.normalize = self.chance(2);
        s.transform.rescale_normal = self.chance(2);
        for i in 0..6 {
            s.transform.clip_plane_enabled[i] = self.chance(8);
            s.transform.clip_planes[i] = self.wide();
        }
        s.point.distance_attenuation = self.pick(&[[1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.5, 1.0, 2.0]]);
        s.fog.distance_mode = self.pick(&FogDistanceMode::ALL);
        s.fog.coord_source = self.pick(&[FogCoordSource::FogCoord, FogCoordSource::FragmentDepth]);
        let l = &mut s.lighting;
        l.enabled = self.chance(2);
        l.shade_model = self.pick(&ShadeModel::ALL);
        l.color_material = self.chance(2);
        l.color_material_face = self.pick(&Face::ALL);
        l.color_material_mode = self.pick(&MaterialColor::ALL);
        l.model.local_viewer = self.chance(2);
        l.model.color_control = self.pick(&ColorControl::ALL);
        for light in &mut l.lights {
            light.enabled = self.chance(3);
            light.diffuse = self.numbers();
            light.specular = self.numbers();
            light.position = self.wide();
            light.position[3] = self.pick(&[0.0, 1.0]);
            light.spot_direction = self.wide();
            light.spot_cutoff = self.pick(&[180.0, 90.0, 30.0, 0.0]);
            light.spot_exponent = self.pick(&[0.0, 5.0, 128.0]);
            light.attenuation = self.pick(&[[1.0, 0.0, 0.0], [0.0; 3], [0.5, 0.25, 0.125]]);
        }
        for material in &mut l.materials {
            material.specular = self.numbers();
            material.shininess = self.pick(&[0.0, 1.0, 20.5, 128.0]);
        }
        for unit in 0..MAX_TEXTURE_UNITS {
            *s.transform.texture[unit].top_mut() = self.matrix();
            for generation in &mut s.texture.units[unit].generation {
                generation.enabled = self.chance(2);
                generation.mode = self.pick(&TexGenMode::ALL);
                generation.object_plane = self.wide();
                generation.eye_plane = self.wide();
            }
        }
        s
    }

    fn layout(&mut self, lit: bool) -> Layout {
        let mut layout = Layout::default();
        let mut count = 0;
        let mut take = |n: usize| {
            count += n;
            count - n
        };
        layout.color = Some(take(4));
        layout.secondary = self.chance(2).then(|| take(3));
        layout.fog = self.chance(2).then(|| take(1));
        for unit in &mut layout.units {
            if self.chance(3) {
                let n = self.pick(&[1, 2, 3]);
                let has_q = self.chance(2);
                *unit = Some(UnitSlots {
                    base: take(n + usize::from(has_q)),
                    count: n,
                    has_q,
                    period: [1, 2, 0],
                    size: [8; 3],
                    cube: false,
                });
            }
        }
        layout.count = count;
        layout.stride = count;
        if lit && self.chance(2) {
            layout.back = Some(count);
            layout.stride += if layout.secondary.is_some() { 7 } else { 4 };
        }
        assert!(layout.stride <= MAX_SLOTS);
        layout
    }
}

#[test]
fn random_states_and_vertices_agree_everywhere() {
    let mut random = Random(2003);
    let mut primitives = 0;
    for _ in 0..400 {
        let state = random.state();
        let layout = random.layout(state.lighting.enabled);
        let mode = random.pick(&PrimitiveMode::ALL);
        let given: Vec<Given> = (0..random.bits() % 90)
            .map(|_| {
                let mut v = at(0.0, 0.0, 0.0);
                v.position = random.numbers();
                if random.chance(2) {
                    v.position[3] = 1.0;
                }
                v.current.color = random.numbers();
                v.current.normal = random.numbers();
                v.current.secondary_color = random.numbers();
                v.current.fog_coord = random.number();
                v.current.edge_flag = random.chance(2);
                v.current.tex_coord = std::array::from_fn(|_| random.numbers());
                v
            })
            .collect();
        let want = format!("{:?}", run(Level::BASELINE, 64, &state, &layout, mode, &given));
        for level in Level::available() {
            let cut = random.pick(&[1, 3, 16, 50, 64]);
            let got = run(level, cut, &state, &layout, mode, &given);
            assert!(format!("{got:?}") == want, "{level:?}, cut {cut}, mode {mode:?}");
            for primitive in got {
                primitives += 1;
                let vertices = match primitive {
                    Got::Triangle(v, ..) | Got::Line(v, ..) => v,
                    Got::Point(v) => vec![v],
                };
                for (v, slots) in vertices {
                    assert!(v.window.iter().all(|c| c.is_finite()) && v.clip[3] > 0.0, "{v:?}");
                    assert!(v.snapped.iter().all(|c| c.abs() < 1 << 23), "{v:?}");
                    assert_eq!(slots.len(), layout.stride);
                    assert!(slots.iter().all(|s| s.is_finite()), "{slots:?}");
                    assert!(slots[..4].iter().all(|s| (0.0..=1.0).contains(s)), "{slots:?}");
                    assert!(v.point_size.is_finite(), "{v:?}");
                }
            }
        }
    }
    assert!(primitives > 2000, "only {primitives} primitives were seen");
}
