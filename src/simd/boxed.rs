//! Batches on the heap. A batch takes tens of KiB, which must not pass the stack of a thread on its way: programs make
//! contexts on stacks of 64 KiB.

/// A copy of a value on the heap, which is never on the stack.
#[must_use]
#[expect(unsafe_code, reason = "the standard library has no safe form of it yet")]
pub(crate) fn boxed<T: Copy>(value: &T) -> Box<T> {
    let mut place = Box::<T>::new_uninit();
    // SAFETY: both are valid for one value of the type, which is Copy, and the new one does not overlap the other.
    unsafe {
        std::ptr::copy_nonoverlapping(value, place.as_mut_ptr(), 1);
        place.assume_init()
    }
}
