//! Functions by their names: OSMesaGetProcAddress knows every function that the library exports.

use super::osmesa::*;
use super::{current, glu, manual, rows, tess};
use std::ffi::{CStr, c_char, c_void};

/// The address of a function of OSMesa.
fn osmesa(name: &str) -> Option<*const c_void> {
    Some(match name {
        "OSMesaCreateContext" => OSMesaCreateContext as *const c_void,
        "OSMesaCreateContextExt" => OSMesaCreateContextExt as *const c_void,
        "OSMesaCreateContextAttribs" => OSMesaCreateContextAttribs as *const c_void,
        "OSMesaDestroyContext" => OSMesaDestroyContext as *const c_void,
        "OSMesaMakeCurrent" => OSMesaMakeCurrent as *const c_void,
        "OSMesaGetCurrentContext" => OSMesaGetCurrentContext as *const c_void,
        "OSMesaPixelStore" => OSMesaPixelStore as *const c_void,
        "OSMesaGetIntegerv" => OSMesaGetIntegerv as *const c_void,
        "OSMesaGetDepthBuffer" => OSMesaGetDepthBuffer as *const c_void,
        "OSMesaGetColorBuffer" => OSMesaGetColorBuffer as *const c_void,
        "OSMesaGetProcAddress" => OSMesaGetProcAddress as *const c_void,
        "OSMesaColorClamp" => OSMesaColorClamp as *const c_void,
        "OSMesaPostprocess" => OSMesaPostprocess as *const c_void,
        _ => return None,
    })
}

/// The address of a function, or null.
///
/// # Safety
/// `name` must be null or a string that ends with a zero byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaGetProcAddress(name: *const c_char) -> *const c_void {
    if name.is_null() {
        return std::ptr::null();
    }
    // SAFETY: the caller's promise.
    let Ok(name) = (unsafe { CStr::from_ptr(name) }).to_str() else { return std::ptr::null() };
    let found = current::without(|| {
        let address = rows::find(name)
            .or_else(|| manual::find(name))
            .or_else(|| glu::find(name))
            .or_else(|| tess::find(name))
            .or_else(|| osmesa(name));
        address.map_or(0, |address| address as usize)
    });
    found as *const c_void
}
