//! What an argument of a table row is at each station of its way: in the signature of a Rust door, in a trace, checked
//! for the engine, owned by a display list, lent to the engine again. Every kind of argument is one token (or one group)
//! of the table, and each macro here has one line a kind: to add a kind is to add a line to each.

/// The type of an argument in the signature of a Rust door.
macro_rules! door_ty {
    (enum) => { impl $crate::context::IntoGl<$crate::enums::GLenum> };
    (unit) => { impl $crate::context::IntoGl<$crate::enums::GLenum> };
    (bits) => { impl $crate::context::IntoGl<$crate::enums::GLbitfield> };
    (uint) => { impl $crate::context::IntoGl<$crate::enums::GLuint> };
    (size) => { impl $crate::context::IntoGl<$crate::enums::GLsizeiptr> };
    ([$t:ty; $n:literal]) => { impl $crate::context::InSlice<$t> };
    ((slice $t:ty : $($count:tt)*)) => { impl $crate::context::InSlice<$t> };
    ((upto $t:ty : $($count:tt)*)) => { impl $crate::context::InSlice<$t> };
    ((out $t:ty : $($count:tt)*)) => { &mut (impl $crate::context::OutSlice<$t> + ?Sized) };
    ((rect $($size:expr),*)) => { impl $crate::context::IntoPixels<'a> };
    ((bytes $size:expr)) => { impl $crate::context::IntoPixels<'a> };
    ((rect_out $($size:expr),*)) => { impl $crate::context::IntoPixelsMut<'a> };
    ((tex_out $($size:expr),*)) => { impl $crate::context::IntoPixelsMut<'a> };
    ((bytes_out $size:expr)) => { impl $crate::context::IntoPixelsMut<'a> };
    ((imaging_out $($size:expr),*)) => { impl $crate::context::IntoPixelsMut<'a> };
    (array) => { impl $crate::context::IntoArray };
    ((indices $count:ident, $type:ident)) => { impl $crate::context::IntoIndices<'a> };
    (index_lists) => { impl $crate::context::IndexLists };
    ($t:ident) => { impl $crate::context::IntoGl<$t> };
}

/// An argument of a door as one plain value: the only place where the conversions of the doors happen.
macro_rules! plain {
    (enum, $a:ident) => {
        $crate::context::IntoGl::<u32>::into_gl($a)
    };
    (unit, $a:ident) => {
        $crate::context::IntoGl::<u32>::into_gl($a)
    };
    (bits, $a:ident) => {
        $crate::context::IntoGl::<u32>::into_gl($a)
    };
    (uint, $a:ident) => {
        $crate::context::IntoGl::<u32>::into_gl($a)
    };
    (size, $a:ident) => {
        $crate::context::IntoGl::<isize>::into_gl($a)
    };
    ([$t:ty; $n:literal], $a:ident) => {
        $crate::context::InSlice::<$t>::slice(&$a)
    };
    ((slice $t:ty : $($count:tt)*), $a:ident) => {
        $crate::context::InSlice::<$t>::slice(&$a)
    };
    ((upto $t:ty : $($count:tt)*), $a:ident) => {
        $crate::context::InSlice::<$t>::slice(&$a)
    };
    ((out $t:ty : $($count:tt)*), $a:ident) => {
        $crate::context::OutSlice::<$t>::slice_mut($a)
    };
    ((rect $($size:expr),*), $a:ident) => {
        $crate::context::IntoPixels::into_pixels($a)
    };
    ((bytes $size:expr), $a:ident) => {
        $crate::context::IntoPixels::into_pixels($a)
    };
    ((rect_out $($size:expr),*), $a:ident) => {
        $crate::context::IntoPixelsMut::into_pixels_mut($a)
    };
    ((tex_out $($size:expr),*), $a:ident) => {
        $crate::context::IntoPixelsMut::into_pixels_mut($a)
    };
    ((bytes_out $size:expr), $a:ident) => {
        $crate::context::IntoPixelsMut::into_pixels_mut($a)
    };
    ((imaging_out $($size:expr),*), $a:ident) => {
        $crate::context::IntoPixelsMut::into_pixels_mut($a)
    };
    (array, $a:ident) => {
        $crate::context::IntoArray::into_array($a)
    };
    ((indices $count:ident, $type:ident), $a:ident) => {
        $crate::context::IntoIndices::into_indices($a)
    };
    (index_lists, $a:ident) => {
        $crate::context::IndexLists::lists(&$a)
    };
    ($t:ident, $a:ident) => {
        $crate::context::IntoGl::<$t>::into_gl($a)
    };
}

/// A plain value as a trace shows it.
macro_rules! shown {
    (enum, $a:ident) => {
        &$crate::context::show::Enumerant($a)
    };
    (unit, $a:ident) => {
        &$crate::context::show::Enumerant($a)
    };
    (bits, $a:ident) => {
        &$crate::context::show::Bits($a)
    };
    (array, $a:ident) => {
        &$a
    };
    (index_lists, $a:ident) => {
        &$a
    };
    // A copy, so that a number stays in its register where nobody listens.
    ($k:ident, $a:ident) => {
        &{ $a }
    };
    ($k:tt, $a:ident) => {
        &$a
    };
}

/// A plain value as the engine takes it. Memory that is too short ends the command with an error here.
macro_rules! checked {
    ([$t:ty; $n:literal], $cx:ident, $name:ident, $a:ident) => {
        match $a.first_chunk::<$n>() {
            Some(values) => values,
            None => return $cx.short($name, stringify!($a), $n, $a.len(), "values"),
        }
    };
    ((slice $t:ty : $($count:tt)*), $cx:ident, $name:ident, $a:ident) => {{
        let needed = $crate::context::param_counts::$($count)*;
        match $a.get(..needed) {
            Some(values) => values,
            None => return $cx.short($name, stringify!($a), needed, $a.len(), "values"),
        }
    }};
    // The engine checks how many there are, after the other arguments.
    ((upto $t:ty : $($count:tt)*), $cx:ident, $name:ident, $a:ident) => {
        $a.get(..$crate::context::param_counts::$($count)*).unwrap_or($a)
    };
    ((out $t:ty : $($count:tt)*), $cx:ident, $name:ident, $a:ident) => {{
        let (needed, there) = ($crate::context::param_counts::$($count)*, $a.len());
        match $a.get_mut(..needed) {
            Some(values) => values,
            None => return $cx.short($name, stringify!($a), needed, there, "values"),
        }
    }};
    // The engine knows how much memory images, bytes and indices take, and says so in words after its other checks.
    ((rect $size:expr, $format:expr, $type:expr), $cx:ident, $name:ident, $a:ident) => {
        &$a
    };
    ((bytes $size:expr), $cx:ident, $name:ident, $a:ident) => {
        &$a
    };
    ((rect_out $size:expr, $format:expr, $type:expr), $cx:ident, $name:ident, $a:ident) => {
        $crate::context::PixelsMut::into_bytes($a)
    };
    ((tex_out $($size:expr),*), $cx:ident, $name:ident, $a:ident) => {
        $crate::context::PixelsMut::into_bytes($a)
    };
    ((imaging_out $($size:expr),*), $cx:ident, $name:ident, $a:ident) => {
        $crate::context::PixelsMut::into_bytes($a)
    };
    ((bytes_out $($size:tt)*), $cx:ident, $name:ident, $a:ident) => {
        $crate::context::PixelsMut::into_bytes($a)
    };
    ((indices $count:ident, $type:ident), $cx:ident, $name:ident, $a:ident) => { &$a };
    // It comes before the memory of the coordinates, of which this kind is the only other argument.
    (unit, $cx:ident, $name:ident, $a:ident) => {
        match $crate::context::tex_unit::unit_index($a) {
            Ok(_) => $a,
            Err(error) => return $cx.refuse($name, error),
        }
    };
    (index_lists, $cx:ident, $name:ident, $a:ident) => { &$a[..] };
    ($k:tt, $cx:ident, $name:ident, $a:ident) => { $a };
}

/// The type of an argument in the signature of an engine method.
macro_rules! engine_ty {
    (enum) => { u32 };
    (bits) => { u32 };
    (uint) => { u32 };
    (size) => { isize };
    ({$t:ty}) => { $t };
    (params) => { &$crate::context::Params };
    (matrix) => { &[f64; 16] };
    ([$t:ty; $n:literal]) => { &[$t; $n] };
    ((slice $t:ty : $($count:tt)*)) => { &[$t] };
    ((upto $t:ty : $($count:tt)*)) => { &[$t] };
    ((out $t:ty : $($count:tt)*)) => { &mut [$t] };
    ((rect $($size:expr),*)) => { &$crate::context::Pixels<'_> };
    ((bytes $size:expr)) => { &$crate::context::Pixels<'_> };
    ((rect_out $($size:expr),*)) => { &mut [u8] };
    ((tex_out $($size:expr),*)) => { &mut [u8] };
    ((imaging_out $($size:expr),*)) => { &mut [u8] };
    ((bytes_out $($size:tt)*)) => { &mut [u8] };
    (array) => { $crate::context::ArrayData };
    ((indices $count:ident, $type:ident)) => { &$crate::context::Indices<'_> };
    (index_lists) => { &[$crate::context::Indices<'_>] };
    ($t:ident) => { $t };
}

/// The type of an argument that a display list owns.
macro_rules! owned_ty {
    (enum) => { u32 };
    (bits) => { u32 };
    (uint) => { u32 };
    (size) => { isize };
    ({$t:ty}) => { $t };
    (params) => { $crate::context::Params };
    (matrix) => { Box<[f64; 16]> };
    ([$t:ty; $n:literal]) => { Box<[$t; $n]> };
    ((slice $t:ty : $($count:tt)*)) => { Box<[$t]> };
    ((upto $t:ty : $($count:tt)*)) => { Box<[$t]> };
    ((rect $($size:expr),*)) => { $crate::context::Pixels<'static> };
    ((bytes $size:expr)) => { $crate::context::Pixels<'static> };
    ($t:ident) => { $t };
}

/// An argument of the engine as a display list owns it. Pixels are captured under the present unpack state.
macro_rules! owned {
    (params, $cx:ident, $name:ident, $a:ident) => {
        *$a
    };
    (matrix, $cx:ident, $name:ident, $a:ident) => {
        Box::new(*$a)
    };
    ([$t:ty; $n:literal], $cx:ident, $name:ident, $a:ident) => {
        Box::new(*$a)
    };
    ((slice $t:ty : $($count:tt)*), $cx:ident, $name:ident, $a:ident) => {
        match $crate::context::capture::keep($a) {
            Ok(kept) => kept,
            Err(error) => return $cx.fail($name, error),
        }
    };
    ((upto $t:ty : $($count:tt)*), $cx:ident, $name:ident, $a:ident) => {
        match $crate::context::capture::keep($a) {
            Ok(kept) => kept,
            Err(error) => return $cx.fail($name, error),
        }
    };
    ((rect $size:expr, $format:expr, $type:expr), $cx:ident, $name:ident, $a:ident) => {
        match $crate::context::capture::capture(&mut $cx.engine, $size, $format, $type, $a) {
            Ok(kept) => kept,
            Err(error) => return $cx.fail($name, error),
        }
    };
    ((bytes $size:expr), $cx:ident, $name:ident, $a:ident) => {
        match $crate::context::capture::keep_bytes($a) {
            Ok(kept) => kept,
            Err(error) => return $cx.fail($name, error),
        }
    };
    ($k:tt, $cx:ident, $name:ident, $a:ident) => {
        $a
    };
}

/// An owned argument as the engine takes it.
macro_rules! lent {
    (params, $a:ident) => {
        $a
    };
    (matrix, $a:ident) => {
        $a
    };
    ([$t:ty; $n:literal], $a:ident) => {
        $a
    };
    ((slice $t:ty : $($count:tt)*), $a:ident) => {
        $a
    };
    ((upto $t:ty : $($count:tt)*), $a:ident) => {
        $a
    };
    ((rect $($size:expr),*), $a:ident) => {
        $a
    };
    ((bytes $size:expr), $a:ident) => {
        $a
    };
    ($k:tt, $a:ident) => {
        *$a
    };
}

/// What a command returns.
macro_rules! return_ty {
    () => { () };
    (uint) => { u32 };
    (enum) => { u32 };
    (int) => { i32 };
    (bool) => { bool };
    (str) => { &'static str };
}

pub(crate) use {checked, door_ty, engine_ty, lent, owned, owned_ty, plain, return_ty, shown};
