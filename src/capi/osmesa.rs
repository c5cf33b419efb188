//! The OSMesa entry points: off-screen contexts that draw into memory of the program. A C program written for OSMesa runs
//! unchanged: it makes a context, makes it current with a piece of memory, draws, calls glFinish, and has its picture.
//! Objects are not shared between contexts.
//!
//! # When the program's memory is written
//! Between OSMesaMakeCurrent and the next Flush, Finish or OSMesaGetColorBuffer, and when another context is made current
//! while something is not finished. What is not finished when the *same* context gets other memory is dropped: the old
//! memory may have been freed.

use super::current::{self, say};
use super::present::pixel_bytes;
use crate::context::Config;
use crate::enums::{name as name_of, *};
use crate::framebuffer::{Framebuffer, FramebufferFormat, UserMemory};
use crate::limits::MAX_VIEWPORT_DIM;
use crate::{Context, context::param_counts};
use std::ffi::{c_char, c_int, c_uint, c_void};
use std::ptr::null_mut;

pub(super) const BGRA: GLenum = 0x1;
pub(super) const ARGB: GLenum = 0x2;
pub(super) const BGR: GLenum = 0x4;
pub(super) const RGB_565: GLenum = 0x5;
const ROW_LENGTH: c_int = 0x10;
const Y_UP: c_int = 0x11;
const WIDTH: c_int = 0x20;
const HEIGHT: c_int = 0x21;
const FORMAT: c_int = 0x22;
const TYPE: c_int = 0x23;
const MAX_WIDTH: c_int = 0x24;
const MAX_HEIGHT: c_int = 0x25;
const DEPTH_BITS: c_int = 0x30;
const STENCIL_BITS: c_int = 0x31;
const ACCUM_BITS: c_int = 0x32;
const PROFILE: c_int = 0x33;
const COMPAT_PROFILE: c_int = 0x35;
const CONTEXT_MAJOR_VERSION: c_int = 0x36;
const CONTEXT_MINOR_VERSION: c_int = 0x37;

/// Memory that a command of C has left with the context.
pub(super) struct ClientBuffer<T> {
    pub(super) address: *mut T,
    pub(super) len: usize,
}

impl<T: Copy> ClientBuffer<T> {
    const NONE: Self = Self { address: null_mut(), len: 0 };

    /// Copies values to the memory, as many as it holds.
    ///
    /// # Safety
    /// The memory must still be writable.
    pub(super) unsafe fn write(&self, values: &[T]) {
        for (i, value) in values.iter().take(if self.address.is_null() { 0 } else { self.len }).enumerate() {
            // SAFETY: the caller's promise.
            unsafe { self.address.add(i).write(*value) };
        }
    }
}

/// How rows lie in the program's memory.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    /// Pixels from row to row; 0 for the width.
    pub(super) row_length: u32,
    /// Whether the lowest row comes first.
    pub(super) y_up: bool,
}

/// The program's memory.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Target {
    pub(super) address: *mut u8,
    pub(super) type_: GLenum,
    pub(super) width: u32,
    pub(super) height: u32,
    /// Whether the framebuffer is that memory.
    pub(super) in_place: bool,
}

/// What an `OSMesaContext` points to.
pub struct OsMesa {
    pub(super) context: Context,
    pub(super) format: GLenum,
    pub(super) layout: Layout,
    pub(super) target: Option<Target>,
    pub(super) feedback: ClientBuffer<f32>,
    pub(super) select: ClientBuffer<u32>,
    buffers: FramebufferFormat,
    depth16: Vec<u16>,
    depth32: Vec<u32>,
}

impl OsMesa {
    fn new(format: GLenum, depth: c_int, stencil: c_int, accum: c_int) -> Option<Self> {
        let alpha = match format {
            GL_RGBA | BGRA | ARGB => 8,
            GL_RGB | BGR | RGB_565 => 0,
            _ => return None,
        };
        let depth_bits = match depth {
            ..=0 => 0,
            1..=16 => 16,
            17..=24 => 24,
            _ => 32,
        };
        let buffers = FramebufferFormat {
            color_bits: [8, 8, 8, alpha],
            float: false,
            depth_bits,
            stencil_bits: if stencil > 0 { 8 } else { 0 },
            accum_bits: if accum > 0 { 16 } else { 0 },
        };
        let config = Config { format: buffers, ..Config::from_env() };
        Some(Self {
            context: Context::with_config(0, 0, config),
            format,
            layout: Layout { row_length: 0, y_up: true },
            target: None,
            feedback: ClientBuffer::NONE,
            select: ClientBuffer::NONE,
            buffers,
            depth16: Vec::new(),
            depth32: Vec::new(),
        })
    }

    /// Lets go of the memory that is drawn into. What has not been finished is dropped, since the memory may be gone.
    fn leave_memory(&mut self) {
        if !self.target.is_some_and(|target| target.in_place) {
            return;
        }
        if self.context.engine.unseen {
            self.context.engine.note(
                "what was drawn since the last glFinish is lost: the context gets other memory; call glFinish first"
                    .to_string(),
            );
            self.context.deliver("OSMesaMakeCurrent");
        }
        self.context.engine.discard_scene();
    }

    /// Draws into `target` from now on. Bytes R, G, B, A at an even address are drawn in place.
    fn bind(&mut self, mut target: Target) -> Option<()> {
        let Target { address, type_, width, height, .. } = target;
        let same_size = self.target.is_some_and(|t| (t.width, t.height, t.type_) == (width, height, type_));
        let first = self.target.is_none();
        let row = if self.layout.row_length == 0 { width } else { self.layout.row_length };
        let in_place =
            self.format == GL_RGBA && type_ == GL_UNSIGNED_BYTE && row >= width && cfg!(target_endian = "little");
        let pixels = row as usize * (height as usize - 1) + width as usize;
        let memory = match in_place {
            // SAFETY: OSMesaMakeCurrent asks for memory of so many pixels that is the context's while it is current;
            // bytes of C count as initialised.
            true => unsafe { UserMemory::new(address.cast::<u32>(), pixels) },
            false => None,
        };
        target.in_place = memory.is_some();
        let was_in_place = self.target.is_some_and(|t| t.in_place);
        if let Some(memory) = memory {
            let flipped = !self.layout.y_up;
            let framebuffer = Framebuffer::with_user_memory(width, height, row, flipped, self.buffers, memory).ok()?;
            self.context.engine.framebuffer = framebuffer;
        } else if !same_size || was_in_place {
            let float = type_ != GL_UNSIGNED_BYTE && self.format != RGB_565;
            let color_bits = if float { self.buffers.color_bits.map(|b| b * 4) } else { self.buffers.color_bits };
            let format = FramebufferFormat { float, color_bits, ..self.buffers };
            self.context.engine.framebuffer = Framebuffer::new(width, height, format).ok()?;
        }
        self.context.engine.dirty = crate::state::Dirty::ALL;
        if first {
            self.context.engine.window_sized();
        }
        self.target = Some(target);
        Some(())
    }
}

/// Makes a context with a depth buffer of 24 bits and a stencil buffer.
#[unsafe(no_mangle)]
pub extern "C" fn OSMesaCreateContext(format: GLenum, sharelist: *mut OsMesa) -> *mut OsMesa {
    OSMesaCreateContextExt(format, 24, 8, 0, sharelist)
}

/// Makes a context with buffers of at least so many bits. Objects are not shared, whatever `sharelist` is; with
/// `FIXEDGL_DEBUG=1` a line on standard error says so.
#[unsafe(no_mangle)]
pub extern "C" fn OSMesaCreateContextExt(
    format: GLenum,
    depth_bits: c_int,
    stencil_bits: c_int,
    accum_bits: c_int,
    sharelist: *mut OsMesa,
) -> *mut OsMesa {
    let name = "OSMesaCreateContextExt";
    if !sharelist.is_null() {
        say(name, || "objects are not shared between contexts: each has its own textures and lists".to_string());
    }
    let made = current::without(|| OsMesa::new(format, depth_bits, stencil_bits, accum_bits));
    if made.is_none() {
        say(name, || format!("no context: 0x{format:X} is not a format like OSMESA_RGBA"));
    }
    made.map_or(null_mut(), |os| Box::into_raw(Box::new(os)))
}

/// Makes a context from pairs of names and values that end with 0. Null for versions above 1.5 and other profiles.
///
/// # Safety
/// `attributes` must be null or point to such pairs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaCreateContextAttribs(attributes: *const c_int, sharelist: *mut OsMesa) -> *mut OsMesa {
    let (mut format, mut depth, mut stencil, mut accum) = (GL_RGBA, 0, 0, 0);
    let (mut major, mut minor) = (1, 0);
    let mut at = attributes;
    while !at.is_null() {
        // SAFETY: the caller's promise.
        let name = unsafe { *at };
        if name == 0 {
            break;
        }
        // SAFETY: a name is followed by its value.
        let value = unsafe { *at.add(1) };
        match name {
            FORMAT => format = value.cast_unsigned(),
            DEPTH_BITS => depth = value,
            STENCIL_BITS => stencil = value,
            ACCUM_BITS => accum = value,
            PROFILE if value != COMPAT_PROFILE => return null_mut(),
            PROFILE => {}
            CONTEXT_MAJOR_VERSION => major = value,
            CONTEXT_MINOR_VERSION => minor = value,
            _ => return null_mut(),
        }
        // SAFETY: the pairs go on until a 0.
        at = unsafe { at.add(2) };
    }
    if (major, minor) > (1, 5) || major < 1 || depth < 0 || stencil < 0 || accum < 0 {
        return null_mut();
    }
    OSMesaCreateContextExt(format, depth, stencil, accum, sharelist)
}

/// Ends a context.
///
/// # Safety
/// The handle must be null or a context that has not been destroyed and is current in no other thread.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaDestroyContext(handle: *mut OsMesa) {
    if handle.is_null() {
        return;
    }
    if current::get() == handle {
        // SAFETY: null is always allowed.
        unsafe { current::set(null_mut()) };
    }
    // SAFETY: the caller's promise; the handle came from `Box::into_raw`.
    let os = unsafe { Box::from_raw(handle) };
    current::without(|| drop(os));
}

/// Makes a context current with memory to draw into; null for both leaves the thread without one.
///
/// # Safety
/// The handle must be a context that is current in no other thread. `buffer` must hold `height` rows of pixels of the
/// context's format and the type, must be initialised and must not be freed or used while a command draws.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaMakeCurrent(
    handle: *mut OsMesa,
    buffer: *mut c_void,
    type_: GLenum,
    width: c_int,
    height: c_int,
) -> GLboolean {
    let name = "OSMesaMakeCurrent";
    if !current::get().is_null() && current::get() != handle {
        super::present::present_the_rest();
    }
    if handle.is_null() && buffer.is_null() {
        // SAFETY: null is always allowed.
        unsafe { current::set(null_mut()) };
        return GL_TRUE;
    }
    // SAFETY: the caller's promise.
    let Some(os) = (unsafe { handle.as_mut() }) else { return GL_FALSE };
    let (Ok(w), Ok(h)) = (u32::try_from(width), u32::try_from(height)) else { return GL_FALSE };
    let size = 1..=MAX_VIEWPORT_DIM;
    if buffer.is_null() || !size.contains(&w) || !size.contains(&h) || pixel_bytes(os.format, type_).is_none() {
        say(name, || match pixel_bytes(os.format, type_) {
            _ if buffer.is_null() => "nothing is made current: the buffer is NULL".to_string(),
            None => format!("nothing is made current: {} does not go with the context's format", name_of(type_)),
            Some(_) => format!("nothing is made current: {w} x {h} is not 1 to {MAX_VIEWPORT_DIM} pixels each way"),
        });
        return GL_FALSE;
    }
    let target = Target { address: buffer.cast(), type_, width: w, height: h, in_place: false };
    let bound = current::without(|| {
        // The same memory again: nothing changes, depths stay.
        if os.target.is_some_and(|t| Target { in_place: false, ..t } == target) {
            os.context.engine.flush_scene();
            return Some(());
        }
        os.leave_memory();
        os.bind(target)
    });
    if bound.is_none() {
        say(name, || format!("nothing is made current: no memory for the buffers of {w} x {h} pixels"));
        return GL_FALSE;
    }
    // SAFETY: the caller's promise; handles come from `Box::into_raw`.
    unsafe { current::set(handle) };
    GL_TRUE
}

/// The context that is current in this thread.
#[unsafe(no_mangle)]
pub extern "C" fn OSMesaGetCurrentContext() -> *mut OsMesa {
    current::get()
}

/// Sets how rows lie in the memory of the current context.
#[unsafe(no_mangle)]
pub extern "C" fn OSMesaPixelStore(pname: c_int, value: c_int) {
    current::with_handle(|os| {
        match pname {
            ROW_LENGTH => os.layout.row_length = param_counts::count(value) as u32,
            Y_UP => os.layout.y_up = value != 0,
            _ => return,
        }
        if let Some(target) = os.target.filter(|target| target.in_place) {
            os.context.engine.flush_scene();
            os.bind(target);
        }
    });
}

/// Properties of the current context.
///
/// # Safety
/// `value` must be writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaGetIntegerv(pname: c_int, value: *mut c_int) {
    let answer = current::with_handle(|os| {
        let target = os.target.as_ref();
        Some(match pname {
            WIDTH => target.map_or(0, |t| t.width),
            HEIGHT => target.map_or(0, |t| t.height),
            FORMAT => os.format,
            TYPE => target.map_or(0, |t| t.type_),
            ROW_LENGTH => os.layout.row_length,
            Y_UP => u32::from(os.layout.y_up),
            MAX_WIDTH | MAX_HEIGHT => MAX_VIEWPORT_DIM,
            _ => return None,
        })
    });
    if let Some(answer) = answer
        && !value.is_null()
    {
        // SAFETY: the caller's promise.
        unsafe { value.write(answer.cast_signed()) };
    }
}

/// The depths of a context: integers of 2 or 4 bytes, rows in the order of the colours. Good until the next call.
///
/// # Safety
/// The handle must be null or a context; the other pointers must be null or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaGetDepthBuffer(
    handle: *mut OsMesa,
    width: *mut c_int,
    height: *mut c_int,
    bytes_per_value: *mut c_int,
    buffer: *mut *mut c_void,
) -> GLboolean {
    // SAFETY: the caller's promise.
    let os = unsafe { handle.as_mut() };
    let answer = current::without(|| {
        let os = os.filter(|os| os.buffers.depth_bits > 0)?;
        let target = os.target?;
        os.context.engine.flush_scene();
        let max = f64::from(os.buffers.depth_max());
        let mut row = vec![0.0; target.width as usize];
        let mut all = Vec::new();
        all.try_reserve_exact(target.width as usize * target.height as usize).ok()?;
        for y in 0..target.height {
            let y = if os.layout.y_up { y } else { target.height - 1 - y };
            os.context.engine.framebuffer.read_depth(0, y.cast_signed(), &mut row);
            all.extend(row.iter().map(|depth| (depth * max + 0.5) as u32));
        }
        let (bytes, address) = if os.buffers.depth_bits == 16 {
            os.depth16.clear();
            os.depth16.try_reserve_exact(all.len()).ok()?;
            os.depth16.extend(all.iter().map(|depth| *depth as u16));
            (2, os.depth16.as_mut_ptr() as usize)
        } else {
            os.depth32 = all;
            (4, os.depth32.as_mut_ptr() as usize)
        };
        Some((target, bytes, address))
    });
    let (w, h, bytes, address) = answer.map_or((0, 0, 0, 0), |(t, bytes, a)| (t.width, t.height, bytes, a));
    // SAFETY: the caller's promise.
    unsafe {
        put(width, w.cast_signed());
        put(height, h.cast_signed());
        put(bytes_per_value, bytes);
        put(buffer, address as *mut c_void);
    }
    GLboolean::from(answer.is_some())
}

/// The colours of a context: the memory that it draws into.
///
/// # Safety
/// The handle must be null or a context; the other pointers must be null or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaGetColorBuffer(
    handle: *mut OsMesa,
    width: *mut c_int,
    height: *mut c_int,
    format: *mut c_int,
    buffer: *mut *mut c_void,
) -> GLboolean {
    // SAFETY: the caller's promise.
    let os = unsafe { handle.as_mut() };
    let answer = current::without(|| {
        let os = os?;
        os.present();
        os.target.map(|t| (t.width, t.height, os.format, t.address as usize))
    });
    let (w, h, f, address) = answer.unwrap_or((0, 0, 0, 0));
    // SAFETY: the caller's promise.
    unsafe {
        put(width, w.cast_signed());
        put(height, h.cast_signed());
        put(format, f.cast_signed());
        put(buffer, address as *mut c_void);
    }
    GLboolean::from(answer.is_some())
}

/// Writes a result unless the program does not want it.
///
/// # Safety
/// The pointer must be null or writable.
unsafe fn put<T>(pointer: *mut T, value: T) {
    if !pointer.is_null() {
        // SAFETY: the caller's promise.
        unsafe { pointer.write(value) };
    }
}

/// Colours are always clamped.
#[unsafe(no_mangle)]
pub extern "C" fn OSMesaColorClamp(_enable: GLboolean) {}

/// There are no filters to turn on.
#[unsafe(no_mangle)]
pub extern "C" fn OSMesaPostprocess(_context: *mut OsMesa, _filter: *const c_char, _value: c_uint) {}
