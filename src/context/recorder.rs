//! The recorder of display lists (OpenGL 1.5, section 5.4): what a list holds and where lists are kept. A list is a
//! vector of commands in the one form that the engine knows; attributes stand in the vector itself, because there are
//! many of them, everything else in a box. Calling and compiling lists is in `lists`.

use super::list_vertices::ListVertices;
use super::table::{evaluators, fragment, imaging, lighting, lists, pixels, raster, texture, transform, vertex};
use super::{Context, Pixels};
use crate::enums::{GL_COMPILE_AND_EXECUTE, GLenum};
use crate::error::{Outcome, out_of_memory};
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
    /// Everything else.
    Other(Box<Other>),
}

macro_rules! others {
    ($($name:ident: $chapter:ident;)*) => {
        /// A command of one of the chapters of the table.
        #[derive(Clone, Debug)]
        pub(crate) enum Other { $( $name($chapter::Op), )* }

        $( impl From<$chapter::Op> for Command {
            fn from(op: $chapter::Op) -> Self { Command::Other(Box::new(Other::$name(op))) }
        } )*

        impl Other {
            /// Carries the command out.
            #[track_caller]
            fn run(&self, cx: &mut Context) {
                match self { $( Other::$name(op) => op.run(cx), )* }
            }
        }
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
    /// Carries the command out, unless it is a call of lists: those are the affair of `Context::run_lists`.
    #[track_caller]
    pub(crate) fn run(&self, cx: &mut Context) {
        match self {
            Command::Vertex(op) => op.run(cx),
            Command::VertexArray(vertices) => vertices.run(cx),
            Command::Other(other) => other.run(cx),
            Command::Call(_) | Command::Calls(_) => {}
        }
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
    pub(crate) names: super::lists::Names,
    pub(crate) open: Option<OpenList>,
}

impl Context {
    /// Adds a command to the open list. Returns whether it is to be carried out as well.
    #[cold]
    #[track_caller]
    pub(crate) fn record(&mut self, name: &'static str, op: impl Into<Command>) -> bool {
        let Some(open) = &mut self.recorder.open else { return true };
        if open.commands.try_reserve(1).is_err() {
            return self.fail(name, out_of_memory("no memory left for the display list; the command is not in it"));
        }
        open.commands.push(op.into());
        open.mode == GL_COMPILE_AND_EXECUTE
    }
}

/// Values of a slice argument that a list keeps.
pub(crate) fn keep<T: Copy>(values: &[T]) -> Outcome<Box<[T]>> {
    let mut kept = Vec::new();
    kept.try_reserve_exact(values.len()).map_err(|_| out_of_memory("no memory left for a display list"))?;
    kept.extend_from_slice(values);
    Ok(kept.into_boxed_slice())
}

/// Bytes of a memory argument that a list keeps as they are.
pub(crate) fn keep_bytes(pixels: &Pixels<'_>) -> Outcome<Pixels<'static>> {
    match pixels {
        Pixels::Null => Ok(Pixels::Null),
        Pixels::Kept(bytes) => Ok(Pixels::Kept(bytes.clone())),
        Pixels::Bytes(bytes) => Ok(Pixels::Kept(keep(bytes)?.into())),
    }
}
