//! The floating-point control of the calling thread at the C doors. A program built with `-ffast-math` flushes denormals
//! to zero in all of its threads, others round in another direction or trap; then numbers would differ from machine to
//! machine, and Rust code must not run so at all. A door works in the initial state of IEEE 754 (to nearest, denormals
//! kept, nothing trapped) and puts the caller's state back. In the initial state that costs one look at the register.

#[cfg(target_arch = "x86_64")]
mod register {
    use std::arch::asm;

    /// All bits but the flags of what has happened.
    const CONTROL: u32 = 0xFFC0;
    /// To nearest, denormals kept, nothing trapped.
    const INITIAL: u32 = 0x1F80;

    /// The caller's register, where it is not in the initial state.
    #[inline(always)]
    pub(super) fn other() -> Option<u32> {
        let mut register = 0u32;
        // SAFETY: stores the register in a word.
        unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut register, options(nostack, preserves_flags)) };
        (register & CONTROL != INITIAL).then_some(register)
    }

    #[cold]
    pub(super) fn set(register: u32) {
        // SAFETY: loads the register from a word, which is the initial one or one that was there.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const register, options(nostack, preserves_flags)) };
    }

    #[cold]
    pub(super) fn set_initial() {
        set(INITIAL);
    }
}

#[cfg(not(target_arch = "x86_64"))]
mod register {
    pub(super) const fn other() -> Option<u32> {
        None
    }
    pub(super) const fn set(_register: u32) {}
    pub(super) const fn set_initial() {}
}

/// Whether the thread is in the initial state.
#[inline(always)]
pub(super) fn is_initial() -> bool {
    register::other().is_none()
}

/// The initial state as long as it lives, then the caller's again.
pub(super) struct InitialState {
    caller: Option<u32>,
}

impl InitialState {
    /// Sets the initial state, if it is another.
    #[inline(always)]
    pub(super) fn enter() -> Self {
        let caller = register::other();
        if caller.is_some() {
            register::set_initial();
        }
        Self { caller }
    }
}

impl Drop for InitialState {
    #[inline(always)]
    fn drop(&mut self) {
        if let Some(register) = self.caller {
            register::set(register);
        }
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::{InitialState, register};
    use std::hint::black_box;

    #[test]
    fn a_door_works_in_the_initial_state_and_puts_the_callers_back() {
        /// Denormals to zero, as result and as operand; towards zero; nothing trapped.
        const FAST: u32 = 0x1F80 | 0x8040 | 0x6000;
        assert_eq!(register::other(), None);
        register::set(FAST);
        let inside = {
            let _state = InitialState::enter();
            let half = black_box(f32::MIN_POSITIVE) * black_box(0.5);
            let nearest = black_box(1.0f32) + black_box(1.5 * f32::EPSILON / 2.0);
            (half.to_bits(), nearest.to_bits(), register::other().is_none())
        };
        let after = register::other();
        register::set_initial();
        assert_eq!(inside, (f32::MIN_POSITIVE.to_bits() / 2, 0x3F80_0001, true));
        assert_eq!(after.map(|r| r & !0x3F), Some(FAST));
    }
}
