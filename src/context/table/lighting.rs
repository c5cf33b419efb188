//! Chapter of the table: lighting and fog (OpenGL 1.5, sections 2.14 and 3.10). The typed forms of a parameter command
//! become one canonical command with [`Params`]: integer colours are mapped by table 2.6, enumerants pass unchanged.

macro_rules! lighting_table { ($generate:ident) => { $generate! {
    title "Colours and lighting (section 2.14)";
    canonical {
        list Light light(light: enum, pname: enum, params: params);
        list LightModel light_model(pname: enum, params: params);
        begin Material material(face: enum, pname: enum, params: params);
        list Fog fog(pname: enum, params: params);
    }
    commands {
        /// Makes material parameters follow the current colour (section 2.14.3). `INVALID_ENUM` for other faces and
        /// parameters than `FRONT`, `BACK`, `FRONT_AND_BACK` and the colours.
        list glColorMaterial color_material(face: enum, mode: enum);
        /// Selects flat or smooth shading (section 2.14.7). `INVALID_ENUM` if `mode` is neither `FLAT` nor `SMOOTH`.
        list glShadeModel shade_model(mode: enum);
        /// Selects what a front face is (section 2.14.1): `CW` or `CCW`, else `INVALID_ENUM`.
        list glFrontFace front_face(mode: enum);
    }
    forms {
        family "Sets a parameter of a light (section 2.14.1); positions and directions are transformed by the modelview matrix. `INVALID_ENUM` for other lights and names, `INVALID_VALUE` for numbers out of range." {
            list glLighti lighti(light: enum, pname: enum, param: i32) => light(light, pname, &Params::int(param));
            list glLightf lightf(light: enum, pname: enum, param: f32) => light(light, pname, &Params::float(param));
            list glLightiv lightiv(light: enum, pname: enum, params: (upto i32: light(pname))) => light(light, pname, &Params::ints(params));
            #[doc = include_str!("examples/light.md")]
            list glLightfv lightfv(light: enum, pname: enum, params: (upto f32: light(pname))) => light(light, pname, &Params::floats(params));
        }
        family "Sets a parameter of the lighting model (section 2.14.1)." {
            list glLightModeli light_modeli(pname: enum, param: i32) => light_model(pname, &Params::int(param));
            list glLightModelf light_modelf(pname: enum, param: f32) => light_model(pname, &Params::float(param));
            list glLightModeliv light_modeliv(pname: enum, params: (upto i32: light_model(pname))) => light_model(pname, &Params::ints(params));
            list glLightModelfv light_modelfv(pname: enum, params: (upto f32: light_model(pname))) => light_model(pname, &Params::floats(params));
        }
        family "Sets a parameter of the material (section 2.14.1), also between Begin and End. `INVALID_VALUE` for a shininess outside [0, 128]." {
            begin glMateriali materiali(face: enum, pname: enum, param: i32) => material(face, pname, &Params::int(param));
            begin glMaterialf materialf(face: enum, pname: enum, param: f32) => material(face, pname, &Params::float(param));
            begin glMaterialiv materialiv(face: enum, pname: enum, params: (upto i32: material(pname))) => material(face, pname, &Params::ints(params));
            #[doc = include_str!("examples/material.md")]
            begin glMaterialfv materialfv(face: enum, pname: enum, params: (upto f32: material(pname))) => material(face, pname, &Params::floats(params));
        }
        family "Sets a parameter of the fog (section 3.10). `INVALID_VALUE` for a negative density." {
            list glFogi fogi(pname: enum, param: i32) => fog(pname, &Params::int(param));
            list glFogf fogf(pname: enum, param: f32) => fog(pname, &Params::float(param));
            list glFogiv fogiv(pname: enum, params: (upto i32: fog(pname))) => fog(pname, &Params::ints(params));
            list glFogfv fogfv(pname: enum, params: (upto f32: fog(pname))) => fog(pname, &Params::floats(params));
        }
    }
    context {}
    now {}
    queries {
        family "A parameter of a light; positions are in eye coordinates (section 6.1.3)." {
            glGetLightiv get_lightiv(light: enum, pname: enum) -> i32 => get_light(light, pname);
            glGetLightfv get_lightfv(light: enum, pname: enum) -> f32 => get_light(light, pname);
        }
        family "A parameter of the material of a face (section 6.1.3)." {
            glGetMaterialiv get_materialiv(face: enum, pname: enum) -> i32 => get_material(face, pname);
            glGetMaterialfv get_materialfv(face: enum, pname: enum) -> f32 => get_material(face, pname);
        }
    }
    answers {
        get_light(light: enum, pname: enum);
        get_material(face: enum, pname: enum);
    }
    manual {}
} } }

pub(crate) use lighting_table;
