//! The methods of `Context`, a chapter of the table after the other: the rows of each are handed to [`chapter!`]. Nothing
//! uses this file but the tests of the table.

use super::generate::chapter;
use super::ops;
use super::{
    arrays::arrays_table, evaluators::evaluators_table, fragment::fragment_table, get::get_table,
    imaging::imaging_table, lighting::lighting_table, lists::lists_table, pixels::pixels_table, raster::raster_table,
    texture::texture_table, transform::transform_table, vertex::vertex_table,
};

macro_rules! chapters {
    ($($chapter:ident: $table:ident;)*) => {
        $( pub(crate) mod $chapter {
            #[allow(unused_imports, reason = "not every chapter has commands that a list can hold")]
            use super::ops::$chapter::*;
            use super::{chapter, $table};
            #[allow(unused_imports, reason = "not every chapter has parameters that come in several types")]
            use crate::context::Params;
            #[allow(unused_imports, reason = "forms convert their arguments to those of the canonical command")]
            use crate::context::convert::*;
            #[allow(unused_imports, reason = "size expressions name enumerants")]
            use crate::enums::{GL_BITMAP, GL_COLOR_INDEX};
            $table!(chapter);
        } )*
    };
}
chapters! {
    vertex: vertex_table;
    transform: transform_table;
    lighting: lighting_table;
    raster: raster_table;
    texture: texture_table;
    pixels: pixels_table;
    fragment: fragment_table;
    arrays: arrays_table;
    evaluators: evaluators_table;
    lists: lists_table;
    get: get_table;
    imaging: imaging_table;
}
