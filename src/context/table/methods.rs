//! The methods of `Context`, a chapter of the table after the other: the rows of each are handed to [`chapter!`]. Nothing
//! uses this file but the tests of the table.

use super::chapters::for_each_chapter;
use super::generate::chapter;
use super::ops;

macro_rules! chapters {
    ($($chapter:ident: $table:ident;)*) => {
        $( pub(crate) mod $chapter {
            #[allow(unused_imports, reason = "not every chapter has commands that a list can hold")]
            use super::ops::$chapter::*;
            use super::chapter;
            #[allow(unused_imports, reason = "not every chapter has parameters that come in several types")]
            use crate::context::Params;
            #[allow(unused_imports, reason = "forms convert their arguments to those of the canonical command")]
            use crate::context::convert::*;
            #[allow(unused_imports, reason = "size expressions name enumerants")]
            use crate::enums::{GL_BITMAP, GL_COLOR_INDEX};
            $crate::context::table::$chapter::$table!(chapter);
        } )*
    };
}
for_each_chapter!(chapters);
