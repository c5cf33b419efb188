//! Chapter of the table: evaluators (OpenGL 1.5, section 5.1). Control points travel as doubles with the strides that the
//! program gave; typed forms of the evaluation become one canonical command.

macro_rules! evaluators_table { ($generate:ident) => { $generate! {
    title "Evaluators (section 5.1)";
    canonical {
        list Map1 map1(target: enum, u1: f64, u2: f64, stride: i32, order: i32, points: (upto f64:));
        list Map2 map2(target: enum, u1: f64, u2: f64, ustride: i32, uorder: i32, v1: f64, v2: f64, vstride: i32,
            vorder: i32, points: (upto f64:));
        list MapGrid1 map_grid1(un: i32, u1: f64, u2: f64);
        list MapGrid2 map_grid2(un: i32, u1: f64, u2: f64, vn: i32, v1: f64, v2: f64);
        begin EvalCoord1 eval_coord1(u: f64);
        begin EvalCoord2 eval_coord2(u: f64, v: f64);
    }
    commands {
        /// Evaluates at a point of the one-dimensional grid (section 5.1).
        begin glEvalPoint1 eval_point1(i: i32);
        /// Evaluates at a point of the two-dimensional grid (section 5.1).
        begin glEvalPoint2 eval_point2(i: i32, j: i32);
        /// Draws a part of the one-dimensional grid (section 5.1). `INVALID_ENUM` if `mode` is neither `POINT` nor `LINE`.
        list glEvalMesh1 eval_mesh1(mode: enum, i1: i32, i2: i32);
        /// Draws a part of the two-dimensional grid (section 5.1). `INVALID_ENUM` if `mode` is not `POINT`, `LINE` or
        /// `FILL`.
        list glEvalMesh2 eval_mesh2(mode: enum, i1: i32, i2: i32, j1: i32, j2: i32);
    }
    forms {
        family "Sets a one-dimensional map (section 5.1). `INVALID_VALUE` if the ends coincide, the stride is too small or the order out of range." {
            list glMap1f map1f(target: enum, u1: f32, u2: f32, stride: i32, order: i32,
                points: (upto f32: map1(target, stride, order)))
                => map1(target, f64::from(u1), f64::from(u2), stride, order, &doubles(points));
            list glMap1d map1d(target: enum, u1: f64, u2: f64, stride: i32, order: i32,
                points: (upto f64: map1(target, stride, order))) => map1(target, u1, u2, stride, order, points);
        }
        family "Sets a two-dimensional map (section 5.1). `INVALID_VALUE` if ends coincide, a stride is too small or an order out of range." {
            list glMap2f map2f(target: enum, u1: f32, u2: f32, ustride: i32, uorder: i32, v1: f32, v2: f32, vstride: i32,
                vorder: i32, points: (upto f32: map2(target, ustride, uorder, vstride, vorder)))
                => map2(target, f64::from(u1), f64::from(u2), ustride, uorder, f64::from(v1), f64::from(v2), vstride,
                    vorder, &doubles(points));
            list glMap2d map2d(target: enum, u1: f64, u2: f64, ustride: i32, uorder: i32, v1: f64, v2: f64, vstride: i32,
                vorder: i32, points: (upto f64: map2(target, ustride, uorder, vstride, vorder)))
                => map2(target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, points);
        }
        family "Sets the one-dimensional grid (section 5.1). `INVALID_VALUE` if it has no steps." {
            list glMapGrid1f map_grid1f(un: i32, u1: f32, u2: f32) => map_grid1(un, f64::from(u1), f64::from(u2));
            list glMapGrid1d map_grid1d(un: i32, u1: f64, u2: f64) => map_grid1(un, u1, u2);
        }
        family "Sets the two-dimensional grid (section 5.1). `INVALID_VALUE` if it has no steps." {
            list glMapGrid2f map_grid2f(un: i32, u1: f32, u2: f32, vn: i32, v1: f32, v2: f32)
                => map_grid2(un, f64::from(u1), f64::from(u2), vn, f64::from(v1), f64::from(v2));
            list glMapGrid2d map_grid2d(un: i32, u1: f64, u2: f64, vn: i32, v1: f64, v2: f64)
                => map_grid2(un, u1, u2, vn, v1, v2);
        }
        family "Evaluates the enabled one-dimensional maps (section 5.1)." {
            begin glEvalCoord1f eval_coord1f(u: f32) => eval_coord1(f64::from(u));
            begin glEvalCoord1d eval_coord1d(u: f64) => eval_coord1(u);
            begin glEvalCoord1fv eval_coord1fv(u: [f32; 1]) => eval_coord1(f64::from(u[0]));
            begin glEvalCoord1dv eval_coord1dv(u: [f64; 1]) => eval_coord1(u[0]);
        }
        family "Evaluates the enabled two-dimensional maps (section 5.1)." {
            begin glEvalCoord2f eval_coord2f(u: f32, v: f32) => eval_coord2(f64::from(u), f64::from(v));
            begin glEvalCoord2d eval_coord2d(u: f64, v: f64) => eval_coord2(u, v);
            begin glEvalCoord2fv eval_coord2fv(u: [f32; 2]) => eval_coord2(f64::from(u[0]), f64::from(u[1]));
            begin glEvalCoord2dv eval_coord2dv(u: [f64; 2]) => eval_coord2(u[0], u[1]);
        }
    }
    context {}
    now {}
    queries {
        family "Coefficients, order or domain of a map (section 6.1.3)." {
            glGetMapdv get_mapdv(target: enum, query: enum) -> f64 => get_map(target, query);
            glGetMapfv get_mapfv(target: enum, query: enum) -> f32 => get_map(target, query);
            glGetMapiv get_mapiv(target: enum, query: enum) -> i32 => get_map(target, query);
        }
    }
    answers {
        get_map(target: enum, query: enum);
    }
    manual {}
} } }

pub(crate) use evaluators_table;
