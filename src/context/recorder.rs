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
    Calls(Box<[u32]>),
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
    pub(crate) pairs: Box<[Command]>,
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

/// A display list.
pub(crate) type List = Arc<[Command]>;

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
}
