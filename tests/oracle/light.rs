//! Lighting (OpenGL 1.5, section 2.14): the state of materials, lights and the light model, the lighting equation for one
//! side of a vertex, colour material. Positions and spot directions are in eye coordinates, as GL keeps them:
//! [`Light::place`] and [`Light::aim`] transform what the application gives.

use super::matrix::M4;
use super::vertex::over_w;
use super::{V3, V4, add, clamp01, dot, length, mul, normalize, scale, sub};
use fixedgl::enums::*;

/// Table 2.10, material.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    pub ambient: V4,
    pub diffuse: V4,
    pub specular: V4,
    pub emission: V4,
    pub shininess: f64,
}

impl Default for Material {
    fn default() -> Self {
        Material {
            ambient: [0.2, 0.2, 0.2, 1.0],
            diffuse: [0.8, 0.8, 0.8, 1.0],
            specular: [0.0, 0.0, 0.0, 1.0],
            emission: [0.0, 0.0, 0.0, 1.0],
            shininess: 0.0,
        }
    }
}

/// Table 2.10, one light.
#[derive(Clone, Copy, Debug)]
pub struct Light {
    pub ambient: V4,
    pub diffuse: V4,
    pub specular: V4,
    /// Eye coordinates.
    pub position: V4,
    /// Eye coordinates.
    pub spot_direction: V3,
    pub spot_exponent: f64,
    pub spot_cutoff: f64,
    pub attenuation: V3,
}

impl Default for Light {
    fn default() -> Self {
        Light {
            ambient: [0.0, 0.0, 0.0, 1.0],
            diffuse: [1.0; 4],
            specular: [1.0; 4],
            position: [0.0, 0.0, 1.0, 0.0],
            spot_direction: [0.0, 0.0, -1.0],
            spot_exponent: 0.0,
            spot_cutoff: 180.0,
            attenuation: [1.0, 0.0, 0.0],
        }
    }
}

impl Light {
    /// Light(.., POSITION, p) under the model-view matrix of the time.
    pub fn place(mut self, position: V4, modelview: M4) -> Light {
        self.position = modelview.apply(position);
        self
    }

    /// Light(.., SPOT_DIRECTION, d): the upper leftmost 3 x 3 matrix transforms it.
    pub fn aim(mut self, d: V3, modelview: M4) -> Light {
        self.spot_direction = std::array::from_fn(|i| dot(&modelview.0[i][..3], &d));
        self
    }
}

/// The lighting state.
#[derive(Clone, Debug)]
pub struct Lighting {
    /// The enabled lights.
    pub lights: Vec<Light>,
    pub scene_ambient: V4,
    pub local_viewer: bool,
    pub two_side: bool,
    pub separate_specular: bool,
    pub front: Material,
    pub back: Material,
    /// ColorMaterial(face, mode), when COLOR_MATERIAL is enabled.
    pub color_material: Option<(GLenum, GLenum)>,
}

impl Default for Lighting {
    fn default() -> Self {
        Lighting {
            lights: vec![Light::default()],
            scene_ambient: [0.2, 0.2, 0.2, 1.0],
            local_viewer: false,
            two_side: false,
            separate_specular: false,
            front: Material::default(),
            back: Material::default(),
            color_material: None,
        }
    }
}

fn rgb(c: V4) -> V3 {
    [c[0], c[1], c[2]]
}

/// The unit vector from P1 to P2 (the VP with an arrow over it of 2.14.1).
fn towards(p1: V4, p2: V4) -> V3 {
    if p1[3] != 0.0 && p2[3] != 0.0 {
        normalize(sub(over_w(p2), over_w(p1)))
    } else if p1[3] != 0.0 {
        normalize([p2[0], p2[1], p2[2]])
    } else {
        normalize([-p1[0], -p1[1], -p1[2]])
    }
}

/// Equations 2.4 and 2.5: the primary and secondary colour of one side, before clamping.
pub fn light_equation(l: &Lighting, m: &Material, eye: V4, n: V3) -> [V3; 2] {
    let mut primary = add(rgb(m.emission), mul(rgb(m.ambient), rgb(l.scene_ambient)));
    let mut secondary = [0.0; 3];
    let positive = |x: f64| x.max(0.0);
    for light in &l.lights {
        let vp = towards(eye, light.position);
        let att = if light.position[3] != 0.0 {
            let d = length(&sub(over_w(light.position), over_w(eye)));
            1.0 / (light.attenuation[0] + light.attenuation[1] * d + light.attenuation[2] * d * d)
        } else {
            1.0
        };
        let spot = if light.spot_cutoff == 180.0 {
            1.0
        } else {
            let cos = positive(-dot(&vp, &normalize(light.spot_direction)));
            if cos >= light.spot_cutoff.to_radians().cos() { cos.powf(light.spot_exponent) } else { 0.0 }
        };
        let n_vp = positive(dot(&n, &vp));
        let to_eye = if l.local_viewer { towards(eye, [0.0, 0.0, 0.0, 1.0]) } else { [0.0, 0.0, 1.0] };
        let h = normalize(add(vp, to_eye));
        let f = if n_vp != 0.0 { 1.0 } else { 0.0 };
        let ambient = mul(rgb(m.ambient), rgb(light.ambient));
        let diffuse = scale(mul(rgb(m.diffuse), rgb(light.diffuse)), n_vp);
        let shine = f * positive(dot(&n, &h)).powf(m.shininess);
        let specular = scale(mul(rgb(m.specular), rgb(light.specular)), shine);
        primary = add(primary, scale(add(ambient, diffuse), att * spot));
        let target = if l.separate_specular { &mut secondary } else { &mut primary };
        *target = add(*target, scale(specular, att * spot));
    }
    [primary, secondary]
}

/// ColorMaterial: the material with the tracked parameters replaced by the current colour.
pub fn tracked(mut m: Material, mode: GLenum, color: V4) -> Material {
    match mode {
        GL_EMISSION => m.emission = color,
        GL_AMBIENT => m.ambient = color,
        GL_DIFFUSE => m.diffuse = color,
        GL_SPECULAR => m.specular = color,
        GL_AMBIENT_AND_DIFFUSE => (m.ambient, m.diffuse) = (color, color),
        other => panic!("the oracle has no colour material mode {other:#x}"),
    }
    m
}

/// Lighting of one side of a vertex: clamped colours, alpha that of the material's diffuse colour.
pub fn lit(l: &Lighting, material: Material, eye: V4, n: V3) -> [V4; 2] {
    let [p, s] = light_equation(l, &material, eye, n);
    [clamp01([p[0], p[1], p[2], material.diffuse[3]]), clamp01([s[0], s[1], s[2], 0.0])]
}

#[cfg(test)]
mod tests {
    use super::super::assert_near;
    use super::*;

    #[test]
    fn a_spot_with_attenuation_by_hand() {
        // The light 2 above the point shines straight down: distance 2, attenuation 1/(1 + 2 * 0.5 + 4 * 0.25) = 1/3.
        let spot = Light {
            position: [0.0, 0.0, 2.0, 1.0],
            spot_cutoff: 45.0,
            spot_exponent: 2.0,
            attenuation: [1.0, 0.5, 0.25],
            specular: [0.0; 4],
            ..Light::default()
        };
        let mut l = Lighting { lights: vec![spot], scene_ambient: [0.0; 4], ..Lighting::default() };
        let n = [0.0, 0.0, 1.0];
        let [p, _] = light_equation(&l, &Material::default(), [0.0, 0.0, 0.0, 1.0], n);
        assert_near(&p, &[0.8 / 3.0; 3], 1e-12);
        // At x = 1 the cosine is 2/sqrt 5, within the cone: distance sqrt 5; spot = cos^2 = 0.8, n . vp = 2/sqrt 5.
        let d = 5f64.sqrt();
        let want = 0.8 * (2.0 / d) * 0.8 / (1.0 + 0.5 * d + 0.25 * 5.0);
        let [p, _] = light_equation(&l, &Material::default(), [1.0, 0.0, 0.0, 1.0], n);
        assert_near(&p, &[want; 3], 1e-12);
        // At x = 3 it is outside the cone.
        let [p, _] = light_equation(&l, &Material::default(), [3.0, 0.0, 0.0, 1.0], n);
        assert_near(&p, &[0.0; 3], 0.0);
        // Shininess 0 is 0^0 = 1 where the light reaches the front, 0 where it does not.
        l.lights[0] = Light { spot_cutoff: 180.0, attenuation: [1.0, 0.0, 0.0], specular: [1.0; 4], ..spot };
        let shiny = Material { specular: [0.5; 4], diffuse: [0.0; 4], shininess: 0.0, ..Material::default() };
        let [p, _] = light_equation(&l, &shiny, [0.0, 0.0, 0.0, 1.0], n);
        assert_near(&p, &[0.5; 3], 1e-12);
        let [p, _] = light_equation(&l, &shiny, [0.0, 0.0, 0.0, 1.0], [0.0, 0.0, -1.0]);
        assert_near(&p, &[0.0; 3], 0.0);
    }
}
