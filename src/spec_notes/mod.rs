//! The pages of the folder `spec-notes/`, within the documentation.
//!

// A page links to another by `[text][page.md]` and ends with the definitions of its links as files. Here the definitions
// of `links.md` stand before it, and the first definition counts.
#![doc = include_str!("links.md")]
#![doc = include_str!("../../spec-notes/README.md")]

macro_rules! pages {
    ($($name:ident = $file:literal;)*) => {$(
        #[doc = include_str!("links.md")]
        #[doc = include_str!(concat!("../../spec-notes/", $file))]
        pub mod $name {}
    )*};
}

pages! {
    how_a_vertex_becomes_a_pixel = "how-a-vertex-becomes-a-pixel.md";
    exactness = "exactness.md";
    commands = "commands.md";
    state_and_errors = "state-and-errors.md";
    vertices = "vertices.md";
    vertex_arrays = "vertex-arrays.md";
    transformation = "transformation.md";
    texture_coordinates = "texture-coordinates.md";
    clipping = "clipping.md";
    lighting = "lighting.md";
    rasterisation = "rasterisation.md";
    lines_and_points = "lines-and-points.md";
    threads_and_bands = "threads-and-bands.md";
    imaging = "imaging.md";
    evaluators = "evaluators.md";
    selection_and_feedback = "selection-and-feedback.md";
    pixel_rectangles = "pixel-rectangles.md";
    pixels = "pixels.md";
    texture_images = "texture-images.md";
    texture_objects = "texture-objects.md";
    texture_addressing = "texture-addressing.md";
    texture_filtering = "texture-filtering.md";
    cube_and_shadow = "cube-and-shadow.md";
    texture_environments = "texture-environments.md";
    fragments = "fragments.md";
    fog = "fog.md";
    per_fragment_operations = "per-fragment-operations.md";
    framebuffer = "framebuffer.md";
    glu = "glu.md";
    files = "files.md";
    stability = "stability.md";
    leaving_out = "leaving-out.md";
    measuring = "measuring.md";
    performance = "performance.md";
    performance_diary = "performance-diary.md";
    report = "report.md";
    oracle = "oracle.md";
}
