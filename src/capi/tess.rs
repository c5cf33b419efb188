//! The exported functions of the tessellator (GLU 1.3, chapter 5). A `GLUtesselator *` of C is a boxed [`CTess`]; vertex
//! and polygon data are the program's pointers, which are only handed back.

use super::glu::exports;
use super::{current, memory};
use crate::enums::{GLboolean, GLdouble, GLenum};
use crate::glu::constants::*;
use crate::glu::{Polygon, TessCallbacks, Tessellator};
use std::ffi::c_void;
use std::ptr::null_mut;

/// What C holds as a `GLUtesselator *`.
pub struct CTess {
    tess: Tessellator<*mut c_void>,
    caller: Caller,
}

/// A function as C hands it over: the name that goes with it says what it takes.
type AnyFunction = Option<unsafe extern "C" fn()>;

/// Defines the functions that are called, without and with the polygon's data, and how they are set and called.
macro_rules! functions {
    ($($plain:ident $name:ident $data:ident $data_name:ident ($($a:ident: $t:ty),*);)*) => {
        /// The program's functions and the data of its polygon.
        #[derive(Clone, Copy)]
        struct Caller {
            $(
                $plain: Option<unsafe extern "C" fn($($t),*)>,
                $data: Option<unsafe extern "C" fn($($t,)* *mut c_void)>,
            )*
            polygon: *mut c_void,
        }

        impl Caller {
            fn none() -> Self {
                Self { $($plain: None, $data: None,)* polygon: null_mut() }
            }

            /// Sets a function; false for a name that there is not.
            ///
            /// # Safety
            /// The function must be null or take what goes with its name.
            #[expect(clippy::useless_transmute, reason = "the function that takes nothing has the type of all")]
            unsafe fn set(&mut self, which: GLenum, function: AnyFunction) -> bool {
                // SAFETY: the caller's promise; null is null in every type of function.
                unsafe {
                    match which {
                        $(
                            $name => self.$plain = std::mem::transmute::<AnyFunction, Option<_>>(function),
                            $data_name => self.$data = std::mem::transmute::<AnyFunction, Option<_>>(function),
                        )*
                        _ => return false,
                    }
                }
                true
            }

            $(
                /// Calls the function, the one with the polygon's data if there are both. False if there is none.
                fn $plain(&self, $($a: $t),*) -> bool {
                    // SAFETY: `set` was promised functions of these types.
                    unsafe {
                        match (self.$data, self.$plain) {
                            (Some(f), _) => f($($a,)* self.polygon),
                            (None, Some(f)) => f($($a),*),
                            (None, None) => return false,
                        }
                    }
                    true
                }
            )*
        }
    };
}

functions! {
    begin GLU_TESS_BEGIN begin_data GLU_TESS_BEGIN_DATA (mode: GLenum);
    edge_flag GLU_TESS_EDGE_FLAG edge_flag_data GLU_TESS_EDGE_FLAG_DATA (boundary: GLboolean);
    vertex GLU_TESS_VERTEX vertex_data GLU_TESS_VERTEX_DATA (vertex: *mut c_void);
    end GLU_TESS_END end_data GLU_TESS_END_DATA ();
    error GLU_TESS_ERROR error_data GLU_TESS_ERROR_DATA (code: GLenum);
    combine GLU_TESS_COMBINE combine_data GLU_TESS_COMBINE_DATA
        (position: *mut GLdouble, data: *mut *mut c_void, weights: *mut f32, new: *mut *mut c_void);
}

impl TessCallbacks<*mut c_void> for Caller {
    fn begin(&mut self, mode: GLenum) {
        Caller::begin(self, mode);
    }
    fn edge_flag(&mut self, boundary: bool) {
        Caller::edge_flag(self, boundary.into());
    }
    fn vertex(&mut self, data: &*mut c_void) {
        Caller::vertex(self, *data);
    }
    fn end(&mut self) {
        Caller::end(self);
    }
    fn combine(
        &mut self,
        mut position: [f64; 3],
        data: [Option<&*mut c_void>; 4],
        mut weights: [f32; 4],
    ) -> Option<*mut c_void> {
        let (mut data, mut new) = (data.map(|d| d.copied().unwrap_or(null_mut())), null_mut());
        let (p, d, w) = (position.as_mut_ptr(), data.as_mut_ptr(), weights.as_mut_ptr());
        (Caller::combine(self, p, d, w, &mut new) && !new.is_null()).then_some(new)
    }
    fn error(&mut self, error: GLenum) {
        Caller::error(self, error);
    }
}

/// Calls `f` with a tessellator, then its error callback for each error. No reference is alive while a callback runs,
/// which may use the tessellator again.
///
/// # Safety
/// `tess` must be null or come from `gluNewTess`.
unsafe fn with<T: Default>(tess: *mut CTess, f: impl FnOnce(&mut CTess) -> T) -> T {
    let (result, errors, caller) = {
        // SAFETY: the caller's promise.
        let Some(c) = (unsafe { tess.as_mut() }) else { return T::default() };
        let result = current::without(|| f(c));
        (result, std::iter::from_fn(|| c.tess.take_error()).collect::<Vec<_>>(), c.caller)
    };
    for error in errors {
        caller.error(error);
    }
    result
}

/// The address of a function.
pub(super) fn find(name: &str) -> Option<*const c_void> {
    find_tess(name)
}

exports! { find_tess:
    fn gluNewTess() -> *mut CTess {
        Box::into_raw(Box::new(CTess { tess: Tessellator::new(), caller: Caller::none() }))
    }

    fn gluDeleteTess(tess: *mut CTess) {
        if !tess.is_null() {
            // SAFETY: the caller's promise: it comes from `gluNewTess` and is deleted once.
            unsafe {
                with(tess, |c| c.tess.close());
                drop(Box::from_raw(tess));
            }
        }
    }

    fn gluTessBeginPolygon(tess: *mut CTess, data: *mut c_void) {
        // SAFETY: the caller's promise.
        unsafe {
            with(tess, |c| {
                c.tess.begin_polygon();
                c.caller.polygon = data;
            });
        }
    }

    fn gluTessBeginContour(tess: *mut CTess) {
        // SAFETY: the caller's promise.
        unsafe { with(tess, |c| c.tess.begin_contour()) }
    }

    fn gluTessVertex(tess: *mut CTess, location: *mut GLdouble, data: *mut c_void) {
        // SAFETY: the caller's promise.
        unsafe {
            let Some(location) = memory::slice(location.cast_const(), 3).first_chunk() else { return };
            with(tess, |c| c.tess.vertex(*location, data));
        }
    }

    fn gluTessEndContour(tess: *mut CTess) {
        // SAFETY: the caller's promise.
        unsafe { with(tess, |c| c.tess.end_contour()) }
    }

    fn gluTessEndPolygon(tess: *mut CTess) {
        // SAFETY: the caller's promise.
        let job: Option<(Polygon<_>, Caller)> = unsafe { with(tess, |c| Some((c.tess.finish(), c.caller))) };
        if let Some((polygon, mut caller)) = job {
            current::without(|| polygon.tessellate(&mut caller));
        }
    }

    fn gluTessProperty(tess: *mut CTess, which: GLenum, value: GLdouble) {
        // SAFETY: the caller's promise.
        unsafe { with(tess, |c| c.tess.property(which, value)) }
    }

    fn gluGetTessProperty(tess: *mut CTess, which: GLenum, value: *mut GLdouble) {
        // SAFETY: the caller's promise.
        unsafe {
            let property = with(tess, |c| c.tess.get_property(which));
            if !value.is_null() {
                value.write(property);
            }
        }
    }

    fn gluTessNormal(tess: *mut CTess, x: GLdouble, y: GLdouble, z: GLdouble) {
        // SAFETY: the caller's promise.
        unsafe { with(tess, |c| c.tess.normal(x, y, z)) }
    }

    fn gluTessCallback(tess: *mut CTess, which: GLenum, function: AnyFunction) {
        // SAFETY: the caller's promise.
        unsafe {
            with(tess, |c| {
                if !c.caller.set(which, function) {
                    c.tess.report(GLU_INVALID_ENUM);
                }
            });
        }
    }

    fn gluBeginPolygon(tess: *mut CTess) {
        // SAFETY: the caller's promise.
        unsafe {
            gluTessBeginPolygon(tess, null_mut());
            gluTessBeginContour(tess);
        }
    }

    fn gluNextContour(tess: *mut CTess, _kind: GLenum) {
        // SAFETY: the caller's promise.
        unsafe {
            gluTessEndContour(tess);
            gluTessBeginContour(tess);
        }
    }

    fn gluEndPolygon(tess: *mut CTess) {
        // SAFETY: the caller's promise.
        unsafe {
            gluTessEndContour(tess);
            gluTessEndPolygon(tess);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the callbacks are told: the polygon's data is a pointer to it.
    #[derive(Default)]
    struct Told {
        vertices: Vec<usize>,
        errors: Vec<GLenum>,
        combined: usize,
    }

    unsafe extern "C" fn vertex(data: *mut c_void, told: *mut c_void) {
        // SAFETY: the test's own data.
        unsafe { (*told.cast::<Told>()).vertices.push(data as usize) }
    }

    unsafe extern "C" fn error(error: GLenum, told: *mut c_void) {
        // SAFETY: the test's own data or null.
        if let Some(told) = unsafe { told.cast::<Told>().as_mut() } {
            told.errors.push(error);
        }
    }

    unsafe extern "C" fn combine(
        position: *mut GLdouble,
        data: *mut *mut c_void,
        weights: *mut f32,
        new: *mut *mut c_void,
        told: *mut c_void,
    ) {
        // SAFETY: arrays of the tessellator, the test's own data.
        unsafe {
            (*told.cast::<Told>()).combined += 1;
            assert_eq!([0, 1, 2].map(|i| *position.add(i)), [2.0, 2.0, 0.0]);
            assert_eq!([0, 1, 2, 3].map(|i| *weights.add(i)), [0.25; 4]);
            let mut old = [0, 1, 2, 3].map(|i| *data.add(i) as usize);
            old.sort_unstable();
            assert_eq!(old, [1, 2, 3, 4]);
            *new = 5 as *mut c_void;
        }
    }

    #[test]
    fn callbacks_get_their_pointers_back() {
        let mut told = Told::default();
        let data: *mut c_void = (&raw mut told).cast();
        // SAFETY: functions of the types that go with their names, arrays that are long enough.
        unsafe {
            let any = |f: *const c_void| std::mem::transmute::<*const c_void, AnyFunction>(f);
            let tess = gluNewTess();
            gluTessCallback(tess, GLU_TESS_VERTEX_DATA, any(vertex as *const c_void));
            gluTessCallback(tess, GLU_TESS_ERROR_DATA, any(error as *const c_void));
            let bow = [[0.0, 0.0, 0.0], [4.0, 4.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
            for combines in [None, any(combine as *const c_void)] {
                gluTessCallback(tess, GLU_TESS_COMBINE_DATA, combines);
                gluTessBeginPolygon(tess, data);
                gluTessBeginContour(tess);
                for (i, p) in bow.iter().enumerate() {
                    gluTessVertex(tess, p.as_ptr().cast_mut(), (i + 1) as *mut c_void);
                }
                gluTessEndContour(tess);
                gluTessEndPolygon(tess);
            }
            gluTessCallback(tess, GLU_VERSION, None);
            gluTessVertex(tess, null_mut(), null_mut());
            gluDeleteTess(tess);
            gluDeleteTess(null_mut());
            gluTessEndPolygon(null_mut());
        }
        assert_eq!(told.errors, [GLU_TESS_NEED_COMBINE_CALLBACK, GLU_INVALID_ENUM]);
        assert_eq!((told.vertices.len(), told.combined), (6, 1));
        assert_eq!(told.vertices.iter().filter(|v| **v == 5).count(), 2);
        assert!(find("gluTessVertex").is_some());
    }
}
