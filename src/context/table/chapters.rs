//! The chapters of the table, each with the macro that holds its rows, in the order of the specification. Whatever is made
//! of all rows is made from this list.

/// Hands the list of chapters to a macro: `chapter: the macro that holds its rows;` for each.
macro_rules! for_each_chapter {
    ($callback:ident) => {
        $callback! {
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
    };
}
pub(crate) use for_each_chapter;
