//! The primitives that Begin and the draw commands name (OpenGL 1.5, section 2.6.1).

use crate::enums::gl_enum;

gl_enum! {
    /// What vertices become.
    #[derive(Default)]
    pub enum PrimitiveMode {
        #[default]
        Points = GL_POINTS,
        Lines = GL_LINES,
        LineLoop = GL_LINE_LOOP,
        LineStrip = GL_LINE_STRIP,
        Triangles = GL_TRIANGLES,
        TriangleStrip = GL_TRIANGLE_STRIP,
        TriangleFan = GL_TRIANGLE_FAN,
        Quads = GL_QUADS,
        QuadStrip = GL_QUAD_STRIP,
        Polygon = GL_POLYGON,
    }
}
