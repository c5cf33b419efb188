//! Evaluators (OpenGL 1.5, section 5.1): maps are kept without gaps between their control points; an evaluation makes a
//! vertex with the values of the enabled maps in place of the current ones, which stay as they are. Meshes are made of
//! evaluations, as the specification writes them.

use super::Values;
use super::engine::{Engine, Primitive};
use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_operation, invalid_value, not_one, out_of_memory};
use crate::limits::MAX_EVAL_ORDER;
use crate::num::bernstein::{Bernstein, curve, surface};
use crate::state::current::Current;
use crate::state::eval::{COMPONENTS, EvalMap, MAPS, kind, map1_kind, map2_kind};

/// Most points of a mesh: one call may take a second, not hours.
const MOST_POINTS: u64 = 1 << 20;

/// What a point of a mesh counts in [`Engine::pixels_written`]: a vertex, and its polynomials.
const PIXELS_OF_A_POINT: u64 = 64;

/// What the specification asks of the numbers of a map along one parameter.
fn check_axis([from, to]: [f64; 2], stride: i32, order: i32, components: usize) -> Outcome<usize> {
    let count = usize::try_from(order).unwrap_or(0);
    if !(1..=MAX_EVAL_ORDER).contains(&count) {
        return Err(invalid_value(format!("an order of {order}; it must be 1 to {MAX_EVAL_ORDER}")));
    }
    if from == to {
        return Err(invalid_value(format!("a domain from {from} to {to}; its ends must differ")));
    }
    if usize::try_from(stride).map_or(true, |stride| stride < components) {
        return Err(invalid_value(format!("a stride of {stride} for points of {components} numbers")));
    }
    Ok(count)
}

/// A parameter as a fraction of a domain.
fn fraction(t: f64, [from, to]: [f64; 2]) -> f64 {
    (t - from) / (to - from)
}

/// A point of a grid; the ends are exact.
fn grid_point((count, from, to): (i32, f64, f64), i: i32) -> f64 {
    match i {
        0 => from,
        _ if i == count => to,
        _ => f64::from(i) * ((to - from) / f64::from(count)) + from,
    }
}

/// The values of the enabled maps of one dimension at one place.
struct Evaluated {
    current: Current,
    vertex: [f32; 4],
}

/// The enabled map that counts among those of one value: the one with the most components.
fn last_enabled(enabled: &[bool; MAPS], kinds: std::ops::Range<usize>) -> Option<usize> {
    kinds.rev().find(|kind| enabled[*kind])
}

/// Values of the enabled maps over the current ones; `None` without a vertex map. `at` gives the components of a map.
fn evaluated(enabled: &[bool; MAPS], current: &Current, at: impl Fn(usize) -> [f64; 4]) -> Option<Evaluated> {
    let floats = |kind: usize| at(kind).map(|v| v as f32);
    let vertex_kind = last_enabled(enabled, kind::VERTEX..MAPS)?;
    let [x, y, z, w] = floats(vertex_kind);
    let vertex = [x, y, z, if COMPONENTS[vertex_kind] == 4 { w } else { 1.0 }];
    let mut current = *current;
    if enabled[kind::COLOR] {
        current.color = floats(kind::COLOR);
    }
    if enabled[kind::NORMAL] {
        let [x, y, z, _] = floats(kind::NORMAL);
        current.normal = [x, y, z];
    }
    if let Some(kind) = last_enabled(enabled, kind::TEX_COORD..kind::VERTEX) {
        let mut coordinates = [0.0, 0.0, 0.0, 1.0];
        coordinates.iter_mut().zip(floats(kind)).take(COMPONENTS[kind]).for_each(|(to, from)| *to = from);
        current.tex_coord[0] = coordinates;
    }
    Some(Evaluated { current, vertex })
}

/// `N` numbers and zeros behind them.
fn padded<const N: usize>(values: [f64; N]) -> [f64; 4] {
    std::array::from_fn(|i| values.get(i).copied().unwrap_or(0.0))
}

/// The components of a curve, and zeros.
fn curve_at(map: &EvalMap<1>, components: usize, u: f64) -> [f64; 4] {
    let u = Bernstein::new(map.order[0], fraction(u, map.domain[0]));
    match components {
        1 => padded(curve::<1>(&map.points, &u)),
        2 => padded(curve::<2>(&map.points, &u)),
        3 => padded(curve::<3>(&map.points, &u)),
        _ => curve(&map.points, &u),
    }
}

/// The components of a surface and their derivatives by u and by v, and zeros.
fn surface_at(map: &EvalMap<2>, components: usize, [u, v]: [f64; 2]) -> [[f64; 4]; 3] {
    let [du, dv] = map.domain;
    let (b, c) = (Bernstein::new(map.order[0], fraction(u, du)), Bernstein::new(map.order[1], fraction(v, dv)));
    let [at, by_u, by_v] = match components {
        1 => surface::<1>(&map.points, &b, &c).map(padded),
        2 => surface::<2>(&map.points, &b, &c).map(padded),
        3 => surface::<3>(&map.points, &b, &c).map(padded),
        _ => surface(&map.points, &b, &c),
    };
    [at, by_u.map(|d| d / (du[1] - du[0])), by_v.map(|d| d / (dv[1] - dv[0]))]
}

/// The unit normal of a surface from its vertex map; zero where the derivatives are parallel.
fn surface_normal(components: usize, [at, by_u, by_v]: [[f64; 4]; 3]) -> [f32; 3] {
    // Of x/w: (x' w - x w') / w^2, whose denominator the unit vector does not need.
    let along = |d: [f64; 4]| -> [f64; 3] {
        std::array::from_fn(|i| if components == 4 { d[i] * at[3] - at[i] * d[3] } else { d[i] })
    };
    let (a, b) = (along(by_u), along(by_v));
    let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let length = (cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]).sqrt();
    if length > 0.0 && length.is_finite() { cross.map(|c| (c / length) as f32) } else { [0.0; 3] }
}

impl Engine {
    pub(crate) fn map1(
        &mut self,
        target: GLenum,
        u1: f64,
        u2: f64,
        stride: i32,
        order: i32,
        points: &[f64],
    ) -> Outcome {
        let kind = map1_kind(target).ok_or_else(|| not_one(target, "a one-dimensional map"))?;
        self.check_map_unit()?;
        let components = COMPONENTS[kind];
        let count = check_axis([u1, u2], stride, order, components)?;
        let stride = stride.unsigned_abs() as usize;
        let mut kept = Vec::with_capacity(count * components);
        for i in 0..count {
            let point = points.get(i * stride..).and_then(|rest| rest.get(..components));
            kept.extend_from_slice(point.ok_or_else(|| too_few(points.len()))?);
        }
        self.state.eval_maps.map1[kind] = EvalMap { order: [count], domain: [[u1, u2]], points: kept };
        Ok(())
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn map2(
        &mut self,
        target: GLenum,
        u1: f64,
        u2: f64,
        ustride: i32,
        uorder: i32,
        v1: f64,
        v2: f64,
        vstride: i32,
        vorder: i32,
        points: &[f64],
    ) -> Outcome {
        let kind = map2_kind(target).ok_or_else(|| not_one(target, "a two-dimensional map"))?;
        self.check_map_unit()?;
        let components = COMPONENTS[kind];
        let order =
            [check_axis([u1, u2], ustride, uorder, components)?, check_axis([v1, v2], vstride, vorder, components)?];
        let stride = [ustride, vstride].map(|stride| stride.unsigned_abs() as usize);
        let mut kept = Vec::with_capacity(order[0] * order[1] * components);
        for i in 0..order[0] {
            for j in 0..order[1] {
                let point = points.get(i * stride[0] + j * stride[1]..).and_then(|rest| rest.get(..components));
                kept.extend_from_slice(point.ok_or_else(|| too_few(points.len()))?);
            }
        }
        self.state.eval_maps.map2[kind] = EvalMap { order, domain: [[u1, u2], [v1, v2]], points: kept };
        Ok(())
    }

    fn check_map_unit(&self) -> Outcome {
        if self.state.texture.active == 0 {
            return Ok(());
        }
        Err(invalid_operation("maps belong to texture unit 0; call glActiveTexture(GL_TEXTURE0) first"))
    }

    pub(crate) fn map_grid1(&mut self, un: i32, u1: f64, u2: f64) -> Outcome {
        check_steps(un)?;
        self.state.eval.grid1 = (un, u1, u2);
        Ok(())
    }

    pub(crate) fn map_grid2(&mut self, un: i32, u1: f64, u2: f64, vn: i32, v1: f64, v2: f64) -> Outcome {
        check_steps(un)?;
        check_steps(vn)?;
        self.state.eval.grid2 = [(un, u1, u2), (vn, v1, v2)];
        Ok(())
    }

    pub(crate) fn eval_coord1(&mut self, u: f64) {
        let (maps, enabled) = (&self.state.eval_maps.map1, &self.state.eval.map1_enabled);
        let at = |kind: usize| curve_at(&maps[kind], COMPONENTS[kind], u);
        if let Some(values) = evaluated(enabled, &self.state.current, at) {
            self.evaluated_vertex(&values);
        }
    }

    pub(crate) fn eval_coord2(&mut self, u: f64, v: f64) {
        let (maps, eval) = (&self.state.eval_maps.map2, &self.state.eval);
        let mut enabled = eval.map2_enabled;
        enabled[kind::NORMAL] &= !eval.auto_normal;
        let Some(vertex) = last_enabled(&enabled, kind::VERTEX..MAPS) else { return };
        let at = |kind: usize| surface_at(&maps[kind], COMPONENTS[kind], [u, v]);
        let surface = at(vertex);
        let of = |kind: usize| if kind == vertex { surface[0] } else { at(kind)[0] };
        let Some(mut values) = evaluated(&enabled, &self.state.current, of) else { return };
        if eval.auto_normal {
            values.current.normal = surface_normal(COMPONENTS[vertex], surface);
        }
        self.evaluated_vertex(&values);
    }

    fn evaluated_vertex(&mut self, values: &Evaluated) {
        if values.current.tex_coord[0][3] != 1.0 {
            self.unit_has_q(0);
        }
        if self.primitive == Primitive::Stale {
            self.primitive = Primitive::Inside;
            self.validate();
        }
        if self.primitive == Primitive::Inside && self.pipe.vertex(values.vertex, &values.current) {
            self.batch_is_full();
        }
    }

    pub(crate) fn eval_point1(&mut self, i: i32) {
        self.eval_coord1(grid_point(self.state.eval.grid1, i));
    }

    pub(crate) fn eval_point2(&mut self, i: i32, j: i32) {
        let [u, v] = self.state.eval.grid2;
        self.eval_coord2(grid_point(u, i), grid_point(v, j));
    }

    pub(crate) fn eval_mesh1(&mut self, mode: GLenum, i1: i32, i2: i32) -> Outcome {
        let primitive = match mode {
            GL_POINT => GL_POINTS,
            GL_LINE => GL_LINE_STRIP,
            _ => return Err(invalid_enum(format!("{} is neither GL_POINT nor GL_LINE", name(mode)))),
        };
        check_points(steps(i1, i2))?;
        if !self.makes_vertices(&self.state.eval.map1_enabled) {
            return Ok(());
        }
        self.pixels_written += PIXELS_OF_A_POINT * steps(i1, i2);
        self.begin(primitive)?;
        (i1..=i2).for_each(|i| self.eval_point1(i));
        self.end()
    }

    pub(crate) fn eval_mesh2(&mut self, mode: GLenum, i1: i32, i2: i32, j1: i32, j2: i32) -> Outcome {
        if !matches!(mode, GL_POINT | GL_LINE | GL_FILL) {
            return Err(invalid_enum(format!("{} is not GL_POINT, GL_LINE or GL_FILL", name(mode))));
        }
        let (columns, rows) = (steps(i1, i2), steps(j1, j2));
        check_points(columns.max(1).saturating_mul(rows.max(1)))?;
        if columns == 0 || rows == 0 || !self.makes_vertices(&self.state.eval.map2_enabled) {
            return Ok(());
        }
        self.pixels_written += PIXELS_OF_A_POINT * columns * rows;
        match mode {
            GL_POINT => {
                self.begin(GL_POINTS)?;
                (j1..=j2).for_each(|j| (i1..=i2).for_each(|i| self.eval_point2(i, j)));
                self.end()
            }
            GL_LINE => {
                for j in j1..=j2 {
                    self.begin(GL_LINE_STRIP)?;
                    (i1..=i2).for_each(|i| self.eval_point2(i, j));
                    self.end()?;
                }
                for i in i1..=i2 {
                    self.begin(GL_LINE_STRIP)?;
                    (j1..=j2).for_each(|j| self.eval_point2(i, j));
                    self.end()?;
                }
                Ok(())
            }
            _ => {
                for j in j1..j2 {
                    self.begin(GL_QUAD_STRIP)?;
                    for i in i1..=i2 {
                        self.eval_point2(i, j);
                        self.eval_point2(i, j + 1);
                    }
                    self.end()?;
                }
                Ok(())
            }
        }
    }

    fn makes_vertices(&self, enabled: &[bool; MAPS]) -> bool {
        last_enabled(enabled, kind::VERTEX..MAPS).is_some()
    }

    pub(crate) fn get_map(&mut self, target: GLenum, query: GLenum) -> Outcome<Values> {
        let maps = &self.state.eval_maps;
        let (order, domain, points) = if let Some(kind) = map1_kind(target) {
            let map = &maps.map1[kind];
            (&map.order[..], map.domain.as_flattened(), &map.points)
        } else if let Some(kind) = map2_kind(target) {
            let map = &maps.map2[kind];
            (&map.order[..], map.domain.as_flattened(), &map.points)
        } else {
            return Err(not_one(target, "a map"));
        };
        match query {
            GL_COEFF => Ok(Values::doubles(points)),
            GL_ORDER => Ok(Values::ints(&order.iter().map(|n| *n as i32).collect::<Vec<_>>())),
            GL_DOMAIN => Ok(Values::doubles(domain)),
            _ => Err(not_one(query, "GL_COEFF, GL_ORDER or GL_DOMAIN")),
        }
    }
}

/// How many indices there are from one to another.
fn steps(from: i32, to: i32) -> u64 {
    u64::try_from(i64::from(to) - i64::from(from) + 1).unwrap_or(0)
}

fn check_steps(n: i32) -> Outcome {
    if n > 0 { Ok(()) } else { Err(invalid_value(format!("a grid of {n} steps; it must have one at least"))) }
}

fn check_points(count: u64) -> Outcome {
    if count <= MOST_POINTS {
        return Ok(());
    }
    Err(out_of_memory(format!("a mesh of {count} points; draw it in parts of at most {MOST_POINTS}")))
}

fn too_few(len: usize) -> crate::error::GlError {
    invalid_value(format!("{len} numbers are fewer than the orders and strides of the map span"))
}
