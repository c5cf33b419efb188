//! The functions of GLU that come in families, a row each (GLU 1.3, section 3.2 and chapter 6): the safe functions and both
//! C doors are defined from these rows.

/// Hands a macro the functions that build mipmaps: dimensions, name in C and here, the same for chosen levels, the sizes,
/// and the size that the image has in memory.
macro_rules! mipmap_rows {
    ($define:ident) => {
        $define! {
            1 gluBuild1DMipmaps build_1d_mipmaps gluBuild1DMipmapLevels build_1d_mipmap_levels (width) [width, 1];
            2 gluBuild2DMipmaps build_2d_mipmaps gluBuild2DMipmapLevels build_2d_mipmap_levels (width, height) [width, height];
            3 gluBuild3DMipmaps build_3d_mipmaps gluBuild3DMipmapLevels build_3d_mipmap_levels (width, height, depth)
                [width, height, depth];
        }
    };
}
pub(crate) use mipmap_rows;

/// Hands a macro the functions that draw a quadric: name in C, method, and the arguments: numbers, counts, numbers.
macro_rules! quadric_rows {
    ($define:ident) => {
        $define! {
            gluSphere sphere (radius) (slices, stacks) ();
            gluCylinder cylinder (base, top, height) (slices, stacks) ();
            gluDisk disk (inner, outer) (slices, loops) ();
            gluPartialDisk partial_disk (inner, outer) (slices, loops) (start, sweep);
        }
    };
}
pub(crate) use quadric_rows;
