//! glHint, hint by hint: what FASTEST or NICEST could do is tried, through GL's own words where they can say it, and
//! compared with what is done. A knob that buys no time for its error (or no error for its time) is dropped: the hint is
//! accepted and can be asked for, and changes no byte, which is checked here too. TEXTURE_COMPRESSION_HINT is kept.

use super::clock::{self, Ready};
use super::gl::{Gl, Library, Ours};
use super::knobs::{Knobs, settings};
use super::metrics::Error;
use super::oracle::clip::clip_triangle;
use super::oracle::matrix::M4;
use super::oracle::scene::Scene;
use super::oracle::texel::Image;
use super::oracle::vertex::Vertex;
use super::patterns::{self, Kernel};
use super::scenes::{Depth, Subject};
use super::translate::{self, as_given};
use super::truth;
use fixedgl::enums::*;
use std::time::{Duration, Instant};

/// One thing that was tried.
pub struct Trial {
    pub name: String,
    pub time: f64,
    pub time_unit: &'static str,
    pub error: f64,
    pub error_unit: &'static str,
}

/// What became of a hint.
pub struct Verdict {
    pub hint: &'static str,
    /// Whether its modes differ in a byte, and whether what was tried would be worth its keep.
    pub effect: bool,
    pub worth: bool,
    pub text: String,
    pub trials: Vec<Trial>,
}

impl Verdict {
    /// The verdict in a word or two.
    pub fn words(&self) -> &'static str {
        match (self.effect, self.worth) {
            (true, true) => "has an effect",
            (true, false) => "has an effect that is not worth it",
            (false, true) => "would be worth it, is not built in",
            (false, false) => "dropped",
        }
    }
}

/// What a knob has to save of the time, or of the error, to be worth its keep.
const WORTH: f64 = 0.10;

/// All hints that are tried.
pub fn verdicts(ours: &Ours, subjects: &[Subject], samples: u32, seconds: f64) -> Vec<Verdict> {
    let find = |name: &str| subjects.iter().find(|s| s.name == name).map(|s| &s.scene);
    let mut verdicts = Vec::new();
    if let Some(plane) = find("plane") {
        verdicts.push(perspective(ours, plane, samples, seconds));
        verdicts.push(kernels(ours, plane, samples, seconds));
        verdicts.push(fog(ours, plane, seconds));
    }
    verdicts.push(compression(ours));
    verdicts
}

/// Whether a picture is the same to the byte whatever the hint says.
fn same_bytes(ours: &Ours, scene: &Scene, hint: u32) -> bool {
    let picture = |mode: u32| {
        let mut gl = ours.open([scene.width, scene.height], false);
        gl.hint(hint, mode);
        translate::state(gl.as_mut(), scene);
        translate::picture(gl.as_mut());
        gl.bytes()
    };
    let pictures = [GL_FASTEST, GL_DONT_CARE, GL_NICEST].map(picture);
    pictures[0] == pictures[1] && pictures[1] == pictures[2]
}

fn stored(same: bool) -> &'static str {
    if same { "FASTEST, DONT_CARE and NICEST give the same bytes." } else { "The modes do not give the same bytes." }
}

/// ns a fragment and the picture of each scene, in turns.
fn timed(ours: &Ours, scenes: &[(&Scene, &Knobs)], seconds: f64) -> Vec<(f64, Vec<[u8; 4]>)> {
    let mut ready: Vec<Ready> = scenes.iter().map(|(s, k)| Ready::new(ours, s, k)).collect();
    let pictures: Vec<_> = ready.iter_mut().map(Ready::picture).collect();
    let costs = clock::measure(&mut ready, Duration::from_secs_f64(seconds));
    let fragments = truth::spec(scenes[0].0, scenes[0].1).hits.iter().sum::<u32>();
    costs.iter().zip(pictures).map(|(c, p)| (c * 1e9 / f64::from(fragments.max(1)), p)).collect()
}

/// The scene as a program without perspective would draw it: triangles clipped and projected, texture coordinates linear
/// in the window.
fn affine(scene: &Scene) -> Scene {
    let mut flat = scene.clone();
    flat.triangles.clear();
    let (w, h) = (f64::from(scene.width), f64::from(scene.height));
    flat.vertex.modelview = M4::IDENTITY;
    flat.vertex.projection = M4::ortho(0.0, w, 0.0, h, 0.0, -1.0);
    for triangle in &scene.triangles {
        let shaded = [0, 1, 2].map(|i| scene.vertex.run(&triangle[i]));
        let polygon = clip_triangle(shaded.each_ref().map(|s| s.clip), shaded.each_ref().map(|s| s.eye), &[], false);
        let corners: Vec<Vertex> = polygon
            .iter()
            .map(|c| {
                let at = scene.viewport.window(c.clip);
                let tex = |k: usize| (0..3).map(|i| c.weights[i] * shaded[i].tex[0][k]).sum::<f64>();
                Vertex::at(at.x, at.y, at.z).st(tex(0), tex(1))
            })
            .collect();
        for i in 1..corners.len().max(1) - 1 {
            flat.triangles.push([corners[0].clone(), corners[i].clone(), corners[i + 1].clone()]);
        }
    }
    as_given(flat)
}

/// A wall that faces the eye, or is turned so little that the same texels are read but the division is not left out.
fn wall(turned: bool) -> Scene {
    let mut scene = Scene::new(192, 192);
    scene.units[0].texture = Some(patterns::texture(&patterns::checks(256)));
    scene.units[0].env.mode = GL_REPLACE;
    scene.vertex.projection = M4::perspective(60.0, 1.0, 0.5, 10.0);
    let turn = M4::rotation(if turned { 0.02 } else { 0.0 }, [1.0, 1.0, 0.0]);
    scene.vertex.modelview = M4::translation(0.0, 0.0, -2.0).times(turn);
    let v = |x: f64, y: f64| Vertex::at(x, y, 0.0).st(1.2 * x, 1.2 * y);
    scene.quad([v(-1.1, -1.1), v(1.1, -1.1), v(1.1, 1.1), v(-1.1, 1.1)]);
    as_given(scene)
}

fn perspective(ours: &Ours, plane: &Scene, samples: u32, seconds: f64) -> Verdict {
    let all = settings(Depth::Short, true);
    let (facing, turned) = (wall(false), wall(true));
    let walls = [(&turned, &all[0]), (&facing, &all[0]), (&turned, &all[1]), (&facing, &all[1])];
    let times = timed(ours, &walls, seconds);
    let flat = affine(plane);
    let ideal = truth::filtered(ours, plane, samples / 2).square;
    let hits = truth::spec(plane, &all[0]).hits;
    let error = |scene: &Scene, knobs: &Knobs| {
        let picture = Ready::new(ours, scene, knobs).picture();
        Error::of(&picture, &ideal, |p| hits[p] > 0).rmse
    };
    let trial = |i: usize, name: &str, scene: &Scene, knobs: &Knobs| Trial {
        name: name.to_string(),
        time: times[i].0,
        time_unit: "ns a fragment",
        error: error(scene, knobs),
        error_unit: "LSB rms from the ideal",
    };
    let trials = vec![
        trial(0, "trilinear, divided at every pixel", plane, &all[0]),
        trial(1, "trilinear, affine", &flat, &all[0]),
        trial(2, "LINEAR, divided at every pixel", plane, &all[1]),
        trial(3, "LINEAR, affine", &flat, &all[1]),
    ];
    let saved = 1.0 - trials[1].time / trials[0].time;
    let same = same_bytes(ours, plane, GL_PERSPECTIVE_CORRECTION_HINT);
    // Worth it only if affine texels under the better filter beat true texels under the cheaper one.
    let worth = saved > WORTH && (trials[1].error < trials[2].error || trials[1].time < trials[2].time);
    let text = format!(
        "FASTEST could leave out the division at every pixel: affine texture coordinates. The time is that of a wall whose corners all have the same \
         w, where the division is left out, against the same wall turned by 0.02 degrees; the error is that of the rolled plane with its corners \
         projected by hand. A trilinear fragment takes {:.2} ns instead of {:.2} ({:+.0} %), and the error rises from {:.1} to {:.1} LSB; LINEAR with \
         its division takes {:.2} ns at {:.1} LSB. {}",
        trials[1].time,
        trials[0].time,
        -100.0 * saved,
        trials[0].error,
        trials[1].error,
        trials[2].time,
        trials[2].error,
        stored(same)
    );
    Verdict { hint: "GL_PERSPECTIVE_CORRECTION_HINT", effect: !same, worth, text, trials }
}

fn kernels(ours: &Ours, plane: &Scene, samples: u32, seconds: f64) -> Verdict {
    let all = settings(Depth::Short, true);
    let lanczos = |k: &Knobs| Knobs { kernel: Kernel::Lanczos, ..k.clone() };
    let (tri, aniso) = (lanczos(&all[0]), lanczos(&all[2]));
    let pairs = [(plane, &all[0]), (plane, &tri), (plane, &all[2]), (plane, &aniso)];
    let found = timed(ours, &pairs, seconds);
    let ideal = truth::filtered(ours, plane, samples / 2).square;
    let hits = truth::spec(plane, &all[0]).hits;
    let names = ["trilinear, box", "trilinear, Lanczos", "anisotropic 8, box", "anisotropic 8, Lanczos"];
    let mut trials: Vec<Trial> = found
        .iter()
        .zip(names)
        .map(|((ns, picture), name)| Trial {
            name: name.to_string(),
            time: *ns,
            time_unit: "ns a fragment",
            error: Error::of(picture, &ideal, |p| hits[p] > 0).rmse,
            error_unit: "LSB rms from the ideal",
        })
        .collect();
    let change = |a: &Trial, b: &Trial| 100.0 * (b.error / a.error - 1.0);
    let (of_tri, of_aniso) = (change(&trials[0], &trials[1]), change(&trials[2], &trials[3]));
    let built = generated(ours);
    trials.push(Trial {
        name: "512 x 512 levels by GENERATE_MIPMAP".into(),
        time: built,
        time_unit: "ms",
        error: 0.0,
        error_unit: "",
    });
    let worth = of_tri < -100.0 * WORTH && of_aniso <= 0.0;
    let same = same_levels(ours);
    let text = format!(
        "NICEST could make levels with a better kernel than the box: Lanczos of three lobes, tried by uploading levels made by hand. On the rolled \
         plane it changes the error of trilinear by {of_tri:+.1} % and that of 8 times anisotropic by {of_aniso:+.1} %, at the same time a fragment \
         and 12 texels a side instead of 2 for every texel of a level (the box builds 512 x 512 in {built:.2} ms). A program that wants it uploads \
         its own levels. {}",
        stored(same)
    );
    Verdict { hint: "GL_GENERATE_MIPMAP_HINT", effect: !same, worth, text, trials }
}

fn bytes_of(image: &Image) -> Vec<u8> {
    image.texels.iter().flat_map(|c| c.map(super::oracle::fragment::to_byte)).collect()
}

/// Milliseconds to upload 512 x 512 texels with their levels, beyond uploading them without. The levels are owed until
/// somebody looks: the last one is read.
fn generated(ours: &Ours) -> f64 {
    let texels = bytes_of(&patterns::checks(512));
    let mut last = [0u8; 4];
    let mut times = [f64::MAX; 2];
    let mut cx = ours.context([16, 16], false);
    for _ in 0..12 {
        for (on, time) in times.iter_mut().enumerate() {
            cx.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, on as i32);
            let start = Instant::now();
            Gl::tex_image_2d(&mut cx, 0, GL_RGBA8 as i32, [512, 512], &texels);
            if on == 1 {
                cx.get_tex_image(GL_TEXTURE_2D, 9, GL_RGBA, GL_UNSIGNED_BYTE, &mut last);
            }
            *time = time.min(start.elapsed().as_secs_f64() * 1e3);
        }
    }
    times[1] - times[0]
}

/// Whether GENERATE_MIPMAP gives the same levels whatever its hint says.
fn same_levels(ours: &Ours) -> bool {
    let texels = bytes_of(&patterns::checks(64));
    let levels = |mode: u32| -> Vec<u8> {
        let mut cx = ours.context([16, 16], false);
        cx.hint(GL_GENERATE_MIPMAP_HINT, mode);
        cx.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
        Gl::tex_image_2d(&mut cx, 0, GL_RGBA8 as i32, [64, 64], &texels);
        let mut level = vec![0u8; 32 * 32 * 4];
        cx.get_tex_image(GL_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut level);
        level
    };
    levels(GL_FASTEST) == levels(GL_NICEST)
}

/// The plane in fog, as a grid of `cells` x `cells`: the finer, the better for a fog of the corners.
fn foggy(plane: &Scene, cells: i32) -> Scene {
    let mut scene = plane.clone();
    scene.fog = Some(super::oracle::fragment::Fog {
        mode: GL_EXP2,
        density: 0.05,
        color: [0.6, 0.65, 0.7, 1.0],
        ..Default::default()
    });
    scene.triangles.clear();
    let v = |i: i32, j: i32| {
        let (u, v) = (f64::from(i) / f64::from(cells), f64::from(j) / f64::from(cells));
        let (x, z) = (144.0 * u - 72.0, -0.5 - 56.0 * v);
        Vertex::at(x, -1.0, z).st(x / 4.0, z / 4.0)
    };
    for j in 0..cells {
        for i in 0..cells {
            scene.quad([v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1)]);
        }
    }
    as_given(scene)
}

/// The same with f computed at the corners: a fog coordinate from 1 (no fog) to 0, under LINEAR with end 0 and start 1.
fn fog_of_corners(exact: &Scene) -> Scene {
    let mut corners = exact.clone();
    let state = corners.vertex.clone();
    if let Some(fog) = corners.fog.as_mut() {
        for v in corners.triangles.iter_mut().flatten() {
            v.fog_coord = fog.factor(state.run(v).fog);
        }
        (fog.mode, fog.start, fog.end) = (GL_LINEAR, 1.0, 0.0);
    }
    corners.vertex.fog_from_coordinate = true;
    as_given(corners)
}

fn fog(ours: &Ours, plane: &Scene, seconds: f64) -> Verdict {
    let knobs = &settings(Depth::Short, true)[0];
    let (large, small) = (foggy(plane, 1), foggy(plane, 12));
    let (of_large, of_small) = (fog_of_corners(&large), fog_of_corners(&small));
    let scenes = [(&large, knobs), (&of_large, knobs), (&small, knobs), (&of_small, knobs)];
    let found = timed(ours, &scenes, seconds);
    let spec = truth::spec(&large, knobs);
    let trial = |i: usize, name: &str| Trial {
        name: name.to_string(),
        time: found[i].0,
        time_unit: "ns a fragment",
        error: Error::of(&found[i].1, &spec.ideal, |p| spec.hits[p] > 0).rmse,
        error_unit: "LSB rms from EXP2 at every pixel",
    };
    let trials = vec![
        trial(0, "one quad, EXP2 at every pixel"),
        trial(1, "one quad, f of the corners"),
        trial(2, "12 x 12 quads, EXP2 at every pixel"),
        trial(3, "12 x 12 quads, f of the corners"),
    ];
    let change = |a: usize, b: usize| 100.0 * (trials[b].time / trials[a].time - 1.0);
    let same = same_bytes(ours, &large, GL_FOG_HINT);
    // A hint may not make a picture unrecognisable: what it saves has to be had at 1 LSB.
    let worth = change(0, 1) < -100.0 * WORTH && trials[1].error < 1.0;
    let text = format!(
        "FASTEST could compute f at the corners only, tried through FogCoord. A floor of one quad then takes {:.2} ns a fragment instead of {:.2} \
         ({:+.0} %) and is off by {:.1} LSB rms; one of 12 x 12 quads {:.2} instead of {:.2} ({:+.0} %) and {:.2} LSB, where the formula at every \
         pixel is off by {:.2}. A program that has small triangles can say so by FogCoord. {}",
        trials[1].time,
        trials[0].time,
        change(0, 1),
        trials[1].error,
        trials[3].time,
        trials[2].time,
        change(2, 3),
        trials[3].error,
        trials[2].error,
        stored(same)
    );
    Verdict { hint: "GL_FOG_HINT", effect: !same, worth, text, trials }
}

fn compression(ours: &Ours) -> Verdict {
    let image = patterns::colored_checks(256, 10, [0.9, 0.5, 0.2], [0.1, 0.3, 0.6]);
    let texels = bytes_of(&image);
    let pack = |mode: u32| -> (f64, Vec<u8>) {
        let mut cx = ours.context([16, 16], false);
        cx.hint(GL_TEXTURE_COMPRESSION_HINT, mode);
        let mut time = f64::MAX;
        for _ in 0..5 {
            let start = Instant::now();
            Gl::tex_image_2d(&mut cx, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT as i32, [256, 256], &texels);
            time = time.min(start.elapsed().as_secs_f64() * 1e9 / 65536.0);
        }
        let mut back = vec![0u8; texels.len()];
        cx.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut back);
        (time, back)
    };
    let (fast, nice) = (pack(GL_FASTEST), pack(GL_NICEST));
    let trial = |name: &str, (time, back): &(f64, Vec<u8>)| {
        let colors = texels.chunks(4).zip(back.chunks(4)).flat_map(|(a, b)| a[..3].iter().zip(&b[..3]));
        let squares: f64 = colors.map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2)).sum();
        Trial {
            name: name.to_string(),
            time: *time,
            time_unit: "ns a texel",
            error: (squares / (3.0 * 65536.0)).sqrt(),
            error_unit: "LSB rms from the image",
        }
    };
    let trials = vec![trial("FASTEST and DONT_CARE: two texels", &fast), trial("NICEST: least squares", &nice)];
    let gained = 1.0 - trials[1].error / trials[0].error;
    let text = format!(
        "NICEST fits the two colours of a block to its texels by least squares; FASTEST and DONT_CARE take those of the two texels that lie farthest \
         apart. The error of a DXT1 image of noisy checks falls from {:.2} to {:.2} LSB ({:+.0} %) for {:.1} times the time of the upload. {}",
        trials[0].error,
        trials[1].error,
        -100.0 * gained,
        trials[1].time / trials[0].time,
        stored(fast.1 == nice.1)
    );
    Verdict { hint: "GL_TEXTURE_COMPRESSION_HINT", effect: fast.1 != nice.1, worth: gained > WORTH, text, trials }
}
