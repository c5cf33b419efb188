//! Memory of the client as a colour buffer: what OSMesaMakeCurrent hands over. The one place in the framebuffer room that
//! is `unsafe`: a raw address becomes a slice here and nowhere else.

use std::ptr::NonNull;

/// A client's pixels, bytes R, G, B, A each.
#[derive(Debug)]
pub struct UserMemory {
    address: NonNull<u32>,
    len: usize,
}

#[expect(unsafe_code, reason = "the maker of the value has promised that nobody else uses the memory")]
// SAFETY: `UserMemory::new` asks for memory that nobody else touches, so it may move to another thread with its owner.
unsafe impl Send for UserMemory {}

#[expect(unsafe_code, reason = "a shared reference only reads")]
// SAFETY: through `&UserMemory` the memory can only be read.
unsafe impl Sync for UserMemory {}

#[cfg_attr(not(any(test, feature = "capi")), expect(dead_code, reason = "only C hands over its own memory"))]
impl UserMemory {
    /// Takes `len` pixels at `address`; `None` where the address is null or not that of a `u32`, or where the memory
    /// would be larger than an object can be.
    ///
    /// # Safety
    /// `address` must be valid for reads and writes of `len` pixels until the value is dropped, the pixels must be
    /// initialised, and nobody else may read or write them while a method of the framebuffer that holds it runs, or while
    /// the framebuffer is with a thread that draws: from Begin to End at most.
    #[expect(unsafe_code, reason = "a raw address from C")]
    pub unsafe fn new(address: *mut u32, len: usize) -> Option<Self> {
        let fits = len.checked_mul(4).is_some_and(|bytes| bytes <= isize::MAX.cast_unsigned());
        NonNull::new(address).filter(|a| a.is_aligned() && fits).map(|address| Self { address, len })
    }

    /// Forgets pixels from `len` on.
    pub(super) fn truncate(&mut self, len: usize) {
        self.len = self.len.min(len);
    }

    /// The pixels.
    pub(super) fn pixels(&self) -> &[u32] {
        #[expect(unsafe_code, reason = "the promise of `new`")]
        // SAFETY: `new` was promised `len` initialised pixels that nobody else writes, and checked the alignment.
        unsafe {
            std::slice::from_raw_parts(self.address.as_ptr(), self.len)
        }
    }

    /// The pixels, to write.
    pub(super) fn pixels_mut(&mut self) -> &mut [u32] {
        #[expect(unsafe_code, reason = "the promise of `new`")]
        // SAFETY: as in `pixels`, and `&mut self` makes this the only slice.
        unsafe {
            std::slice::from_raw_parts_mut(self.address.as_ptr(), self.len)
        }
    }
}
