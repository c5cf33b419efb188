//! The extension string is true: each extension that it names has all its commands and enumerants, as Khronos' registry
//! (`gl.xml`) lists them, with the registry's values, and each of them does something.

use super::rows::{Row, rows};
use crate::enums::{self, *};
use crate::limits::MAX_TEXTURE_UNITS;
use crate::{Context, NULL};
use std::collections::{BTreeMap, BTreeSet};

/// Names of the time that the registry does not have. Other libraries name them, programs look for them, and what they
/// stand for is what the registry has under the second name.
const UNREGISTERED: [(&str, &str); 2] = [
    ("GL_EXT_texture_edge_clamp", "GL_SGIS_texture_edge_clamp"),
    ("GL_EXT_texture_rectangle", "GL_ARB_texture_rectangle"),
];

/// What the registry says of an extension.
#[derive(Debug, Default)]
struct Extension<'a> {
    commands: Vec<&'a str>,
    enums: Vec<&'a str>,
}

/// The parts of the registry that concern OpenGL (not OpenGL ES).
struct Registry<'a> {
    extensions: BTreeMap<&'a str, Extension<'a>>,
    values: BTreeMap<&'a str, u32>,
    /// A command and the one that it is another name of.
    aliases: BTreeMap<&'a str, &'a str>,
}

/// The value of an attribute of an XML tag.
fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let start = tag.find(&format!(" {name}=\""))? + name.len() + 3;
    tag[start..].split('"').next()
}

/// The tags of a text that begin with a name.
fn tags<'a>(text: &'a str, name: &'static str) -> impl Iterator<Item = &'a str> {
    text.split('<').filter(move |tag| tag.starts_with(name) && tag[name.len()..].starts_with([' ', '>', '/']))
}

/// The elements of a name, each with its tag and its content; none holds another of the same name.
fn elements<'a>(text: &'a str, name: &str) -> Vec<&'a str> {
    let (start, end) = (format!("<{name}"), format!("</{name}>"));
    let content = |part: &'a str| {
        let tag = part.split('>').next()?;
        if tag.ends_with('/') { Some(tag) } else { part.split(end.as_str()).next() }
    };
    text.split(start.as_str()).skip(1).filter(|part| part.starts_with(' ')).filter_map(content).collect()
}

fn registry() -> Registry<'static> {
    let text = std::str::from_utf8(khronos_api::GL_XML).expect("text");
    let of_gl = |tag: &str| attribute(tag, "api").is_none_or(|api| api == "gl");
    let mut values = BTreeMap::new();
    for tag in tags(text, "enum").filter(|tag| of_gl(tag)) {
        if let (Some(name), Some(value)) = (attribute(tag, "name"), attribute(tag, "value")) {
            let value = value.strip_prefix("0x").map_or_else(|| value.parse(), |hex| u32::from_str_radix(hex, 16));
            values.extend(value.ok().map(|value| (name, value)));
        }
    }
    let extensions = elements(text, "extension").into_iter().map(|element| {
        let mut extension = Extension::default();
        for part in element.split("<require").skip(1).filter(|part| of_gl(part.split('>').next().unwrap_or_default())) {
            extension.commands.extend(tags(part, "command").filter_map(|tag| attribute(tag, "name")));
            extension.enums.extend(tags(part, "enum").filter_map(|tag| attribute(tag, "name")));
        }
        (attribute(element, "name").unwrap_or_default(), extension)
    });
    let extensions = extensions.collect();
    let mut aliases = BTreeMap::new();
    for command in text.split("<proto").skip(1) {
        let command = command.split("</command>").next().unwrap_or_default();
        let name = command.split("<name>").nth(1).and_then(|rest| rest.split('<').next());
        let alias = tags(command, "alias").find_map(|tag| attribute(tag, "name"));
        if let (Some(name), Some(alias)) = (name, alias) {
            aliases.insert(name, alias);
        }
    }
    Registry { extensions, values, aliases }
}

/// The extensions of the string, each as the registry describes it.
fn advertised<'a>(registry: &'a Registry<'_>) -> Vec<(&'static str, &'a Extension<'a>)> {
    let mut cx = Context::new(1, 1);
    let names = cx.get_string(GL_EXTENSIONS).split_whitespace();
    names
        .map(|name| {
            let registered = UNREGISTERED.iter().find(|row| row.0 == name).map_or(name, |row| row.1);
            (name, registry.extensions.get(registered).unwrap_or_else(|| panic!("{name} is not in the registry")))
        })
        .collect()
}

/// The row of a command by any of its names.
fn row(name: &str) -> Option<&'static Row> {
    rows().find(|row| row.name == name || row.aliases.contains(&name))
}

#[test]
fn the_extension_string_is_sorted_and_ends_with_a_space() {
    let mut cx = Context::new(1, 1);
    let text = cx.get_string(GL_EXTENSIONS);
    let names: Vec<_> = text.split(' ').collect();
    let (last, names) = names.split_last().unwrap();
    assert_eq!(*last, "", "a program that looks for \"NAME \" finds the last one, too");
    assert!(names.iter().all(|name| name.starts_with("GL_")), "{names:?}");
    assert!(names.is_sorted() && names.iter().collect::<BTreeSet<_>>().len() == names.len());
}

#[test]
fn every_command_of_every_advertised_extension_is_there() {
    let registry = registry();
    for (extension, parts) in advertised(&registry) {
        for command in &parts.commands {
            assert!(row(command).is_some(), "{extension} is advertised, {command} is missing");
        }
    }
}

#[test]
fn every_enumerant_has_the_value_of_the_registry() {
    let registry = registry();
    for (value, name) in enums::all() {
        if let Some(registered) = registry.values.get(name) {
            assert_eq!(value, registered, "{name}");
        }
    }
    for (extension, parts) in advertised(&registry) {
        for name in &parts.enums {
            assert_eq!(enums::value(name), registry.values.get(name).copied(), "{extension}: {name}");
        }
    }
}

#[test]
fn an_alias_is_what_the_registry_calls_an_alias() {
    let registry = registry();
    let last = |mut name: &'static str| {
        while let Some(next) = registry.aliases.get(name) {
            name = next;
        }
        name
    };
    for row in rows() {
        for alias in row.aliases.iter().filter(|alias| registry.aliases.contains_key(**alias)) {
            assert_eq!(last(alias), last(row.name), "{alias}");
        }
    }
}

/// A way to hand an enumerant to a command.
type Probe = fn(&mut Context, u32);

/// Every way to hand an enumerant to a command that some extension adds enumerants for.
const PROBES: &[Probe] = &[
    |cx, e| cx.enable(e),
    |cx, e| cx.enable_client_state(e),
    |cx, e| cx.get_doublev(e, &mut [0.0; 64]),
    |cx, e| cx.get_pointerv(e, &mut [0; 1]),
    |cx, e| cx.hint(e, GL_NICEST),
    // PushAttrib refuses no mask.
    |cx, e| if e == GL_MULTISAMPLE_BIT { cx.push_attrib(e) } else { cx.enable(e) },
    |cx, e| cx.pixel_storei(e, 1),
    |cx, e| cx.blend_func(e, GL_ONE),
    |cx, e| cx.blend_equation(e),
    |cx, e| cx.stencil_op(GL_KEEP, GL_KEEP, e),
    |cx, e| cx.point_parameterf(e, 1.0),
    |cx, e| cx.point_parameterfv(e, &[1.0, 0.0, 0.0]),
    |cx, e| cx.fogi(GL_FOG_COORD_SRC, e),
    |cx, e| cx.fogi(e, GL_FRAGMENT_DEPTH),
    |cx, e| cx.fogi(GL_FOG_DISTANCE_MODE_NV, e),
    |cx, e| cx.light_modeli(e, GL_SINGLE_COLOR),
    |cx, e| cx.light_modeli(GL_LIGHT_MODEL_COLOR_CONTROL, e),
    |cx, e| cx.tex_geni(GL_S, GL_TEXTURE_GEN_MODE, e),
    |cx, e| cx.tex_envi(e, GL_TEXTURE_LOD_BIAS, 0),
    |cx, e| cx.tex_envi(e, GL_COORD_REPLACE_ARB, 1),
    |cx, e| cx.tex_envi(GL_TEXTURE_FILTER_CONTROL, e, 0),
    |cx, e| cx.tex_envi(GL_POINT_SPRITE_ARB, e, 1),
    |cx, e| cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, e),
    |cx, e| cx.tex_envi(GL_TEXTURE_ENV, GL_COMBINE_RGB, e),
    |cx, e| cx.tex_envi(GL_TEXTURE_ENV, GL_SRC0_RGB, e),
    |cx, e| cx.tex_envi(GL_TEXTURE_ENV, e, GL_MODULATE),
    |cx, e| cx.tex_envi(GL_TEXTURE_ENV, e, GL_TEXTURE),
    |cx, e| cx.tex_envi(GL_TEXTURE_ENV, e, GL_SRC_ALPHA),
    |cx, e| cx.tex_envi(GL_TEXTURE_ENV, e, 2),
    |cx, e| cx.tex_parameteri(e, GL_TEXTURE_PRIORITY, 1),
    |cx, e| cx.tex_parameteri(GL_TEXTURE_2D, e, 1),
    |cx, e| cx.tex_parameteri(GL_TEXTURE_2D, e, GL_LUMINANCE),
    |cx, e| cx.tex_parameteri(GL_TEXTURE_2D, e, GL_LEQUAL),
    |cx, e| cx.tex_parameteri(GL_TEXTURE_2D, e, GL_REPEAT),
    |cx, e| cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, e),
    |cx, e| cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, e),
    |cx, e| cx.get_tex_parameteriv(GL_TEXTURE_2D, e, &mut [0; 4]),
    |cx, e| cx.get_tex_level_parameteriv(GL_TEXTURE_2D, 0, e, &mut [0; 4]),
    |cx, e| {
        let dxt1 = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
        cx.tex_image_2d(GL_TEXTURE_2D, 0, dxt1, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
        cx.get_tex_level_parameteriv(GL_TEXTURE_2D, 0, e, &mut [0; 4]);
    },
    |cx, e| cx.get_tex_level_parameteriv(e, 0, GL_TEXTURE_WIDTH, &mut [0; 4]),
    |cx, e| cx.tex_image_2d(GL_TEXTURE_2D, 0, e, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL),
    |cx, e| cx.tex_image_2d(GL_TEXTURE_2D, 0, e, 4, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL),
    |cx, e| cx.tex_image_2d(GL_TEXTURE_2D, 0, e, 4, 4, 0, GL_DEPTH_STENCIL_EXT, GL_UNSIGNED_INT_24_8_EXT, NULL),
    |cx, e| cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, e, GL_UNSIGNED_BYTE, NULL),
    |cx, e| cx.read_pixels(0, 0, 1, 1, e, GL_UNSIGNED_INT_24_8_EXT, &mut [0_u8; 4]),
    |cx, e| cx.read_pixels(0, 0, 1, 1, GL_RGBA, e, &mut [0_u8; 4]),
    |cx, e| cx.read_pixels(0, 0, 1, 1, GL_RGB, e, &mut [0_u8; 4]),
    |cx, e| cx.read_pixels(0, 0, 1, 1, GL_DEPTH_STENCIL_EXT, e, &mut [0_u8; 4]),
    |cx, e| cx.bind_buffer(e, 1),
    |cx, e| {
        cx.bind_buffer(GL_ARRAY_BUFFER, 1);
        cx.get_buffer_parameteriv(GL_ARRAY_BUFFER, e, &mut [0]);
    },
    |cx, e| {
        cx.bind_buffer(GL_ARRAY_BUFFER, 1);
        cx.buffer_data(GL_ARRAY_BUFFER, 4, NULL, e);
    },
    |cx, e| {
        cx.bind_buffer(GL_ARRAY_BUFFER, 1);
        cx.buffer_data(GL_ARRAY_BUFFER, 4, NULL, GL_STATIC_DRAW);
        cx.map_buffer(GL_ARRAY_BUFFER, e);
    },
    |cx, e| {
        cx.bind_buffer(GL_ARRAY_BUFFER, 1);
        cx.get_buffer_pointerv(GL_ARRAY_BUFFER, e, &mut [0]);
    },
    |cx, e| cx.begin_query(e, 1),
    |cx, e| cx.color_table(e, GL_RGBA, 4, GL_RGBA, GL_UNSIGNED_BYTE, &[0_u8; 16]),
    |cx, e| cx.histogram(e, 16, GL_RGBA, false),
    |cx, e| cx.convolution_parameteri(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_MODE, e),
    |cx, e| {
        cx.convolution_filter_1d(GL_CONVOLUTION_1D, GL_RGBA, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[0_u8; 4]);
        cx.get_convolution_parameterfv(GL_CONVOLUTION_1D, e, &mut [0.0; 4]);
    },
    |cx, e| {
        cx.convolution_filter_2d(GL_CONVOLUTION_2D, GL_RGBA, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[0_u8; 4]);
        cx.get_convolution_parameterfv(GL_CONVOLUTION_2D, e, &mut [0.0; 4]);
    },
    |cx, e| cx.get_color_table_parameterfv(GL_COLOR_TABLE, e, &mut [0.0; 4]),
    |cx, e| cx.get_histogram_parameterfv(GL_HISTOGRAM, e, &mut [0.0; 4]),
    |cx, e| cx.get_minmax_parameterfv(GL_MINMAX, e, &mut [0.0; 4]),
    |cx, e| cx.get_queryiv(GL_SAMPLES_PASSED, e, &mut [0]),
    |cx, e| {
        cx.begin_query(GL_SAMPLES_PASSED, 1);
        cx.end_query(GL_SAMPLES_PASSED);
        cx.get_query_objectiv(1, e, &mut [0]);
    },
];

/// Whether an enumerant is a texture unit beyond those that there are: GL_ARB_multitexture has names for 32.
fn is_unit_beyond(value: u32) -> bool {
    (GL_TEXTURE0 + MAX_TEXTURE_UNITS as u32..GL_TEXTURE0 + 32).contains(&value)
}

/// Enumerants of advertised extensions that no command takes, with the reason.
const UNUSED: &[(&str, &str)] = &[
    ("GL_TEXTURE_TOO_LARGE_EXT", "an error that images too large had; OpenGL 1.1 has INVALID_VALUE instead"),
    ("GL_TABLE_TOO_LARGE", "an error: that of tables too large"),
    ("GL_WEIGHT_ARRAY_BUFFER_BINDING_ARB", "belongs to ARB_vertex_blend, where that is there as well"),
    ("GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING_ARB", "belongs to vertex programs, where they are there as well"),
];

#[test]
fn every_enumerant_of_every_advertised_extension_is_taken_by_some_command() {
    let registry = registry();
    let names: BTreeSet<_> = advertised(&registry).into_iter().flat_map(|(_, parts)| &parts.enums).collect();
    let mut refused = Vec::new();
    for name in names {
        let value = registry.values[name];
        let taken = PROBES.iter().any(|probe| {
            let mut cx = Context::new(4, 4);
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
            probe(&mut cx, value);
            cx.check().is_ok()
        });
        let unused = UNUSED.iter().any(|row| row.0 == *name) || is_unit_beyond(value);
        if taken == unused {
            refused.push(name);
        }
    }
    assert!(refused.is_empty(), "no command takes {refused:?}");
}
