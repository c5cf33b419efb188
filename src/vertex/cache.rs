//! Which vertices of an indexed draw have been met (OpenGL 1.5, section 2.8). A mesh pays for its vertices, not for its
//! indices: a chunk of the index list becomes a list of its different vertices, each once, and a list of ids that says
//! how they are joined.

/// Different vertices of a chunk.
const CHUNK_VERTICES: u32 = 4096;
/// Indices of a chunk.
const CHUNK_INDICES: usize = 6 * CHUNK_VERTICES as usize;
/// Places of the cache; a vertex has one place, by its index.
const PLACES: usize = 8192;
/// Bits of an id of the pool: ids are below [`CHUNK_VERTICES`] plus what a primitive holds.
const ID_BITS: u32 = 13;

/// A list of indices as it lies in memory.
#[derive(Clone, Copy, Debug)]
pub struct IndexList<'a> {
    /// The bytes.
    pub bytes: &'a [u8],
    /// Bytes of an index: 1, 2 or 4.
    pub size: usize,
}

impl<'a> IndexList<'a> {
    /// How many indices there are.
    #[must_use]
    pub fn len(self) -> usize {
        self.bytes.len() / self.size.max(1)
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// Some of them.
    #[must_use]
    pub fn part(self, from: usize, until: usize) -> Self {
        let until = until.min(self.len());
        Self { bytes: self.bytes.get(from * self.size..until * self.size).unwrap_or_default(), size: self.size }
    }

    /// The indices as numbers.
    pub fn numbers(self) -> impl Iterator<Item = u32> + 'a {
        self.bytes.chunks_exact(self.size.max(1)).map(|b| match *b {
            [a] => u32::from(a),
            [a, b] => u32::from(u16::from_ne_bytes([a, b])),
            [a, b, c, d] => u32::from_ne_bytes([a, b, c, d]),
            _ => 0,
        })
    }
}

/// Vertices of a source and how an indexed draw joins them.
#[derive(Clone, Copy, Debug)]
pub struct Elements<'a> {
    /// Ids of the pool, vertex after vertex of the primitive.
    pub ids: &'a [u32],
    /// Places in the source of the vertices that are new in the pool.
    pub keys: &'a [u32],
}

/// Which vertices of a chunk have been met, by index: a direct-mapped cache. A vertex that was pushed out of its place is
/// transformed again, which changes nothing but time.
#[derive(Clone, Debug, Default)]
pub struct VertexCache {
    /// Index, then the number of the chunk, then the vertex's id in the pool, from the highest bits down.
    places: Vec<u64>,
    chunk: u64,
    /// The chunk's indices as ids of the pool.
    ids: Vec<u32>,
    /// The indices of its vertices, each once.
    keys: Vec<u32>,
}

impl VertexCache {
    /// Turns the next indices of a list into ids of a pool that holds `held` vertices. Returns how many were taken.
    pub fn next_chunk(&mut self, list: IndexList<'_>, held: u32) -> usize {
        self.chunk = (self.chunk + 1) & u64::from(u32::MAX >> ID_BITS);
        if self.chunk == 0 || self.places.is_empty() {
            self.places.clear();
            self.places.resize(PLACES, 0);
            self.chunk = 1;
        }
        self.ids.resize(CHUNK_INDICES, 0);
        self.keys.resize(CHUNK_VERTICES as usize, 0);
        let (taken, vertices) = match list.size {
            1 => self.fill(list.bytes.as_chunks::<1>().0, held),
            2 => self.fill(list.bytes.as_chunks::<2>().0, held),
            _ => self.fill(list.bytes.as_chunks::<4>().0, held),
        };
        self.ids.truncate(taken);
        self.keys.truncate(vertices);
        taken
    }

    /// The ids that the next indices of a list have, and the indices of new vertices. Returns how many indices were taken
    /// and how many vertices there are.
    #[inline]
    fn fill<const BYTES: usize>(&mut self, indices: &[[u8; BYTES]], held: u32) -> (usize, usize) {
        let Some(places) = self.places.first_chunk_mut::<PLACES>() else { return (0, 0) };
        let mut vertices = 0;
        for (taken, (id, bytes)) in self.ids.iter_mut().zip(indices).enumerate() {
            let mut wide = [0; 4];
            wide[..BYTES].copy_from_slice(bytes);
            let index = u32::from_le_bytes(if cfg!(target_endian = "big") { swapped(*bytes) } else { wide });
            let key = u64::from(index) << 32 | self.chunk << ID_BITS;
            let place = &mut places[index as usize % PLACES];
            let found = *place ^ key;
            if found < 1 << ID_BITS {
                *id = found as u32;
                continue;
            }
            let Some(new) = self.keys.get_mut(vertices) else { return (taken, vertices) };
            *new = index;
            *id = held + vertices as u32;
            *place = key | u64::from(*id);
            vertices += 1;
        }
        (self.ids.len().min(indices.len()), vertices)
    }

    /// The chunk that was made last.
    #[must_use]
    pub fn elements(&self) -> Elements<'_> {
        Elements { ids: &self.ids, keys: &self.keys }
    }
}

/// Bytes of a number from the lowest on.
fn swapped<const BYTES: usize>(mut bytes: [u8; BYTES]) -> [u8; 4] {
    bytes.reverse();
    let mut wide = [0; 4];
    wide[..BYTES].copy_from_slice(&bytes);
    wide
}
