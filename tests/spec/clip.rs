//! Clipping (OpenGL 1.5, section 2.12): the clip volume and user planes against the oracle. What is extreme (planes and
//! their opposites, vertices behind the eye, at infinity, huge, or no numbers at all) is in `tests/stability/clip.rs`.

use crate::support::compare::{EDGES, compare};
use crate::support::scenes::heap;
use crate::support::{Random, raises};
use fixedgl::Context;
use fixedgl::enums::*;

#[test]
fn planes_are_kept_in_eye_coordinates() {
    let mut cx = Context::new(4, 4);
    let mut p = [1.0f64; 4];
    cx.get_clip_plane(GL_CLIP_PLANE3, &mut p);
    assert_eq!(p, [0.0; 4]);
    cx.translatef(0.0, 0.0, -5.0);
    cx.clip_plane(GL_CLIP_PLANE3, &[0.0, 0.0, 1.0, 0.0]);
    cx.get_clip_plane(GL_CLIP_PLANE3, &mut p);
    assert_eq!(p, [0.0, 0.0, 1.0, 5.0]);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.clip_plane(GL_CLIP_PLANE0 + 40, &[0.0; 4]));
}

#[test]
fn the_volume_and_user_planes_clip_as_in_the_oracle() {
    let mut random = Random(4);
    for seed in 0..8 {
        let mut scene = heap(96, 96, 10, 1.0, 100 + seed);
        // Wider than the window, nearer than the near plane, behind the eye.
        for v in scene.triangles.iter_mut().flatten() {
            v.position[0] *= 4.0;
            v.position[2] += 3.0;
        }
        scene.clip_planes = (0..seed.min(6))
            .map(|_| {
                [random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(0.0, 3.0)]
            })
            .collect();
        // Edges that clipping makes are where the two may round differently.
        let f = compare(&scene, EDGES);
        f.print(&format!("{} user planes", scene.clip_planes.len()));
        assert!(f.off * 2000 <= f.compared, "{f:?}");
    }
}
