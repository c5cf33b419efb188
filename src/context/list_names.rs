//! The names of display lists that are in use (OpenGL 1.5, section 5.4).

use std::collections::BTreeMap;

/// Names in use, as runs: a program may reserve a billion names.
#[derive(Debug, Default)]
pub(crate) struct Names(BTreeMap<u32, u32>);

impl Names {
    /// Whether a name is in use.
    pub(crate) fn contains(&self, name: u32) -> bool {
        self.0.range(..=name).next_back().is_some_and(|(_, last)| *last >= name)
    }

    /// Puts the names of a run into use.
    pub(crate) fn insert(&mut self, first: u32, last: u32) {
        self.remove(first, last);
        self.0.insert(first, last);
    }

    /// Takes the names of a run out of use.
    pub(crate) fn remove(&mut self, first: u32, last: u32) {
        let hit: Vec<_> =
            self.0.range(..=last).rev().take_while(|(_, l)| **l >= first).map(|(f, l)| (*f, *l)).collect();
        for (f, l) in hit {
            self.0.remove(&f);
            if f < first {
                self.0.insert(f, first - 1);
            }
            if l > last {
                self.0.insert(last + 1, l);
            }
        }
    }

    /// The first name of a run of `n` free names, 0 not among them.
    pub(crate) fn find_free(&self, n: u32) -> Option<u32> {
        let mut first = 1_u32;
        for (f, l) in &self.0 {
            if f.checked_sub(first).is_some_and(|gap| gap >= n) {
                return Some(first);
            }
            first = first.max(l.checked_add(1)?);
        }
        first.checked_add(n - 1).map(|_| first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_of_names_split_and_leave_gaps() {
        let mut names = Names::default();
        assert_eq!(names.find_free(10), Some(1));
        names.insert(1, 10);
        names.remove(4, 5);
        assert!(names.contains(3) && !names.contains(4) && !names.contains(5) && names.contains(6));
        assert_eq!(names.find_free(2), Some(4));
        assert_eq!(names.find_free(3), Some(11));
        names.insert(u32::MAX, u32::MAX);
        assert_eq!(names.find_free(u32::MAX), None);
        names.remove(0, u32::MAX);
        assert_eq!(names.find_free(u32::MAX), Some(1));
    }
}
