//! The rows of the table as data, for its tests.

use super::chapters::for_each_chapter;
use super::methods;

/// When a command is allowed and whether a display list records it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Allowed between Begin and End, recorded.
    Begin,
    /// Not allowed between Begin and End, recorded.
    List,
    /// Like `List`, but carried out at once for a proxy target.
    Proxy,
    /// Like `List`, but carried out at once for client state.
    Client,
    /// Not allowed between Begin and End, never recorded.
    Now,
}

/// A row of the table as data: what the tests of the table go through.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The command's name in C.
    pub name: &'static str,
    /// Further names of the same command, from the extensions it comes from.
    pub aliases: &'static [&'static str],
    /// When the command is allowed and whether a list records it.
    pub class: Class,
}

macro_rules! class {
    (begin) => {
        $crate::context::table::rows::Class::Begin
    };
    (list) => {
        $crate::context::table::rows::Class::List
    };
    (proxy) => {
        $crate::context::table::rows::Class::Proxy
    };
    (client) => {
        $crate::context::table::rows::Class::Client
    };
    (now) => {
        $crate::context::table::rows::Class::Now
    };
}

macro_rules! row {
    ($class:ident $name:ident $(| $alias:ident)*) => {
        $crate::context::table::rows::Row {
            name: stringify!($name),
            aliases: &[$(stringify!($alias)),*],
            class: $crate::context::table::rows::class!($class),
        }
    };
}
pub(crate) use {class, row};

macro_rules! chapters {
    ($($chapter:ident: $table:ident;)*) => {
        /// The rows of each chapter.
        const CHAPTERS: &[&[Row]] = &[$( methods::$chapter::ROWS ),*];
    };
}
for_each_chapter!(chapters);

/// All rows of the table.
pub fn rows() -> impl Iterator<Item = &'static Row> {
    CHAPTERS.iter().copied().flatten()
}
