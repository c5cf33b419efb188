//! From the state to a vertex plan (OpenGL 1.5, chapter 2 from 2.11 on): which stages the draw needs, with which
//! uniforms. A stage whose result nothing needs is left out: no eye coordinates unless lighting, generation, fog or user
//! planes read them, no normal without a reader, no term of lighting that is black.

use super::batch::{MAX_SLOTS, VertexBatch, needs};
use super::cull::{CULL, CULLS};
use super::stages::VertFn;
use super::stages::normal::{NORMAL, NORMAL_UNIT, Rescale, normal_matrix};
use super::stages::triangle_corners::CORNER_POSITIONS;
use super::stages::{lighting, material, tex_coord, transform};
use super::uniforms::{LightUniforms, MaterialUniforms, UnitUniforms, VertexUniforms, ViewportUniforms};
use crate::fragment::planes::{Layout, UnitSlots};
use crate::num;
use crate::raster::vertex::outcode;
use crate::simd::{LANES, Level, Plan, Stage, Step};
use crate::state::State;
use crate::state::fog::{FogCoordSource, FogDistanceMode};
use crate::state::lighting::ColorControl;
use crate::state::lighting::MaterialColor;
use crate::state::lighting::ShadeModel;
use crate::state::lighting::{Light, Lighting, Material};
use crate::state::texture::TexGenMode;
use crate::state::texture::Unit;
use glam::{DMat4, DVec3};

/// What a draw wants of its vertices beyond the state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wants {
    /// Triangles are clipped to the whole view volume, not only where the rasteriser needs it: feedback, selection,
    /// polygons drawn as lines or points.
    pub exact_volume: bool,
    /// Edge flags matter.
    pub edges: bool,
}

/// The stages of a state and the uniforms that they work with.
#[derive(Clone, Debug)]
pub struct VertexPlan {
    /// The stages: those of the position, then those of the varyings.
    pub plan: Plan<VertFn>,
    /// How many stages are of the position: clip and window coordinates, outcode, point size. The others run only for
    /// vertices of primitives that may be visible.
    pub position_stages: usize,
    /// The stage that culls triangles.
    cull: Step<VertFn>,
    /// The stage before it for a batch of separate triangles: the positions of their corners.
    pub corner_positions: Step<VertFn>,
    /// The uniforms.
    pub uniforms: VertexUniforms,
    /// The attributes that the stages read, bits of [`needs`].
    pub needs: u32,
    /// The layout of the slots.
    pub layout: Layout,
    /// Flat shading.
    pub flat: bool,
    /// Outcode bits that make a triangle go through the clipper.
    pub clip_mask: u32,
    /// Scratch for the second half of the list, which is built first: it decides what the first half must compute.
    tail: Vec<Step<VertFn>>,
}

/// What the second half of the list needs from the first.
#[derive(Default)]
struct Requirements {
    eye: bool,
    point: bool,
    normal: bool,
    reflection: bool,
}

/// The step of a stage without an argument.
fn step(stage: &Stage<VertFn>, level: Level) -> Step<VertFn> {
    stage.step(level, 0)
}

impl VertexPlan {
    /// The stage that culls triangles, for what the sink [culls](crate::raster::PrimitiveSink::culls).
    #[must_use]
    pub fn cull(&self, culls: [bool; 2]) -> Step<VertFn> {
        let [positive, other] = [0, 1].map(|k: usize| if culls[k] { CULLS[k] } else { 0 });
        self.cull.with_arg(self.clip_mask | positive | other)
    }

    /// Runs some of its stages over a batch.
    pub fn run(&self, steps: &[Step<VertFn>], batch: &mut VertexBatch) {
        batch.n = batch.n.min(LANES);
        batch.span = batch.n.next_multiple_of(16).min(LANES);
        for step in steps {
            #[expect(unsafe_code, reason = "stages of a plan are compiled for a level that the processor has")]
            unsafe {
                (step.run())(batch, &self.uniforms, step.arg);
            }
        }
    }

    /// The plan of no state, for an instruction set.
    #[must_use]
    pub fn new(level: Level) -> Self {
        Self {
            plan: Plan::new(level),
            position_stages: 0,
            cull: step(&CULL, level),
            corner_positions: step(&CORNER_POSITIONS, level),
            uniforms: VertexUniforms::default(),
            needs: 0,
            layout: Layout::default(),
            flat: false,
            clip_mask: outcode::NEEDS_CLIP,
            tail: Vec::new(),
        }
    }

    /// Makes this the plan of a state and a layout. Nothing is allocated once the lists have grown.
    pub fn build(&mut self, state: &State, layout: &Layout, wants: Wants) {
        self.plan.steps.clear();
        self.layout.clone_from(layout);
        self.needs = if wants.edges { needs::EDGE } else { 0 };
        self.flat = state.lighting.shade_model == ShadeModel::Flat;
        self.clip_mask = outcode::NEEDS_CLIP | if wants.exact_volume { outcode::FRUSTUM } else { 0 };
        self.matrices(state);
        let mut tail = Plan::new(self.plan.level());
        std::mem::swap(&mut tail.steps, &mut self.tail);
        let mut r = Requirements::default();
        let lit = state.lighting.enabled && (layout.color.is_some() || layout.secondary.is_some());
        if lit {
            self.lighting(&mut tail, &state.lighting, layout, &mut r);
        } else {
            self.own_colors(&mut tail, layout);
        }
        self.fog(&mut tail, state, layout, &mut r);
        for (unit, slots) in layout.units.iter().enumerate() {
            if let Some(slots) = slots {
                self.unit(&mut tail, unit, *slots, state, &mut r);
            }
        }
        self.position_stages(state);
        if r.eye || r.point {
            self.plan.push(&transform::EYE, 0);
        }
        if r.point {
            self.plan.push(&transform::EYE_POINT, 0);
        }
        if r.normal {
            self.needs |= needs::NORMAL;
            let each = state.transform.normalize;
            self.plan.push(if each { &NORMAL_UNIT } else { &NORMAL }, 0);
        }
        if r.reflection {
            self.plan.push(&tex_coord::REFLECTION, 0);
        }
        self.plan.steps.append(&mut tail.steps);
        self.tail = tail.steps;
    }

    fn matrices(&mut self, state: &State) {
        let t = &state.transform;
        let u = &mut self.uniforms;
        let modelview = *t.modelview.top();
        u.to_eye = modelview.to_cols_array_2d();
        u.to_clip = product(t.projection.top(), &modelview);
        u.eye_affine = modelview.row(3).to_array() == [0.0, 0.0, 0.0, 1.0];
        let rescale = match (t.normalize, t.rescale_normal) {
            (true, _) => Rescale::Each,
            (false, true) => Rescale::Matrix,
            (false, false) => Rescale::None,
        };
        u.to_normal = normal_matrix(&modelview, rescale);
        u.viewport = viewport(state);
        u.user_count = 0;
        for (i, (plane, enabled)) in t.clip_planes.iter().zip(t.clip_plane_enabled).enumerate() {
            if enabled {
                u.user[u.user_count] = plane.map(|v| if v.is_finite() { v } else { 0.0 });
                u.user_bit[u.user_count] = outcode::USER << i;
                u.user_count += 1;
            }
        }
    }

    fn own_colors(&mut self, tail: &mut Plan<VertFn>, layout: &Layout) {
        if let Some(slot) = layout.color {
            self.needs |= needs::COLOR;
            self.uniforms.color_slot = [slot; 2];
            tail.push(&material::COLOR, 0);
        }
        if let Some(slot) = layout.secondary {
            self.needs |= needs::SECONDARY;
            self.uniforms.secondary_slot = [slot; 2];
            tail.push(&material::SECONDARY, 0);
        }
    }

    fn fog(&mut self, tail: &mut Plan<VertFn>, state: &State, layout: &Layout, r: &mut Requirements) {
        let Some(slot) = layout.fog else { return };
        self.uniforms.fog_slot = slot;
        if state.fog.coord_source == FogCoordSource::FogCoord {
            self.needs |= needs::FOG;
            tail.push(&transform::FOG_COORD, 0);
        } else {
            r.eye = true;
            let stage = match state.fog.distance_mode {
                FogDistanceMode::EyePlaneAbsolute | FogDistanceMode::EyePlane => &transform::FOG_PLANE,
                FogDistanceMode::EyeRadial => &transform::FOG_RADIAL,
            };
            tail.push(stage, 0);
        }
    }

    /// The stages of the position. The others read what these leave in the batch only if all its vertices run through both.
    fn position_stages(&mut self, state: &State) {
        let p = &state.point;
        self.uniforms.point = [p.size, p.size_min, p.size_max];
        self.uniforms.point_attenuation = p.distance_attenuation;
        let distance = p.distance_attenuation != [1.0, 0.0, 0.0];
        self.plan.push(&transform::CLIP, 0);
        self.plan.push(&transform::WINDOW, 0);
        if distance || self.uniforms.user_count > 0 {
            self.plan.push(&transform::EYE, 0);
        }
        for k in 0..self.uniforms.user_count {
            self.plan.push(&transform::USER_PLANE, k as u32);
        }
        if distance {
            self.plan.push(&transform::EYE_POINT, 0);
        }
        self.plan.push(if distance { &transform::POINT_DISTANCE } else { &transform::POINT_SIZE }, 0);
        self.position_stages = self.plan.steps.len();
    }

    /// Stages of a unit (section 2.11.4): generation of the coordinates that the layout takes, then the matrix.
    fn unit(&mut self, tail: &mut Plan<VertFn>, unit: usize, slots: UnitSlots, state: &State, r: &mut Requirements) {
        let (Some(numbers), Some(source)) = (self.uniforms.units.get_mut(unit), state.texture.units.get(unit)) else {
            return;
        };
        let Some(matrix) = state.transform.texture.get(unit).map(|stack| *stack.top()) else { return };
        *numbers = UnitUniforms {
            planes: planes(source),
            matrix: without_whole_periods(matrix, slots).to_cols_array_2d(),
            base: slots.base,
            count: slots.count,
            has_q: slots.has_q,
        };
        let identity = numbers.matrix == DMat4::IDENTITY.to_cols_array_2d();
        // Without a matrix a coordinate that no slot takes plays no part.
        let taken = |c: usize| !identity || c < slots.count || (c == 3 && slots.has_q);
        let generated = |c: usize| source.generation[c].enabled && taken(c);
        if !(0..4).all(|c| generated(c) || !taken(c)) {
            self.needs |= needs::TEX << unit;
        }
        if identity && !(0..4).any(generated) {
            tail.push(&tex_coord::TEX_COPY, tex_coord::arg(unit, 0));
            return;
        }
        if !(0..4).all(generated) {
            tail.push(&tex_coord::TEX_LOAD, tex_coord::arg(unit, 0));
        }
        for (c, generation) in source.generation.iter().enumerate().filter(|(c, _)| generated(*c)) {
            let stage = match generation.mode {
                // No command lets such a mode in.
                mode if c >= mode.coordinates() => &tex_coord::GEN_EYE,
                TexGenMode::ObjectLinear => &tex_coord::GEN_OBJECT,
                TexGenMode::SphereMap => &tex_coord::GEN_SPHERE,
                TexGenMode::ReflectionMap => &tex_coord::GEN_REFLECTION,
                TexGenMode::NormalMap => &tex_coord::GEN_NORMAL,
                TexGenMode::EyeLinear => &tex_coord::GEN_EYE,
            };
            r.eye |= generation.mode == TexGenMode::EyeLinear;
            r.normal |= generation.mode == TexGenMode::NormalMap;
            if matches!(generation.mode, TexGenMode::SphereMap | TexGenMode::ReflectionMap) {
                (r.point, r.normal, r.reflection) = (true, true, true);
            }
            tail.push(stage, tex_coord::arg(unit, c));
        }
        let store = if identity { &tex_coord::TEX_STORE } else { &tex_coord::TEX_MATRIX };
        tail.push(store, tex_coord::arg(unit, 0));
    }

    /// Stages of lighting (section 2.14.1), only the terms that are not black.
    fn lighting(&mut self, tail: &mut Plan<VertFn>, s: &Lighting, layout: &Layout, r: &mut Requirements) {
        let u = &mut self.uniforms;
        u.color_slot = [layout.color.unwrap_or(MAX_SLOTS), layout.back.unwrap_or(MAX_SLOTS)];
        u.secondary_slot = [layout.secondary.unwrap_or(0), layout.back.map_or(0, |slot| slot + 4)];
        u.two_side = layout.back.is_some();
        let track = tracking(s);
        if track != [0; 2] {
            self.needs |= needs::COLOR;
        }
        let separate = s.model.color_control == ColorControl::SeparateSpecularColor;
        let secondary_taken = layout.secondary.is_some();
        let shown = [true, u.two_side];
        let any = |f: &dyn Fn(&Material, u32) -> bool| {
            s.materials.iter().zip(track).zip(shown).any(|((m, t), shown)| shown && f(m, t))
        };
        let specular_material = (!separate || secondary_taken)
            && any(&|m, t| t & material::flag::TRACK_SPECULAR != 0 || !black(&m.specular));
        let diffuse_material = any(&|m, t| t & material::flag::TRACK_DIFFUSE != 0 || !black(&m.diffuse));

        u.ambient = rgb(&s.model.ambient);
        tail.push(&lighting::LIGHT_CLEAR, 0);
        let (mut ambient_varies, mut specular) = (false, false);
        let mut viewer = false;
        for (i, light) in s.lights.iter().enumerate().filter(|(_, light)| light.enabled) {
            let (numbers, mut flags) = light_uniforms(light, s.model.local_viewer);
            u.lights[i] = numbers;
            flags |= i as u32;
            let attenuated = flags & lighting::flag::ATTENUATED != 0;
            let shines = specular_material && !black(&light.specular);
            if attenuated {
                r.point = true;
                tail.push(&lighting::LIGHT_LOCAL, flags);
                if !black(&light.ambient) {
                    ambient_varies = true;
                    tail.push(&lighting::LIGHT_AMBIENT, flags);
                }
            } else {
                u.ambient = std::array::from_fn(|c| u.ambient[c] + light.ambient[c]);
            }
            if shines || (diffuse_material && !black(&light.diffuse)) {
                r.normal = true;
                tail.push(&lighting::LIGHT_DIFFUSE, flags);
            }
            if shines {
                specular = true;
                if s.model.local_viewer && !viewer {
                    viewer = true;
                    r.point = true;
                    tail.push(&lighting::VIEWER, 0);
                }
                tail.push(&lighting::LIGHT_SPECULAR, flags);
            }
        }
        for face in 0..if u.two_side { 2 } else { 1 } {
            u.materials[face] = material_uniforms(&s.materials[face], &u.ambient);
            let flags = face as u32
                | track[face]
                | if separate && secondary_taken { material::flag::SEPARATE } else { 0 }
                | if specular { material::flag::SPECULAR } else { 0 }
                | if ambient_varies { material::flag::AMBIENT } else { 0 };
            tail.push(&material::MATERIAL, flags);
            if secondary_taken && !separate {
                tail.push(&material::SECONDARY_ZERO, face as u32);
            }
        }
    }
}

fn black(color: &[f32; 4]) -> bool {
    color[..3] == [0.0; 3]
}

fn rgb(color: &[f32; 4]) -> [f32; 3] {
    [color[0], color[1], color[2]]
}

/// The product of two matrices with sums in written order.
fn product(a: &DMat4, b: &DMat4) -> [[f64; 4]; 4] {
    let (a, b) = (a.to_cols_array_2d(), b.to_cols_array_2d());
    b.map(|column| {
        std::array::from_fn(|r| a[0][r] * column[0] + a[1][r] * column[1] + a[2][r] * column[2] + a[3][r] * column[3])
    })
}

fn viewport(state: &State) -> ViewportUniforms {
    let v = &state.viewport;
    let half = [f64::from(v.width) / 2.0, f64::from(v.height) / 2.0];
    let corner = [v.x, v.y];
    let size = [v.width, v.height];
    ViewportUniforms {
        half,
        center: std::array::from_fn(|i| f64::from(corner[i]) + half[i]),
        center_snapped: std::array::from_fn(|i| corner[i].wrapping_mul(256).wrapping_add(size[i].wrapping_mul(128))),
        depth_half: (v.far - v.near) / 2.0,
        depth_center: (v.far + v.near) / 2.0,
    }
}

/// The planes of each coordinate, those of the mode that it has; what is not finite counts as 0.
fn planes(unit: &Unit) -> [[f64; 4]; 4] {
    std::array::from_fn(|c| {
        let g = &unit.generation[c];
        let plane = if g.mode == TexGenMode::ObjectLinear { g.object_plane } else { g.eye_plane };
        plane.map(|v| if v.is_finite() { v } else { 0.0 })
    })
}

/// The texture matrix without whole periods of a repeating texture in its translation, so that f32 slots keep the fraction
/// of a scroll that has run for hours. Only where the matrix leaves q as it is.
fn without_whole_periods(mut m: DMat4, slots: UnitSlots) -> DMat4 {
    if m.row(3).to_array() != [0.0, 0.0, 0.0, 1.0] || slots.cube {
        return m;
    }
    let mut translation = m.w_axis.to_array();
    for (t, period) in translation.iter_mut().zip(slots.period).take(slots.count.min(3)) {
        let period = f64::from(period);
        if period > 0.0 && t.is_finite() && t.abs() >= period {
            *t -= (*t / period).trunc() * period;
        }
    }
    m.w_axis = translation.into();
    m
}

/// Which properties of each face the vertex colour replaces, as bits of [`material::flag`].
fn tracking(s: &Lighting) -> [u32; 2] {
    use material::flag::{TRACK_AMBIENT, TRACK_DIFFUSE, TRACK_EMISSION, TRACK_SPECULAR};
    if !s.color_material {
        return [0; 2];
    }
    let bits = match s.color_material_mode {
        MaterialColor::Emission => TRACK_EMISSION,
        MaterialColor::Ambient => TRACK_AMBIENT,
        MaterialColor::Diffuse => TRACK_DIFFUSE,
        MaterialColor::Specular => TRACK_SPECULAR,
        MaterialColor::AmbientAndDiffuse => TRACK_AMBIENT | TRACK_DIFFUSE,
    };
    s.color_material_face.chosen().map(|chosen| if chosen { bits } else { 0 })
}

fn material_uniforms(m: &Material, ambient: &[f32; 3]) -> MaterialUniforms {
    MaterialUniforms {
        base: std::array::from_fn(|c| m.emission[c] + ambient[c] * m.ambient[c]),
        emission: rgb(&m.emission),
        ambient: rgb(&m.ambient),
        diffuse: m.diffuse,
        specular: rgb(&m.specular),
        shininess: m.shininess,
    }
}

fn unit_f32(v: DVec3) -> [f32; 3] {
    let length = v.dot(v).sqrt();
    if length > 0.0 && length.is_finite() { (v / length).to_array().map(|c| c as f32) } else { [0.0; 3] }
}

/// A light's numbers and the flags of its stages.
fn light_uniforms(l: &Light, local_viewer: bool) -> (LightUniforms, u32) {
    use lighting::flag::{ATTENUATED, DISTANCE, EXPONENT, LOCAL_LIGHT, LOCAL_VIEWER, SPOT};
    let [x, y, z, w] = l.position;
    let toward = DVec3::new(x, y, z);
    let local = w != 0.0;
    let direction = DVec3::from_array(unit_f32(toward).map(f64::from));
    let spot = l.spot_cutoff != 180.0;
    let numbers = LightUniforms {
        ambient: rgb(&l.ambient),
        diffuse: rgb(&l.diffuse),
        specular: rgb(&l.specular),
        position: if local { (toward / w).to_array() } else { [0.0; 3] },
        direction: unit_f32(toward),
        half: unit_f32(direction + DVec3::Z),
        attenuation: l.attenuation,
        spot_direction: unit_f32(DVec3::from_array(l.spot_direction)),
        spot_cos: if spot { num::sin_cos_deg(f64::from(l.spot_cutoff)).1 as f32 } else { -2.0 },
        spot_exponent: l.spot_exponent,
    };
    let bit = |on: bool, bit: u32| if on { bit } else { 0 };
    let flags = bit(local || spot, ATTENUATED)
        | bit(local, LOCAL_LIGHT)
        | bit(local && l.attenuation != [1.0, 0.0, 0.0], DISTANCE)
        | bit(spot, SPOT)
        | bit(spot && l.spot_exponent != 0.0, EXPONENT)
        | bit(local_viewer, LOCAL_VIEWER);
    (numbers, flags)
}
