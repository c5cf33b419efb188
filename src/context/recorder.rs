//! The recorder of display lists (OpenGL 1.5, section 5.4): what a list holds and where lists are kept. A list is a
//! vector of commands in the one form that the engine knows; attributes stand in the vector itself, because there are
//! many of them, everything else in a box. Nothing here needs the context: recording and calling are in `lists`.

use super::list_names::Names;
use super::list_vertices::ListVertices;
use super::table::ops::{evaluators, fragment, imaging, lighting, lists, pixels, raster, texture, transform, vertex};
use crate::enums::GLenum;
use crate::error::GlError;
use std::collections::BTreeMap;
use std::sync::Arc;

/// One command of a display list.
#[derive(Clone, Debug)]
pub(crate) enum Command {
    /// Begin, End and the attributes between them.
    Vertex(vertex::Op),
    /// A Begin/End pair as an array of vertices.
    VertexArray(Box<ListVertices>),
    /// A call of a list.
    Call(u32),
    /// Calls of lists by offsets from the list base.
    Calls(Arc<Vec<u32>>),
    /// A draw from arrays, with what the arrays held.
    Draw(Box<ListDraw>),
    /// A command that was wrong when it was recorded.
    Failed(Box<FailedCommand>),
    /// Everything else.
    Other(Box<Other>),
}

/// A draw from arrays (section 2.8). It is one command: it is refused between Begin and End, and it leaves the current
/// values as they were.
#[derive(Clone, Debug)]
pub(crate) struct ListDraw {
    /// The command's name in C.
    pub(crate) name: &'static str,
    /// Its primitives as Begin/End pairs.
    pub(crate) pairs: Vec<Command>,
}

/// A command whose arguments are lost, because they were wrong. Its error belongs to its execution (section 5.4).
#[derive(Clone, Debug)]
pub(crate) struct FailedCommand {
    /// The command's name in C.
    pub(crate) name: &'static str,
    /// Whether it may stand between Begin and End.
    pub(crate) inside: bool,
    /// What was wrong.
    pub(crate) error: GlError,
}

macro_rules! others {
    ($($name:ident: $chapter:ident;)*) => {
        /// A command of one of the chapters of the table.
        #[derive(Clone, Debug)]
        pub(crate) enum Other { $( $name($chapter::Op), )* }

        $( impl From<$chapter::Op> for Command {
            fn from(op: $chapter::Op) -> Self { Command::Other(Box::new(Other::$name(op))) }
        } )*
    };
}
others! {
    Transform: transform;
    Lighting: lighting;
    Raster: raster;
    Texture: texture;
    Pixels: pixels;
    Fragment: fragment;
    Lists: lists;
    Evaluators: evaluators;
    Imaging: imaging;
}

impl From<vertex::Op> for Command {
    fn from(op: vertex::Op) -> Self {
        Command::Vertex(op)
    }
}

impl Command {
    /// What carrying the command out once takes, in vertices. Images and pixels, which the engine counts as it writes
    /// them, and what a called list holds are not in it.
    pub(crate) fn work(&self) -> u64 {
        /// A change of state may lead to new plans, which take a microsecond.
        const CHANGE: u64 = 16;
        match self {
            Command::Vertex(_) => 1,
            Command::VertexArray(vertices) => vertices.len() as u64,
            Command::Call(_) | Command::Calls(_) => 1,
            Command::Draw(draw) => draw.pairs.iter().fold(CHANGE, |sum, pair| sum.saturating_add(pair.work())),
            Command::Other(_) | Command::Failed(_) => CHANGE,
        }
    }
}

/// A display list.
#[derive(Debug)]
pub(crate) struct ListData {
    pub(crate) commands: Vec<Command>,
    /// What carrying it out once takes, in vertices, without the lists that it calls.
    pub(crate) work: u64,
}

/// A display list that may be carried out and be replaced meanwhile.
pub(crate) type List = Arc<ListData>;

/// The list that is being compiled.
#[derive(Debug)]
pub(crate) struct OpenList {
    pub(crate) name: u32,
    pub(crate) mode: GLenum,
    pub(crate) commands: Vec<Command>,
}

/// All lists of a context and the one that is open.
#[derive(Debug, Default)]
pub(crate) struct Recorder {
    pub(crate) lists: BTreeMap<u32, List>,
    pub(crate) names: Names,
    pub(crate) open: Option<OpenList>,
    /// What carrying each list out once takes, in vertices.
    pub(crate) work: u64,
}

impl Recorder {
    /// Keeps a list in the place of the one that has had the name.
    pub(crate) fn insert(&mut self, name: u32, commands: Vec<Command>) {
        let work = commands.iter().fold(0, |sum: u64, command| sum.saturating_add(command.work()));
        self.work = self.work.saturating_add(work);
        if let Some(old) = self.lists.insert(name, Arc::new(ListData { commands, work })) {
            self.work = self.work.saturating_sub(old.work);
        }
    }

    /// Forgets the lists of a range of names.
    pub(crate) fn remove(&mut self, first: u32, last: u32) {
        let mut after = self.lists.split_off(&first);
        if let Some(next) = last.checked_add(1) {
            self.lists.append(&mut after.split_off(&next));
        }
        self.work = after.values().fold(self.work, |work, list| work.saturating_sub(list.work));
    }
}
