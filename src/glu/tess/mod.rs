//! The tessellator: polygons of any form, with holes, crossings and coincident parts, as triangles (GLU 1.3, chapter 5).
//!
//! Vertices are put on a grid of integers, and everything after that is exact: whether edges cross, which way three points
//! turn, what is inside. So no polygon is too awkward: edges on each other, crossings in one point, contours that touch or
//! lie on a line.

mod arrange;
mod loops;
mod monotone;
mod ordered;
mod plane;
mod points;
mod polygon;
mod snap;

pub(crate) use polygon::Polygon;

use super::constants::*;
use crate::enums::GLenum;

/// What a [`Tessellator`] tells of a polygon (`gluTessCallback`). Each does nothing unless it is written.
pub trait TessCallbacks<V> {
    /// Triangles (`GL_TRIANGLES`) or a boundary (`GL_LINE_LOOP`) begin.
    fn begin(&mut self, _mode: GLenum) {}
    /// The edges from the vertices that follow lie on the boundary of the polygon, or do not. Told of triangles, before
    /// the first vertex and then at each change.
    fn edge_flag(&mut self, _boundary: bool) {}
    /// A vertex, by its data.
    fn vertex(&mut self, _data: &V) {}
    /// The triangles or the boundary end.
    fn end(&mut self) {}
    /// Makes the data of a new vertex where two edges cross, or where vertices fall together (then there are two data, and
    /// without a new vertex the first stays). The weights sum to 1 and make the position from those of the old vertices.
    /// A polygon with crossings and no answer here is the error `GLU_TESS_NEED_COMBINE_CALLBACK`, and nothing of it is told.
    fn combine(&mut self, _position: [f64; 3], _data: [Option<&V>; 4], _weights: [f32; 4]) -> Option<V> {
        None
    }
    /// An error: a `GLU_TESS_..` code, or `GLU_OUT_OF_MEMORY` for a polygon with more than a million crossings, of which
    /// nothing is told. [`error_string`](super::error_string) has the words.
    fn error(&mut self, _error: GLenum) {}
}

/// What is inside (`GLU_TESS_WINDING_RULE`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum WindingRule {
    Odd,
    Nonzero,
    Positive,
    Negative,
    AbsGeqTwo,
}

/// The winding rules with their constants.
const RULES: [(GLenum, WindingRule); 5] = [
    (GLU_TESS_WINDING_ODD, WindingRule::Odd),
    (GLU_TESS_WINDING_NONZERO, WindingRule::Nonzero),
    (GLU_TESS_WINDING_POSITIVE, WindingRule::Positive),
    (GLU_TESS_WINDING_NEGATIVE, WindingRule::Negative),
    (GLU_TESS_WINDING_ABS_GEQ_TWO, WindingRule::AbsGeqTwo),
];

impl WindingRule {
    /// Whether what the contours wind around so many times is inside.
    fn inside(self, winding: i64) -> bool {
        match self {
            Self::Odd => winding % 2 != 0,
            Self::Nonzero => winding != 0,
            Self::Positive => winding > 0,
            Self::Negative => winding < 0,
            Self::AbsGeqTwo => winding.abs() >= 2,
        }
    }
}

/// What properties and the normal say.
#[derive(Clone, Copy, Debug)]
struct Settings {
    rule: WindingRule,
    boundary_only: bool,
    tolerance: f64,
    normal: [f64; 3],
}

/// Where the tessellator is in the description of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Outside,
    InPolygon,
    InContour,
}

/// Cuts polygons into triangles (`GLUtesselator`). Each vertex carries data `V`, by which the callbacks know it.
///
/// Contours are given between [`begin_polygon`](Self::begin_polygon) and [`end_polygon`](Self::end_polygon), which tells
/// the callbacks everything. They may cross themselves and each other; the winding rule says what is inside.
///
/// ```
/// use fixedgl::Context;
/// use fixedgl::enums::*;
/// use fixedgl::glu::{GLU_TESS_WINDING_NONZERO, GLU_TESS_WINDING_RULE, TessCallbacks, Tessellator};
///
/// /// Draws what it is told; where edges cross, the position is all that a vertex needs.
/// struct Draw<'a>(&'a mut Context);
///
/// impl TessCallbacks<[f64; 3]> for Draw<'_> {
///     fn begin(&mut self, mode: GLenum) {
///         self.0.begin(mode);
///     }
///     fn vertex(&mut self, p: &[f64; 3]) {
///         self.0.vertex3d(p[0], p[1], p[2]);
///     }
///     fn end(&mut self) {
///         self.0.end();
///     }
///     fn combine(&mut self, p: [f64; 3], _: [Option<&[f64; 3]>; 4], _: [f32; 4]) -> Option<[f64; 3]> {
///         Some(p)
///     }
/// }
///
/// let mut cx = Context::new(64, 64);
/// let mut tess = Tessellator::new();
/// tess.property(GLU_TESS_WINDING_RULE, f64::from(GLU_TESS_WINDING_NONZERO));
/// tess.begin_polygon();
/// tess.begin_contour();
/// for [x, y] in [[-0.6, -0.8], [0.0, 1.0], [0.6, -0.8], [-1.0, 0.3], [1.0, 0.3]] {
///     tess.vertex([x, y, 0.0], [x, y, 0.0]);
/// }
/// tess.end_contour();
/// tess.end_polygon(&mut Draw(&mut cx));
/// let mut middle = [0u8; 4];
/// cx.read_pixels(32, 32, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut middle);
/// assert_eq!(middle, [255; 4]);
/// ```
#[derive(Clone, Debug)]
pub struct Tessellator<V> {
    settings: Settings,
    state: State,
    polygon: Polygon<V>,
    errors: Vec<GLenum>,
}

impl<V> Default for Tessellator<V> {
    fn default() -> Self {
        let settings = Settings { rule: WindingRule::Odd, boundary_only: false, tolerance: 0.0, normal: [0.0; 3] };
        Self { settings, state: State::Outside, polygon: Polygon::new(settings), errors: Vec::new() }
    }
}

/// Larger coordinates are limited to this (`GLU_TESS_MAX_COORD`).
const MAX_COORD: f64 = GLU_TESS_MAX_COORD;

impl<V> Tessellator<V> {
    /// A tessellator with the initial values (`gluNewTess`): the rule `GLU_TESS_WINDING_ODD`, no tolerance, a normal that
    /// is computed.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets `GLU_TESS_WINDING_RULE`, `GLU_TESS_BOUNDARY_ONLY` (0 or not) or `GLU_TESS_TOLERANCE`, from 0 to 1 times the
    /// largest coordinate (`gluTessProperty`). Errors: `GLU_INVALID_ENUM`, `GLU_INVALID_VALUE`.
    pub fn property(&mut self, which: GLenum, value: f64) {
        let rule = RULES.iter().find(|(gl, _)| f64::from(*gl) == value);
        match which {
            GLU_TESS_WINDING_RULE => match rule {
                Some((_, rule)) => self.settings.rule = *rule,
                None => self.report(GLU_INVALID_VALUE),
            },
            GLU_TESS_BOUNDARY_ONLY => self.settings.boundary_only = value != 0.0,
            GLU_TESS_TOLERANCE if (0.0..=1.0).contains(&value) => self.settings.tolerance = value,
            GLU_TESS_TOLERANCE => self.report(GLU_INVALID_VALUE),
            _ => self.report(GLU_INVALID_ENUM),
        }
    }

    /// The value of a property; 0 and `GLU_INVALID_ENUM` for another name (`gluGetTessProperty`).
    pub fn get_property(&mut self, which: GLenum) -> f64 {
        match which {
            GLU_TESS_WINDING_RULE => {
                RULES.iter().find(|(_, rule)| *rule == self.settings.rule).map_or(0.0, |(gl, _)| f64::from(*gl))
            }
            GLU_TESS_BOUNDARY_ONLY => f64::from(u8::from(self.settings.boundary_only)),
            GLU_TESS_TOLERANCE => self.settings.tolerance,
            _ => {
                self.report(GLU_INVALID_ENUM);
                0.0
            }
        }
    }

    /// Sets the direction along which polygons are projected; triangles are counter-clockwise seen from where it points to
    /// (`gluTessNormal`). (0, 0, 0), or what is not finite, asks for a plane through the vertices, and for the direction
    /// in which the contours have an area of at least 0 together.
    pub fn normal(&mut self, x: f64, y: f64, z: f64) {
        self.settings.normal = [x, y, z];
    }

    /// Begins a polygon (`gluTessBeginPolygon`). One that is open is thrown away: `GLU_TESS_MISSING_END_POLYGON`.
    pub fn begin_polygon(&mut self) {
        self.require(State::Outside);
        self.state = State::InPolygon;
    }

    /// Begins a contour (`gluTessBeginContour`). What is missing before it is an error and done by itself.
    pub fn begin_contour(&mut self) {
        self.require(State::InPolygon);
        self.state = State::InContour;
    }

    /// A vertex of the contour (`gluTessVertex`). Coordinates beyond 1e150 are limited to that, and what is no number is
    /// taken as 0: `GLU_TESS_COORD_TOO_LARGE`.
    pub fn vertex(&mut self, position: [f64; 3], data: V) {
        self.require(State::InContour);
        let limited = position.map(|c| if c.is_nan() { 0.0 } else { c.clamp(-MAX_COORD, MAX_COORD) });
        if limited != position {
            self.report(GLU_TESS_COORD_TOO_LARGE);
        }
        let Polygon { positions, data: all, .. } = &mut self.polygon;
        if positions.try_reserve(1).is_err() || all.try_reserve(1).is_err() {
            return self.report(GLU_OUT_OF_MEMORY);
        }
        positions.push(limited);
        all.push(data);
    }

    /// Ends a contour (`gluTessEndContour`). The last vertex is joined to the first.
    pub fn end_contour(&mut self) {
        self.require(State::InContour);
        self.polygon.ends.push(self.polygon.positions.len());
        self.state = State::InPolygon;
    }

    /// Ends a polygon and tells the callbacks of it (`gluTessEndPolygon`): first of errors that came before, then of its
    /// triangles or its boundary.
    pub fn end_polygon(&mut self, callbacks: &mut impl TessCallbacks<V>) {
        let polygon = self.finish();
        while let Some(error) = self.take_error() {
            callbacks.error(error);
        }
        polygon.tessellate(callbacks);
    }

    /// Ends a polygon, which can be tessellated without its tessellator.
    pub(crate) fn finish(&mut self) -> Polygon<V> {
        self.require(State::InPolygon);
        self.state = State::Outside;
        let mut polygon = std::mem::replace(&mut self.polygon, Polygon::new(self.settings));
        polygon.settings = self.settings;
        polygon
    }

    /// The first error that was not told yet. Each code is kept once.
    pub fn take_error(&mut self) -> Option<GLenum> {
        (!self.errors.is_empty()).then(|| self.errors.remove(0))
    }

    /// Reports a polygon that was begun and not ended, before the tessellator goes (`gluDeleteTess`).
    pub(crate) fn close(&mut self) {
        self.require(State::Outside);
    }

    pub(crate) fn report(&mut self, error: GLenum) {
        if !self.errors.contains(&error) {
            self.errors.push(error);
        }
    }

    /// Goes to a state by what is missing, and reports that.
    fn require(&mut self, state: State) {
        while self.state != state {
            match (self.state, state) {
                (State::Outside, _) => {
                    self.report(GLU_TESS_MISSING_BEGIN_POLYGON);
                    self.begin_polygon();
                }
                (State::InPolygon, State::InContour) => {
                    self.report(GLU_TESS_MISSING_BEGIN_CONTOUR);
                    self.begin_contour();
                }
                (State::InPolygon, _) => {
                    self.report(GLU_TESS_MISSING_END_POLYGON);
                    self.polygon = Polygon::new(self.settings);
                    self.state = State::Outside;
                }
                (State::InContour, _) => {
                    self.report(GLU_TESS_MISSING_END_CONTOUR);
                    self.end_contour();
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
