//! Pixel rectangles (OpenGL 1.5, sections 3.6 and 4.3): the way between the bytes of a client and rows of colours,
//! depths, indices.
