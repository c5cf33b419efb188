//! Welding: equal vertices of a store become one. A display list of separate triangles has each vertex of a mesh about six
//! times; a welded store has it once, and a list of indices, as if the program had called DrawElements. A vertex depends on
//! nothing but its attributes, so no bit changes.

use super::cache::IndexList;
use super::vertex_store::VertexStore;

/// How many entries of the hash table are compared before a vertex counts as new, so that no input takes long.
const PROBES: usize = 8;

/// Vertices, each once, and the order in which they are drawn.
#[derive(Clone, Debug, Default)]
pub struct Welded {
    /// The vertices.
    pub store: VertexStore,
    /// Their indices, 4 bytes each.
    indices: Vec<u8>,
}

impl Welded {
    /// Welds a store; `None` where it is not worth it, or where there is no memory.
    #[must_use]
    pub fn new(store: &VertexStore) -> Option<Self> {
        let count = store.len();
        let size = count.checked_mul(2)?.checked_next_power_of_two()?;
        let (mut table, mut indices, mut first) = (Vec::<u32>::new(), Vec::new(), Vec::<u32>::new());
        table.try_reserve_exact(size).ok()?;
        indices.try_reserve_exact(count.checked_mul(4)?).ok()?;
        table.resize(size, u32::MAX);
        for vertex in 0..u32::try_from(count).ok()? {
            let hash = store
                .numbers(vertex)
                .fold(0u64, |h, v| (h ^ u64::from(v.to_bits())).wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(29));
            let mut id = None;
            for probe in 0..PROBES {
                let entry = table.get_mut((hash as usize).wrapping_add(probe) & (size - 1))?;
                if *entry == u32::MAX {
                    *entry = first.len() as u32;
                    break;
                }
                let like = *first.get(*entry as usize)?;
                let bits = |vertex| store.numbers(vertex).map(f32::to_bits);
                if bits(like).eq(bits(vertex)) {
                    id = Some(*entry);
                    break;
                }
            }
            let id = id.unwrap_or(first.len() as u32);
            if id as usize == first.len() {
                // It is worth it only where most vertices repeat.
                if first.len() > count / 2 || first.try_reserve(1).is_err() {
                    return None;
                }
                first.push(vertex);
            }
            indices.extend_from_slice(&id.to_ne_bytes());
        }
        Some(Self { store: store.chosen(&first)?, indices })
    }

    /// The order in which the vertices are drawn.
    #[must_use]
    pub fn list(&self) -> IndexList<'_> {
        IndexList { bytes: &self.indices, size: size_of::<u32>() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::LANES;
    use crate::state::current::Current;
    use crate::vertex::batch::{VertexBatch, needs};

    fn store(vertices: impl Iterator<Item = ([f32; 4], [f32; 4])>) -> VertexStore {
        let (mut store, mut batch) = (VertexStore::default(), VertexBatch::new());
        store.clear(needs::COLOR, LANES);
        for (position, color) in vertices {
            batch.push(position, &Current { color, ..Current::default() }, needs::COLOR);
            if batch.n == LANES {
                assert!(store.push(&mut batch));
                batch.clear();
            }
        }
        assert!(store.push(&mut batch));
        store
    }

    #[test]
    fn equal_vertices_become_one_and_others_stay() {
        let vertex = |i: usize| ([(i % 30) as f32, -0.0, 0.0, 1.0], [(i % 2) as f32, 0.5, 0.0, 1.0]);
        let whole = store((0..300).map(vertex));
        let welded = Welded::new(&whole).unwrap();
        assert_eq!((welded.store.len(), welded.list().len()), (30, 300));
        for (i, key) in welded.list().numbers().enumerate() {
            let (a, b) = (whole.numbers(i as u32), welded.store.numbers(key));
            assert!(a.map(f32::to_bits).eq(b.map(f32::to_bits)), "vertex {i}");
        }
        // 0 and -0 are not the same bits.
        let zeros = store((0..200).map(|i| ([if i % 2 == 0 { 0.0 } else { -0.0 }; 4], [1.0; 4])));
        assert_eq!(Welded::new(&zeros).unwrap().store.len(), 2);
    }

    #[test]
    fn a_store_of_different_vertices_is_left_alone() {
        assert!(Welded::new(&store((0..200).map(|i| ([i as f32, 0.0, 0.0, 1.0], [1.0; 4])))).is_none());
    }
}
