//! Chapter of the table: points, lines, polygons, antialiasing hints and multisampling (OpenGL 1.5, chapter 3 up to 3.5,
//! sections 3.2.1 and 5.6).

macro_rules! raster_table { ($generate:ident) => { $generate! {
    title "Points, lines, polygons and hints (sections 3.3 to 3.5, 5.6)";
    canonical {
        list PointParameter point_parameter(pname: enum, params: params);
    }
    commands {
        /// Sets the diameter of points (section 3.3). `INVALID_VALUE` if it is not positive.
        list glPointSize point_size(size: f32);
        /// Sets the width of lines (section 3.4). `INVALID_VALUE` if it is not positive.
        list glLineWidth line_width(width: f32);
        /// Sets the pattern of stippled lines and how often each bit is repeated (section 3.4.2); the factor is clamped to
        /// [1, 256].
        list glLineStipple line_stipple(factor: i32, pattern: u16);
        /// Selects the faces that culling discards (section 3.5.1): `FRONT`, `BACK` or `FRONT_AND_BACK`, else
        /// `INVALID_ENUM`.
        list glCullFace cull_face(mode: enum);
        /// Selects how polygons are drawn (section 3.5.4): `POINT`, `LINE` or `FILL`, else `INVALID_ENUM`.
        list glPolygonMode polygon_mode(face: enum, mode: enum);
        /// Sets the depth offset of polygons (section 3.5.5).
        list glPolygonOffset polygon_offset(factor: f32, units: f32);
        /// Sets the depth offset of polygons, its constant part in depths of [0, 1] (EXT_polygon_offset).
        list glPolygonOffsetEXT polygon_offset_ext(factor: f32, bias: f32);
        /// Sets the stipple pattern of polygons: 32 rows of 32 bits under the unpack state (section 3.5.2).
        list glPolygonStipple polygon_stipple(mask: (rect [32, 32], GL_COLOR_INDEX, GL_BITMAP));
        /// Sets sample coverage for multisampling (section 4.1.3).
        list glSampleCoverage | glSampleCoverageARB sample_coverage(value: f32, invert: bool);
        /// Asks for speed or quality where the specification leaves a choice (section 5.6). `INVALID_ENUM` for other
        /// targets and modes.
        list glHint hint(target: enum, mode: enum);
    }
    forms {
        family "Sets how the size of points follows their distance (section 3.3). `INVALID_VALUE` for a negative number." {
            list glPointParameteri point_parameteri(pname: enum, param: i32) => point_parameter(pname, &Params::int(param));
            list glPointParameterf | glPointParameterfARB | glPointParameterfEXT point_parameterf(pname: enum, param: f32) => point_parameter(pname, &Params::float(param));
            list glPointParameteriv point_parameteriv(pname: enum, params: (upto i32: point_parameter(pname))) => point_parameter(pname, &Params::ints(params));
            list glPointParameterfv | glPointParameterfvARB | glPointParameterfvEXT point_parameterfv(pname: enum, params: (upto f32: point_parameter(pname))) => point_parameter(pname, &Params::floats(params));
        }
    }
    context {}
    now {
        /// Writes the polygon stipple pattern under the pack state (section 6.1.6).
        now glGetPolygonStipple get_polygon_stipple(mask: (rect_out [32, 32], GL_COLOR_INDEX, GL_BITMAP));
    }
    queries {}
    answers {}
    manual {}
} } }

pub(crate) use raster_table;
