//! Batches, stages and plans. A *batch* is 64 of something (vertices, fragments) as structures of arrays; a *stage* is a
//! plain loop over the lanes of a batch; a *plan* is the list of stages that the current state needs. Each stage body is
//! compiled three times (baseline x86-64, AVX2, AVX-512) from one source, and one of the three is picked at start. Since
//! rustc never contracts `a*b+c`, all three give the same bits.

mod bits;
mod boxed;
mod counters;
mod level;
mod stage;

pub use bits::{BITS, count};
pub(crate) use boxed::boxed;
pub use counters::{Counters, PixelCost, StageCount, Tally};
pub use level::SimdLevel;
/// Its short name within the crate.
pub(crate) use level::SimdLevel as Level;
pub(crate) use stage::stage;
pub use stage::{Cost, Plan, Stage, StageId, StageInfo, Step};

/// How many lanes a batch has.
pub const LANES: usize = 64;

/// One float for each lane.
pub type Lanes = [f32; LANES];
