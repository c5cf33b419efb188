//! OBJ files, whole, half and broken.

use super::mtl::file_of_map;
use super::*;
use std::path::PathBuf;

fn parse(text: &str) -> Result<Obj, String> {
    Obj::parse(text.as_bytes(), Path::new(""))
}

/// The corners of all triangles as positions, normals and texture coordinates.
fn corners(obj: &Obj) -> Vec<([f32; 3], [f32; 3], [f32; 2])> {
    let all = obj.groups.iter().flat_map(|g| &g.indices).map(|&i| i as usize);
    all.map(|i| (obj.positions[i], obj.normals[i], obj.tex_coords[i])).collect()
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";

#[test]
fn a_quad_becomes_two_triangles() {
    for face in ["f 1/1/1 2/2/1 3/3/1 4/4/1", "f -4/-4/-1 -3/-3/-1 -2/-2/-1 -1/-1/-1", "f 1/1/1 2/2/1 \\\n 3/3/1 4/4/1"]
    {
        let obj = parse(&format!("{SQUARE}{face}")).expect("a square");
        assert_eq!((obj.triangles(), obj.positions.len(), obj.has_tex_coords), (2, 4, true));
        for (p, n, t) in corners(&obj) {
            assert_eq!((n, t), ([0.0, 0.0, 1.0], [p[0], p[1]]), "{face}");
        }
    }
    let pentagon = parse("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 0\nv -1 1 0\nf 1 2 3 4 5").expect("a pentagon");
    assert_eq!(pentagon.triangles(), 3);
    assert_eq!(pentagon.bounds(), ([-1.0, 0.0, 0.0], [3.0, 2.0, 0.0]));
}

#[test]
fn parts_that_are_missing_are_made() {
    // One corner without texture coordinates, one without a normal: (0, 0) for it, and all normals computed.
    let obj = parse(&format!("{SQUARE}f 1/1/1 2//1 3/3\nf 1 3/3 4/4/1")).expect("a square");
    assert!(obj.has_tex_coords);
    let all = corners(&obj);
    assert!(all.iter().all(|c| c.1 == [0.0, 0.0, 1.0]));
    assert_eq!(all.iter().map(|c| c.2).collect::<Vec<_>>()[..3], [[0.0, 0.0], [0.0, 0.0], [1.0, 1.0]]);
    assert_eq!(all[5].2, [0.0, 1.0]);
    // Normals for every corner, no texture coordinates at all.
    let obj = parse(&format!("{SQUARE}f 1//1 2//1 3//1")).expect("a triangle");
    assert!(!obj.has_tex_coords && obj.tex_coords == [[0.0; 2]; 3]);
    // One texture coordinate, three of them, a w: the rest is left out.
    let obj = parse("v 0 0 0 1\nv 1 0 0 2\nv 1 1 0\nvt 0.5\nvt 0.25 0.75 9\nf 1/1 2/2 3/1").expect("a triangle");
    assert_eq!(obj.tex_coords, [[0.5, 0.0], [0.25, 0.75], [0.5, 0.0]]);
}

#[test]
fn computed_normals_are_smooth_on_curves_and_sharp_on_edges() {
    let cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
                f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let obj = parse(cube).expect("a cube");
    assert_eq!((obj.triangles(), obj.positions.len()), (12, 24));
    for triangle in corners(&obj).chunks(3) {
        let n = triangle[0].1;
        assert!(triangle.iter().all(|c| c.1 == n));
        // The normal is an axis, and points away from the middle.
        assert_eq!(n.iter().map(|c| c.abs()).sum::<f32>(), 1.0);
        let outward: f32 = triangle[0].0.iter().zip(n).map(|(p, n)| (p - 0.5) * n).sum();
        assert_eq!(outward, 0.5);
    }
    // A tube of 24 sides: normals lie between the facets and point away from the axis.
    let mut tube = String::new();
    for i in 0..24 {
        let (s, c) = (f64::from(i) * 15.0).to_radians().sin_cos();
        tube += &format!("v {c} {s} 0\nv {c} {s} 1\n");
    }
    for i in 0..24 {
        let (a, b) = (i * 2 + 1, (i * 2 + 2) % 48 + 1);
        tube += &format!("f {a} {b} {} {}\n", b + 1, a + 1);
    }
    let obj = parse(&tube).expect("a tube");
    assert_eq!(obj.positions.len(), 48, "no vertex was split");
    for (p, n, _) in corners(&obj) {
        assert!((p[0] * n[0] + p[1] * n[1] - 1.0).abs() < 0.01 && n[2].abs() < 1e-6, "{p:?} {n:?}");
    }
}

#[test]
fn degenerate_faces_get_some_normal() {
    let obj = parse("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 1\n").expect("no area");
    assert!(obj.normals.iter().all(|n| *n == [0.0, 0.0, 1.0]));
    // A fan of many faces at one point is done in one go.
    let mut fan = String::from("v 0 0 0\n");
    for i in 0..5000 {
        fan += &format!("v {} {} 1\n", i % 100, i / 100);
    }
    for i in 2..5000 {
        fan += &format!("f 1 {i} {}\n", i + 1);
    }
    assert_eq!(parse(&fan).expect("a fan").triangles(), 4998);
}

#[test]
fn broken_files_say_in_which_line() {
    let cases = [
        ("", "is empty"),
        ("# nothing\n", "is not an OBJ file: no line of it is one"),
        ("v 1 2 3\n", "has no faces"),
        ("v 1 2\n", "line 1: 3 numbers are needed, there are 2"),
        ("v 0 0 0\nv 1 x 0\n", "line 2: `x` is not a number"),
        ("v 0 nan 0\n", "line 1: `nan` is not a finite number"),
        ("v 0 0 0\nv 1 0 0\nf 1 2 3\n", "line 3: a face refers to vertex 3, but there are 2"),
        ("v 0 0 0\nf -1 -2 -1\n", "line 2: a face refers to vertex -2, but there are 1 before it"),
        ("v 0 0 0\nf 0 1 1\n", "line 2: `0` has the index 0; OBJ counts from 1"),
        ("v 0 0 0\nf 1/5 1/5 1/5\n", "line 2: a face refers to texture coordinate 5, but there are 0"),
        ("v 0 0 0\nf 1//9 1//9 1//9\n", "line 2: a face refers to normal 9, but there are 0"),
        ("v 0 0 0\nf 1/1/1/1 1 1\n", "line 2: `1/1/1/1` is not a corner of a face"),
        ("v 0 0 0\nf 99999999999999999999 1 1\n", "line 2: `99999999999999999999` is not a corner of a face"),
        (
            "v 0 0 0\nf 9223372036854775807 1 1\n",
            "line 2: a face refers to vertex 9223372036854775807, but there are 1",
        ),
        (
            "v 0 0 0\nf -9223372036854775808 1 1\n",
            "line 2: a face refers to vertex -9223372036854775808, but there are 1 before it",
        ),
        ("f", "line 1: a face of 0 corners"),
        ("\u{0}\u{1}garbage \u{fffd}", "is not an OBJ file: no line of it is one"),
    ];
    for (text, message) in cases {
        assert_eq!(parse(text).err().as_deref(), Some(message), "{text:?}");
    }
    let missing = Obj::open("no/such/model.obj").expect_err("an error").to_string();
    assert!(missing.starts_with("no/such/model.obj: cannot be read: "), "{missing}");
    let obj = parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\np 1\nf 1 2\nf 1 2 3\n").expect("a triangle");
    assert_eq!(
        obj.notes,
        [
            "line 4: `l`; points and lines are left out (and 1 more like it)",
            "line 6: a face of 2 corners; faces of less than three corners are left out",
        ]
    );
}

#[test]
fn materials_come_from_their_files() {
    let folder = std::env::temp_dir().join(format!("fixedgl-obj-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("sub")).expect("a folder");
    let mtl = "newmtl red\nKd 1 0 0\nNs 500\nd 0.5\nnewmtl brick\nmap_Kd -s 2 2 1 -clamp on tex\\brick wall.png\n";
    std::fs::write(folder.join("sub/a.mtl"), mtl).expect("written");
    std::fs::write(folder.join("bad.mtl"), "newmtl x\nKd one\n").expect("written");
    let text = format!(
        "mtllib sub/a.mtl gone.mtl bad.mtl\n{SQUARE}g front\nusemtl red\nf 1 2 3\ng more\nf 1 2 4\nusemtl brick\nf 1 3 4\nusemtl none\nf 2 3 4\n"
    );
    std::fs::write(folder.join("m.obj"), text).expect("written");
    let obj = Obj::open(folder.join("m.obj")).expect("a model");
    std::fs::remove_dir_all(&folder).expect("removed");
    let names = |g: &Group| g.material.map(|m| obj.materials[m].name.clone());
    let groups: Vec<_> = obj.groups.iter().map(|g| (names(g), g.indices.len())).collect();
    assert_eq!(groups, [(Some("red".into()), 6), (Some("brick".into()), 3), (None, 3)]);
    assert_eq!(obj.groups[0].name, "front");
    let red = &obj.materials[0];
    assert_eq!((red.diffuse, red.shininess, red.ambient), ([1.0, 0.0, 0.0, 0.5], 128.0, [0.2, 0.2, 0.2, 0.5]));
    assert_eq!(obj.materials[1].texture, Some(folder.join("sub/tex/brick wall.png")));
    let ends = ["gone.mtl: cannot be read", "bad.mtl: line 2: Kd", "the material `none` is not in any file"];
    assert!(ends.iter().all(|end| obj.notes.iter().any(|note| note.contains(end))), "{:?}", obj.notes);
}

#[test]
fn options_of_a_map_are_skipped() {
    for (statement, file) in [
        ("a.png", Some("a.png")),
        ("-o 1 2 3 -mm 0 1 b c.png", Some("b c.png")),
        ("-s 2 a.png", Some("a.png")),
        ("-clamp on -blendu off d/a.png", Some("d/a.png")),
        ("-s", None),
        ("", None),
    ] {
        assert_eq!(file_of_map(statement), file.map(String::from), "{statement:?}");
    }
}

/// A folder with files, and the model `m.obj` in it.
fn folder_with(name: &str, files: &[(&str, &[u8])]) -> (PathBuf, Result<Obj, FileError>) {
    let folder = std::env::temp_dir().join(format!("fixedgl-obj-{name}-{}", std::process::id()));
    for (file, content) in files {
        let path = folder.join(file);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        std::fs::write(path, content).expect("written");
    }
    let obj = Obj::open(folder.join("m.obj"));
    std::fs::remove_dir_all(&folder).expect("removed");
    (folder, obj)
}

/// A square of one material, which is looked for in this MTL text: the material, and the notes.
fn material(name: &str, mtl: &str) -> (Material, Vec<String>) {
    let text = format!("mtllib m.mtl\n{SQUARE}usemtl x\nf 1 2 3 4\n");
    let (_, obj) = folder_with(name, &[("m.obj", text.as_bytes()), ("m.mtl", mtl.as_bytes())]);
    let obj = obj.expect("a model");
    let used = obj.groups[0].material.map(|m| obj.materials[m].clone());
    (used.expect("a material"), obj.notes)
}

#[test]
fn one_bad_line_of_a_material_costs_that_line() {
    let plain = Material { name: "x".into(), ..Material::default() };
    let diffuse = |[r, g, b]: [f32; 3]| Material { diffuse: [r, g, b, 1.0], ..plain.clone() };
    let opacity = |a: f32| {
        let [ambient, diffuse, specular, emission] =
            [plain.ambient, plain.diffuse, plain.specular, plain.emission].map(|[r, g, b, _]| [r, g, b, a]);
        Material { ambient, diffuse, specular, emission, ..plain.clone() }
    };
    // What the lines give, and what the note says after the name of the file.
    let cases: [(&str, Material, &[&str]); 22] = [
        ("Kd .5", diffuse([0.5; 3]), &["line 3: Kd has one number; it is taken as red, green and blue"]),
        ("Kd .5 1", plain.clone(), &["line 3: Kd: 3 numbers are needed, there are 2; the line is left out"]),
        ("Kd", plain.clone(), &["line 3: Kd: 3 numbers are needed, there are 0; the line is left out"]),
        ("Kd 1 nan 0", plain.clone(), &["line 3: Kd: `nan` is not a finite number; the line is left out"]),
        (
            "Kd spectral x",
            plain.clone(),
            &["line 3: Kd: spectral curves and CIE XYZ are not read; the line is left out"],
        ),
        ("Kd 0,5 0,25 1", diffuse([0.5, 0.25, 1.0]), &[]),
        ("kd 1 0 0 # red", diffuse([1.0, 0.0, 0.0]), &[]),
        ("Kd 2 -1 0", diffuse([1.0, 0.0, 0.0]), &[]),
        ("Ke 0.5 0 0", Material { emission: [0.5, 0.0, 0.0, 1.0], ..plain.clone() }, &[]),
        ("map_Kd ", plain.clone(), &["line 3: map_Kd: no file is named; the line is left out"]),
        ("map_Kd -s 1 1 1", plain.clone(), &["line 3: map_Kd: no file is named; the line is left out"]),
        ("map_bump ", plain.clone(), &[]),
        ("illum 2.0", plain.clone(), &[]),
        ("illum", plain.clone(), &[]),
        ("Ns", plain.clone(), &["line 3: Ns: 1 numbers are needed, there are 0; the line is left out"]),
        ("d -halo 0.5", opacity(0.5), &["line 3: `d -halo`; it is taken as a `d` without a halo"]),
        ("d -halo", plain.clone(), &["line 3: d: 1 numbers are needed, there are 0; the line is left out"]),
        ("Tr 0.25", opacity(0.75), &[]),
        ("Tr 1\nd 0.5", opacity(0.5), &[]),
        ("Tr 1", opacity(0.0), &["line 3: `Tr 1` without a `d`; nothing of the material can be seen"]),
        (
            "map_d a.png",
            plain.clone(),
            &["line 3: `map_d`; opacity from an image is not read: use the alpha of `map_Kd`"],
        ),
        (
            "Ks 1 1 1",
            Material { specular: [1.0; 4], ..plain.clone() },
            &["`x` has a Ks but no Ns above 0; its highlight covers all that is lit"],
        ),
    ];
    for (line, expected, notes) in cases {
        // The materials before and after it are whole.
        let (read, said) = material("lines", &format!("\nnewmtl x\n{line}\nnewmtl y\nKd 1 0 0\n"));
        assert_eq!(read, expected, "{line}");
        let said: Vec<_> = said.iter().filter_map(|note| note.split_once("m.mtl: ")).map(|(_, note)| note).collect();
        assert_eq!(said, notes, "{line}");
    }
}

#[test]
fn names_of_materials_are_found_as_they_are_written() {
    for (mtl, named) in [
        ("newmtl Material #25", "Material #25"),
        ("newmtl red # the red one", "red"),
        ("newmtl red", "red # the red one"),
        ("newmtl a b", "a b"),
        ("\u{feff}newmtl red", "red"),
        ("NEWMTL red", "red"),
    ] {
        // `usemtl` may come before `mtllib`.
        let text = format!("\u{feff}usemtl {named}\nmtllib m.mtl\n{SQUARE}f 1 2 3 4\n");
        let mtl = format!("{mtl}\nKd 1 0 0\nnewmtl other\n");
        for end in ["\n", "\r\n", "\r"] {
            let [text, mtl] = [&text, &mtl].map(|text| text.replace('\n', end));
            let (_, obj) = folder_with("names", &[("m.obj", text.as_bytes()), ("m.mtl", mtl.as_bytes())]);
            let obj = obj.expect("a model");
            assert_eq!(
                (obj.groups.len(), obj.groups[0].material, obj.notes.len()),
                (1, Some(0), 0),
                "{mtl:?} {:?}",
                obj.notes
            );
            assert_eq!((obj.materials[0].diffuse, obj.positions.len()), ([1.0, 0.0, 0.0, 1.0], 4));
        }
    }
}

#[test]
fn files_are_found_though_they_are_named_otherwise() {
    for (library, map) in [
        ("lib/my mats.mtl", "brick wall.png"),
        ("LIB\\My Mats.MTL", "Brick Wall.PNG"),
        ("C:\\models\\my mats.mtl", "C:\\textures\\brick wall.png"),
        ("\"lib/my mats.mtl\" ", "..\\lib\\brick wall.png"),
    ] {
        let text = format!("mtllib {library}\n{SQUARE}usemtl x\nf 1 2 3 4\n");
        let mtl = format!("newmtl x\nmap_Kd {map}\n");
        let place = if library.starts_with('C') { "my mats.mtl" } else { "lib/my mats.mtl" };
        let picture = if library.starts_with('C') { "brick wall.png" } else { "lib/brick wall.png" };
        let files = [("m.obj", text.as_bytes()), (place, mtl.as_bytes()), (picture, &b""[..])];
        let (folder, obj) = folder_with("found", &files);
        let obj = obj.expect("a model");
        let texture = obj.materials.first().and_then(|m| m.texture.clone()).expect(library);
        assert!(texture.starts_with(&folder) && texture.ends_with("brick wall.png"), "{texture:?}");
        assert!(obj.notes.is_empty(), "{:?}", obj.notes);
    }
    // What has no end is not read.
    let (_, obj) = folder_with("device", &[("m.obj", format!("mtllib /dev/zero\n{SQUARE}f 1 2 3").as_bytes())]);
    assert!(obj.expect("a model").notes[0].contains("/dev/zero: cannot be read"));
}

#[test]
fn what_can_be_read_is_read_and_the_rest_is_noted() {
    // Lines beside a square, how many triangles are left, and the notes.
    let cases: [(&str, usize, &[&str]); 13] = [
        ("v 1 x 0\nf 1 2 5", 2, &["line 11: `x` is not a number; faces with this vertex are left out"]),
        ("v 1,5 0,5 0\nf 1 2 5", 3, &[]),
        (
            "f 1 2 9\nf 1 2 0\nf 1 2 3",
            3,
            &["line 12: `0` has the index 0; OBJ counts from 1; the face is left out (and 1 more like it)"],
        ),
        ("f 1/9 2 3", 2, &["line 11: a face refers to texture coordinate 9, but there are 4; the face is left out"]),
        ("vt x\nf 1/5 2/5 3/5", 3, &["line 11: `x` is not a number; the texture coordinate is (0, 0)"]),
        (
            "vn -1.#IND00 0 0\nf 1//2 2//2 3//2",
            3,
            &["line 11: `-1.#IND00` is not a finite number; the normal is computed instead"],
        ),
        ("vn 0 0 0\nf 1//2 2//2 3//2", 3, &[]),
        ("fo 1 2 3", 3, &[]),
        ("F 1 2 3", 3, &[]),
        (
            "usemtl gone\nf 1 2 3",
            3,
            &["line 12: the material `gone` is not in any file; the faces from here on have none"],
        ),
        ("s big\nf 1 2 3", 3, &["line 11: `s big`; a smoothing group is a number or `off`"]),
        ("surf 0 1 0 1 1 2", 2, &["line 11: `surf`; curves and surfaces are left out"]),
        ("bogus 1", 2, &["line 11: `bogus` is no statement of an OBJ file; the line is left out"]),
    ];
    for (lines, triangles, notes) in cases {
        let obj = parse(&format!("{SQUARE}f 1/1/1 2/2/1 3/3/1 4/4/1\n{lines}\n")).expect(lines);
        assert_eq!(obj.triangles(), triangles, "{lines}");
        assert_eq!(obj.notes, notes, "{lines}");
        assert!(corners(&obj).iter().all(|c| c.1 == [0.0, 0.0, 1.0]), "{lines}");
    }
    for (start, kind) in
        [("\u{89}PNG", "is not an OBJ file: no line of it is one"), ("GIF89a", "is not an OBJ file, but a GIF image")]
    {
        assert_eq!(parse(start).err().as_deref(), Some(kind));
    }
}

#[test]
fn colours_of_vertices_are_read() {
    let colours = |text: &str| {
        let obj = parse(&format!("{text}\nf 1 2 3\n")).expect("a triangle");
        (obj.has_colors, obj.colors)
    };
    let red_first = vec![[1.0, 0.0, 0.0], [1.0; 3], [0.0, 0.0, 1.0]];
    assert_eq!(colours("v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0 0 0 1"), (true, red_first.clone()));
    assert_eq!(colours("v 0 0 0 255 0 0\nv 1 0 0 255 255 255\nv 1 1 0 0 0 255"), (true, red_first.clone()));
    assert_eq!(colours("v 0 0 0 1 0 0\nv 1 0 0 x 0 0\nv 1 1 0 0 0 1"), (true, red_first));
    assert_eq!(colours("v 0 0 0\nv 1 0 0 1\nv 1 1 0"), (false, vec![[1.0; 3]; 3]));
    // They reach GL.
    let obj = parse("v -1 -1 0 0 1 0\nv 1 -1 0 0 1 0\nv 1 1 0 0 1 0\nv -1 1 0 0 1 0\nf 1 2 3 4").expect("a square");
    let mut cx = Context::new(2, 2);
    obj.draw(&mut cx);
    assert_eq!(cx.pixels()[..4], [0, 255, 0, 255]);
    cx.check().expect("no error");
}

#[test]
fn a_model_far_from_the_origin_keeps_its_shape() {
    // A square of 0.3 m where surveyors measure; and the same with a vertex at the origin that no face has.
    for extra in ["", "v 0 0 0\n"] {
        let at =
            [(500_000.1, 5_400_000.1), (500_000.4, 5_400_000.1), (500_000.4, 5_400_000.4), (500_000.1, 5_400_000.4)];
        let text: String = at.iter().map(|(x, y)| format!("v {x} {y} 100\n")).collect();
        let obj = parse(&format!("{text}{extra}f 1 2 3 4")).expect("a square");
        assert_eq!(obj.positions.len(), 4);
        for (p, (x, y)) in obj.positions.iter().zip(at) {
            let back: [f64; 3] = std::array::from_fn(|i| f64::from(p[i]) + obj.offset[i]);
            for (got, want) in back.into_iter().zip([x, y, 100.0]) {
                assert!((got - want).abs() < 1e-7, "{got} for {want}");
            }
        }
    }
    // Models that are about as far away as they are large stay as the file has them.
    let obj = parse("v 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3").expect("a triangle");
    assert_eq!((obj.offset, obj.positions[1]), ([0.0; 3], [6.0, 0.0, 0.0]));
}

/// How many triangles cover a point of the xy plane, looking along z.
fn covered(obj: &Obj, [x, y]: [f32; 2]) -> usize {
    let side = |a: [f32; 3], b: [f32; 3]| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    let all = corners(obj);
    all.chunks(3).filter(|t| (0..3).all(|i| side(t[i].0, t[(i + 1) % 3].0) > 0.0)).count()
}

#[test]
fn the_notch_of_a_concave_face_stays_open() {
    let arrow = ["0 0", "2 1", "0 2", "1 1"];
    // From every first corner, in every plane that keeps x and y, the face is wound as the file has it.
    for first in 0..4 {
        for plane in ["0", "slope"] {
            let vertex = |at: &str| {
                let (x, y) = at.split_once(' ').expect("two numbers");
                format!("v {x} {y} {}\n", if plane == "0" { "0" } else { x })
            };
            let text: String = (0..4).map(|i| vertex(arrow[(first + i) % 4])).collect();
            let obj = parse(&format!("{text}f 1 2 3 4")).expect("an arrow");
            assert_eq!(obj.triangles(), 2);
            assert_eq!([[1.5, 1.01], [0.6, 0.55], [0.5, 1.6]].map(|p| covered(&obj, p)), [1; 3], "{first}");
            assert_eq!(covered(&obj, [0.5, 1.01]), 0, "the notch, first corner {first}");
        }
    }
    // A comb of many teeth: every tooth is there, every gap is open. The parts of corners go with them.
    let mut comb = String::from("v 0 -1 0\nv 40 -1 0\nvt 0 -1\nvt 40 -1\n");
    let mut face = String::from("f 1/1 2/2");
    for i in (0..40).rev() {
        let y = if i % 2 == 0 { 1 } else { 0 };
        for x in [i + 1, i] {
            comb += &format!("v {x} {y} 0\nvt {x} {y}\n");
        }
        face += &format!(" {0}/{0} {1}/{1}", (39 - i) * 2 + 3, (39 - i) * 2 + 4);
    }
    let obj = parse(&format!("{comb}{face}")).expect("a comb");
    for i in 0..40 {
        let x = i as f32 + 0.5;
        assert_eq!(covered(&obj, [x, 0.51]), usize::from(i % 2 == 0), "tooth {i}");
        assert_eq!(covered(&obj, [x, -0.49]), 1);
    }
    assert!(corners(&obj).iter().all(|(p, _, t)| [p[0], p[1]] == *t));
}

#[test]
fn smoothing_groups_say_where_normals_are_shared() {
    // Two faces at a right angle along the y axis.
    let edge = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\n";
    let [left, right] = ["f 1 3 2\n", "f 1 2 4\n"];
    let diagonal = std::f32::consts::FRAC_1_SQRT_2;
    for (text, smooth) in [
        (format!("{left}{right}"), false),
        (format!("s 1\n{left}{right}"), true),
        (format!("s 1\n{left}s 2\n{right}"), false),
        (format!("s 1\n{left}s off\n{right}"), false),
        (format!("s 1\n{left}s 0\n{right}"), false),
    ] {
        let obj = parse(&format!("{edge}{text}")).expect("two faces");
        let first = corners(&obj)[0].1;
        let expected = if smooth { [diagonal, 0.0, diagonal] } else { [0.0, 0.0, 1.0] };
        assert!((0..3).all(|i| (first[i] - expected[i]).abs() < 1e-6), "{text}: {first:?}");
    }
    // `s off` keeps the facets of a tube that would be smooth by its angles.
    let (s, c) = (10.0f64.to_radians().sin(), 10.0f64.to_radians().cos());
    let ridge = format!("v 0 0 0\nv 0 1 0\nv {c} 0 {s}\nv -{c} 0 {s}\n");
    for (smoothing, smooth) in [("", true), ("s off\n", false)] {
        let obj = parse(&format!("{ridge}{smoothing}{left}{right}")).expect("two faces");
        assert_eq!(corners(&obj)[0].1[0].abs() < 1e-6, smooth);
    }
}

#[test]
fn normals_that_the_file_has_are_kept_beside_computed_ones() {
    let obj = parse(&format!("{SQUARE}vn 1 0 0\nf 1//2 2//2 3//2\nf 1 3 4\n")).expect("two faces");
    let normals: Vec<_> = corners(&obj).iter().map(|c| c.1).collect();
    assert_eq!(
        normals,
        [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]]
    );
}

#[test]
fn faces_that_share_a_corner_are_done_in_time_by_their_number() {
    // A disc, and on its middle a needle whose sides stand upright: the disc's normal is not bent by them.
    let sides = 100_000;
    let mut text = String::from("v 0 0 0\n");
    for i in 0..sides {
        let (s, c) = (f64::from(i) / f64::from(sides) * std::f64::consts::TAU).sin_cos();
        text += &format!("v {c} {s} 0\nv {} {} 1\n", c * 1e-3, s * 1e-3);
    }
    for i in 0..sides {
        let next = (i + 1) % sides;
        text += &format!("f 1 {} {}\nf 1 {} {}\n", i * 2 + 2, next * 2 + 2, i * 2 + 3, next * 2 + 3);
    }
    let start = std::time::Instant::now();
    let obj = parse(&text).expect("a disc");
    // Looking at every pair of faces would take minutes.
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
    for triangle in corners(&obj).chunks(3).filter(|t| t.iter().all(|c| c.0[2] == 0.0)) {
        assert_eq!(triangle[0].1, [0.0, 0.0, 1.0]);
    }
}
