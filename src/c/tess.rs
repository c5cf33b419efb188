//! The tessellator's C names as safe functions (GLU 1.3, chapter 5). The data of vertices and of polygons are any Rust
//! values; callbacks are functions of the types that go with their names.
//!
//! ```
//! use fixedgl::c::*;
//! make_current(fixedgl::Context::new(64, 64));
//! let tess = gluNewTess::<[f64; 3], ()>();
//! gluTessCallback(&tess, GLU_TESS_BEGIN, GLUtessFunction::Begin(|mode| glBegin(mode)));
//! gluTessCallback(&tess, GLU_TESS_VERTEX, GLUtessFunction::Vertex(|p| glVertex3dv(p)));
//! gluTessCallback(&tess, GLU_TESS_END, GLUtessFunction::End(|| glEnd()));
//! gluTessCallback(&tess, GLU_TESS_COMBINE, GLUtessFunction::Combine(|position, _data, _weights| position));
//! gluTessBeginPolygon(&tess, ());
//! gluTessBeginContour(&tess);
//! for [x, y] in [[-0.6, -0.8], [0.0, 1.0], [0.6, -0.8], [-1.0, 0.3], [1.0, 0.3]] {
//!     gluTessVertex(&tess, &[x, y, 0.0], [x, y, 0.0]);
//! }
//! gluTessEndContour(&tess);
//! gluTessEndPolygon(&tess);
//! gluDeleteTess(tess);
//! take_current();
//! ```
#![expect(non_snake_case, reason = "the names are GLU's own")]

use crate::context::InSlice;
use crate::enums::{GLdouble, GLenum};
use crate::glu::constants::*;
use crate::glu::{Polygon, TessCallbacks, Tessellator};
use std::cell::RefCell;

/// Defines what may be called back: the kinds of functions, the functions that are set, and how they are called.
macro_rules! functions {
    ($($doc:literal $Plain:ident $plain:ident $name:ident $Data:ident $data:ident $data_name:ident
       ($($a:ident: $t:ty),*) -> $r:ty;)*) => {
        /// A function for `gluTessCallback`: vertices with data `V`, polygons with data `P`.
        #[derive(Debug)]
        pub enum GLUtessFunction<V, P> {
            /// No function.
            None,
            $(
                #[doc = $doc]
                $Plain(fn($($t),*) -> $r),
                #[doc = concat!($doc, " With the polygon's data.")]
                $Data(fn($($t,)* &P) -> $r),
            )*
        }

        struct Functions<V, P> {
            $($plain: Option<fn($($t),*) -> $r>, $data: Option<fn($($t,)* &P) -> $r>,)*
        }

        impl<V, P> Clone for Functions<V, P> {
            fn clone(&self) -> Self {
                Self { $($plain: self.$plain, $data: self.$data,)* }
            }
        }

        impl<V, P> Functions<V, P> {
            fn none() -> Self {
                Self { $($plain: None, $data: None,)* }
            }

            /// Sets a function; false if it is not of the kind that goes with the name.
            fn set(&mut self, which: GLenum, function: GLUtessFunction<V, P>) -> bool {
                match (which, function) {
                    $(
                        ($name, GLUtessFunction::$Plain(f)) => self.$plain = Some(f),
                        ($name, GLUtessFunction::None) => self.$plain = None,
                        ($data_name, GLUtessFunction::$Data(f)) => self.$data = Some(f),
                        ($data_name, GLUtessFunction::None) => self.$data = None,
                    )*
                    _ => return false,
                }
                true
            }

            $(
                /// Calls the function, the one with the polygon's data if there are both.
                fn $plain(&self, $($a: $t,)* polygon: &P) -> Option<$r> {
                    match (self.$data, self.$plain) {
                        (Some(f), _) => Some(f($($a,)* polygon)),
                        (None, Some(f)) => Some(f($($a),*)),
                        (None, None) => None,
                    }
                }
            )*
        }
    };
}

functions! {
    "Primitives begin (`GLU_TESS_BEGIN`)."
    Begin begin GLU_TESS_BEGIN BeginData begin_data GLU_TESS_BEGIN_DATA (mode: GLenum) -> ();
    "Whether the edges that follow lie on the boundary (`GLU_TESS_EDGE_FLAG`)."
    EdgeFlag edge_flag GLU_TESS_EDGE_FLAG EdgeFlagData edge_flag_data GLU_TESS_EDGE_FLAG_DATA (boundary: bool) -> ();
    "A vertex (`GLU_TESS_VERTEX`)."
    Vertex vertex GLU_TESS_VERTEX VertexData vertex_data GLU_TESS_VERTEX_DATA (vertex: &V) -> ();
    "Primitives end (`GLU_TESS_END`)."
    End end GLU_TESS_END EndData end_data GLU_TESS_END_DATA () -> ();
    "An error (`GLU_TESS_ERROR`)."
    Error error GLU_TESS_ERROR ErrorData error_data GLU_TESS_ERROR_DATA (code: GLenum) -> ();
    "Makes a new vertex of its position, up to four old ones and their weights (`GLU_TESS_COMBINE`)."
    Combine combine GLU_TESS_COMBINE CombineData combine_data GLU_TESS_COMBINE_DATA
        (position: [GLdouble; 3], data: [Option<&V>; 4], weights: [f32; 4]) -> V;
}

/// A tessellator: what `gluNewTess` returns and every function here takes by reference.
pub struct GLUtesselator<V, P = ()>(RefCell<Inner<V, P>>);

/// The same with the other spelling.
pub type GLUtessellator<V, P = ()> = GLUtesselator<V, P>;

/// The older name.
pub type GLUtriangulatorObj<V, P = ()> = GLUtesselator<V, P>;

struct Inner<V, P> {
    tess: Tessellator<V>,
    functions: Functions<V, P>,
    polygon: P,
}

impl<V, P> std::fmt::Debug for GLUtesselator<V, P> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("GLUtesselator").finish_non_exhaustive()
    }
}

/// The functions that are called, with the polygon's data.
struct Caller<V, P> {
    functions: Functions<V, P>,
    polygon: P,
}

impl<V, P> TessCallbacks<V> for Caller<V, P> {
    fn begin(&mut self, mode: GLenum) {
        self.functions.begin(mode, &self.polygon);
    }
    fn edge_flag(&mut self, boundary: bool) {
        self.functions.edge_flag(boundary, &self.polygon);
    }
    fn vertex(&mut self, data: &V) {
        self.functions.vertex(data, &self.polygon);
    }
    fn end(&mut self) {
        self.functions.end(&self.polygon);
    }
    fn combine(&mut self, position: [f64; 3], data: [Option<&V>; 4], weights: [f32; 4]) -> Option<V> {
        self.functions.combine(position, data, weights, &self.polygon)
    }
    fn error(&mut self, error: GLenum) {
        self.functions.error(error, &self.polygon);
    }
}

impl<V, P: Clone> GLUtesselator<V, P> {
    /// Changes the tessellator, then tells of errors. Nothing is borrowed while a callback runs.
    fn with<T>(&self, f: impl FnOnce(&mut Inner<V, P>) -> T) -> T {
        let mut inner = self.0.borrow_mut();
        let result = f(&mut inner);
        let errors: Vec<GLenum> = std::iter::from_fn(|| inner.tess.take_error()).collect();
        if errors.is_empty() {
            return result;
        }
        let (functions, polygon) = (inner.functions.clone(), inner.polygon.clone());
        drop(inner);
        for error in errors {
            functions.error(error, &polygon);
        }
        result
    }
}

/// A new tessellator without callbacks, by the rule of odd numbers. See [`Tessellator`].
#[must_use]
pub fn gluNewTess<V, P: Default>() -> GLUtesselator<V, P> {
    let (tess, functions, polygon) = (Tessellator::new(), Functions::none(), P::default());
    GLUtesselator(RefCell::new(Inner { tess, functions, polygon }))
}

/// Ends a tessellator. (Going out of scope does the same, but does not tell of a polygon that is open.)
pub fn gluDeleteTess<V, P: Clone>(tess: GLUtesselator<V, P>) {
    tess.with(|t| t.tess.close());
}

/// Sets a callback, or none. Errors: `GLU_INVALID_ENUM` for a name that there is not or a function of another kind.
pub fn gluTessCallback<V, P: Clone>(tess: &GLUtesselator<V, P>, which: GLenum, function: GLUtessFunction<V, P>) {
    tess.with(|t| {
        if !t.functions.set(which, function) {
            t.tess.report(GLU_INVALID_ENUM);
        }
    });
}

/// See [`Tessellator::property`].
pub fn gluTessProperty<V, P: Clone>(tess: &GLUtesselator<V, P>, which: GLenum, value: impl Into<GLdouble>) {
    tess.with(|t| t.tess.property(which, value.into()));
}

/// See [`Tessellator::get_property`].
pub fn gluGetTessProperty<V, P: Clone>(tess: &GLUtesselator<V, P>, which: GLenum, value: &mut GLdouble) {
    *value = tess.with(|t| t.tess.get_property(which));
}

/// See [`Tessellator::normal`].
pub fn gluTessNormal<V, P: Clone>(
    tess: &GLUtesselator<V, P>,
    x: impl Into<GLdouble>,
    y: impl Into<GLdouble>,
    z: impl Into<GLdouble>,
) {
    tess.with(|t| t.tess.normal(x.into(), y.into(), z.into()));
}

/// See [`Tessellator::begin_polygon`]; `data` goes to the callbacks that ask for it.
pub fn gluTessBeginPolygon<V, P: Clone>(tess: &GLUtesselator<V, P>, data: P) {
    tess.with(|t| {
        t.tess.begin_polygon();
        t.polygon = data;
    });
}

/// See [`Tessellator::begin_contour`].
pub fn gluTessBeginContour<V, P: Clone>(tess: &GLUtesselator<V, P>) {
    tess.with(|t| t.tess.begin_contour());
}

/// See [`Tessellator::vertex`]. A location of less than three numbers is no vertex.
pub fn gluTessVertex<V, P: Clone>(tess: &GLUtesselator<V, P>, location: &(impl InSlice<GLdouble> + ?Sized), data: V) {
    let Some(location) = location.slice().first_chunk() else { return };
    tess.with(|t| t.tess.vertex(*location, data));
}

/// See [`Tessellator::end_contour`].
pub fn gluTessEndContour<V, P: Clone>(tess: &GLUtesselator<V, P>) {
    tess.with(|t| t.tess.end_contour());
}

/// See [`Tessellator::end_polygon`]. The callbacks may use the tessellator.
pub fn gluTessEndPolygon<V, P: Clone>(tess: &GLUtesselator<V, P>) {
    let job = |t: &mut Inner<V, P>| {
        let caller = Caller { functions: t.functions.clone(), polygon: t.polygon.clone() };
        (t.tess.finish(), caller)
    };
    let (polygon, mut caller): (Polygon<V>, _) = tess.with(job);
    polygon.tessellate(&mut caller);
}

/// `gluTessBeginPolygon` and `gluTessBeginContour`, of GLU 1.0.
pub fn gluBeginPolygon<V, P: Clone + Default>(tess: &GLUtesselator<V, P>) {
    gluTessBeginPolygon(tess, P::default());
    gluTessBeginContour(tess);
}

/// `gluTessEndContour` and `gluTessBeginContour`, of GLU 1.0. The kind of the contour makes no difference.
pub fn gluNextContour<V, P: Clone>(tess: &GLUtesselator<V, P>, _kind: GLenum) {
    gluTessEndContour(tess);
    gluTessBeginContour(tess);
}

/// `gluTessEndContour` and `gluTessEndPolygon`, of GLU 1.0.
pub fn gluEndPolygon<V, P: Clone>(tess: &GLUtesselator<V, P>) {
    gluTessEndContour(tess);
    gluTessEndPolygon(tess);
}
