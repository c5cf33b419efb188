//! OBJ files, whole, half and broken.

use super::material::file_of_map;
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
    // One texture coordinate, three of them, a w, colours: the rest is left out.
    let obj = parse("v 0 0 0 1\nv 1 0 0 1 0 0\nv 1 1 0\nvt 0.5\nvt 0.25 0.75 9\nf 1/1 2/2 3/1").expect("a triangle");
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
        ("", "has no faces"),
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
        ("f", "has no faces"),
        ("\u{0}\u{1}garbage \u{fffd}", "has no faces"),
    ];
    for (text, message) in cases {
        assert_eq!(parse(text).err().as_deref(), Some(message), "{text:?}");
    }
    let missing = Obj::open("no/such/model.obj").expect_err("an error").to_string();
    assert!(missing.starts_with("no/such/model.obj: cannot be read: "), "{missing}");
    let obj = parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\np 1\nf 1 2\nf 1 2 3\n").expect("a triangle");
    assert_eq!(obj.notes, ["1 faces of less than three corners were left out"]);
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
    assert_eq!(obj.notes.len(), 2, "{:?}", obj.notes);
    assert!(obj.notes[0].contains("gone.mtl: cannot be read") && obj.notes[1].contains("bad.mtl"), "{:?}", obj.notes);
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
        assert_eq!(file_of_map(statement), file.map(PathBuf::from), "{statement:?}");
    }
}
