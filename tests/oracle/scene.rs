//! The whole machine: a list of triangles and a state become the ideal colour of every pixel. The order is the
//! specification's: vertices, clipping, viewport, coverage, interpolation, texture units, colour sum, fog, scissor-free
//! per-fragment tests, blending, storage. Beside the colour each pixel tells how it came about (texture coordinates,
//! lambda, distance to the next texel boundary and to the next edge), so that a test knows where an answer is on a knife's
//! edge and may be either of two.

use super::clip::clip_triangle;
use super::env::{Env, Inputs};
use super::fragment::{Blend, Fog, color_sum, passes, stored};
use super::raster::{Triangle, Viewport, coverage_within};
use super::texel::{Sampled, Texture};
use super::vertex::{Shaded, Vertex, VertexState};
use super::{V2, V3, V4, clamp01};
use fixedgl::enums::*;

/// One texture unit: a texture, if one is enabled, and its environment.
#[derive(Clone, Debug, Default)]
pub struct Unit {
    pub texture: Option<Texture>,
    pub env: Env,
}

/// All state of a picture.
#[derive(Clone, Debug)]
pub struct Scene {
    pub width: u32,
    pub height: u32,
    pub viewport: Viewport,
    pub vertex: VertexState,
    /// Clip planes in eye coordinates.
    pub clip_planes: Vec<V4>,
    pub units: Vec<Unit>,
    /// SHADE_MODEL is FLAT: the colour of the last vertex.
    pub flat: bool,
    /// CULL_FACE with this face; FRONT_FACE is CCW unless `clockwise`.
    pub cull: Option<GLenum>,
    pub clockwise: bool,
    /// PolygonOffset(factor, units) with the smallest step of depth.
    pub offset: Option<(f64, f64)>,
    pub color_sum: bool,
    pub fog: Option<Fog>,
    /// AlphaFunc.
    pub alpha: Option<(GLenum, f64)>,
    /// DepthFunc and DepthMask.
    pub depth: Option<(GLenum, bool)>,
    pub blend: Option<Blend>,
    pub clear: V4,
    pub triangles: Vec<[Vertex; 3]>,
}

/// How a pixel got its colour: the last fragment that was stored there.
#[derive(Clone, Debug, Default)]
pub struct Story {
    /// Distance of the centre to the nearest edge of its triangle, in pixels.
    pub to_edge: f64,
    /// (s, t, r) after division by q, a unit each.
    pub coords: Vec<V3>,
    /// What each unit's texture gave.
    pub samples: Vec<Option<Sampled>>,
    /// The smallest distance of any unit's coordinates from a texel boundary, in texels.
    pub to_boundary: f64,
    /// The triangle's place in the list.
    pub triangle: usize,
}

/// One pixel of the picture.
#[derive(Clone, Debug)]
pub struct Pixel {
    /// The colour before it is rounded to 8 bits.
    pub ideal: V4,
    pub depth: f64,
    /// How many fragments were stored here.
    pub hits: u32,
    /// The least distance to an edge over all triangles, inside or outside: a small one makes the coverage doubtful.
    pub nearest_edge: f64,
    pub story: Option<Story>,
}

impl Pixel {
    /// The four bytes of an RGBA8 frame buffer.
    pub fn bytes(&self) -> [u8; 4] {
        self.ideal.map(super::fragment::to_byte)
    }
}

/// The picture, row by row from the bottom, as ReadPixels returns it.
pub struct Picture {
    pub width: u32,
    pub height: u32,
    pub pixels: Vec<Pixel>,
}

impl Picture {
    pub fn at(&self, x: u32, y: u32) -> &Pixel {
        &self.pixels[(y * self.width + x) as usize]
    }
}

/// A corner of a clipped triangle with everything that is interpolated over it.
struct Corner {
    clip: V4,
    colors: [V4; 2],
    fog: f64,
    tex: Vec<V4>,
}

impl Scene {
    /// A picture of that size with GL's initial state: one unit, nothing enabled, black background.
    pub fn new(width: u32, height: u32) -> Scene {
        Scene {
            width,
            height,
            viewport: Viewport::whole(width, height),
            vertex: VertexState::default(),
            clip_planes: Vec::new(),
            units: vec![Unit::default()],
            flat: false,
            cull: None,
            clockwise: false,
            offset: None,
            color_sum: false,
            fog: None,
            alpha: None,
            depth: None,
            blend: None,
            clear: [0.0; 4],
            triangles: Vec::new(),
        }
    }

    /// Adds the two triangles of a quad a, b, c, d.
    pub fn quad(&mut self, [a, b, c, d]: [Vertex; 4]) {
        self.triangles.push([a.clone(), b, c.clone()]);
        self.triangles.push([a, c, d]);
    }

    /// Draws everything.
    pub fn render(&self) -> Picture {
        let blank = Pixel { ideal: stored(self.clear), depth: 1.0, hits: 0, nearest_edge: f64::INFINITY, story: None };
        let pixels = vec![blank; (self.width * self.height) as usize];
        let mut picture = Picture { width: self.width, height: self.height, pixels };
        for (index, vertices) in self.triangles.iter().enumerate() {
            self.triangle(index, vertices, &mut picture);
        }
        picture
    }

    fn triangle(&self, index: usize, vertices: &[Vertex; 3], picture: &mut Picture) {
        let shaded = [0, 1, 2].map(|i| self.vertex.run(&vertices[i]));
        let polygon =
            clip_triangle([0, 1, 2].map(|i| shaded[i].clip), [0, 1, 2].map(|i| shaded[i].eye), &self.clip_planes, true);
        let windows: Vec<_> = polygon.iter().map(|c| self.viewport.window(c.clip)).collect();
        // Equation 2.6 over the whole clipped polygon.
        let area: f64 = (0..windows.len())
            .map(|i| {
                let (a, b) = (windows[i], windows[(i + 1) % windows.len()]);
                a.x * b.y - b.x * a.y
            })
            .sum();
        let front = (area > 0.0) != self.clockwise;
        let culled = match self.cull {
            Some(GL_FRONT) => front,
            Some(GL_BACK) => !front,
            Some(_) => true,
            None => false,
        };
        if culled || polygon.len() < 3 {
            return;
        }
        let corners: Vec<Corner> = polygon.iter().map(|c| self.corner(&shaded, c.clip, c.weights, front)).collect();
        for i in 1..corners.len() - 1 {
            let parts = [&corners[0], &corners[i], &corners[i + 1]];
            self.part(index, parts, picture);
        }
    }

    /// The data of a corner as the weighted sum of those of the triangle.
    fn corner(&self, shaded: &[Shaded; 3], clip: V4, w: [f64; 3], front: bool) -> Corner {
        let side = |s: &Shaded| if front { s.front } else { s.back };
        let last = side(&shaded[2]);
        let sum4 = |f: &dyn Fn(&Shaded) -> V4| -> V4 {
            std::array::from_fn(|k| (0..3).map(|i| w[i] * f(&shaded[i])[k]).sum())
        };
        let color = |k: usize| if self.flat { last[k] } else { sum4(&|s| side(s)[k]) };
        Corner {
            clip,
            colors: [color(0), color(1)],
            fog: (0..3).map(|i| w[i] * shaded[i].fog).sum(),
            tex: (0..self.vertex.units.len()).map(|u| sum4(&|s| s.tex[u])).collect(),
        }
    }

    /// Rasterises one triangle of the clipped polygon.
    fn part(&self, index: usize, corners: [&Corner; 3], picture: &mut Picture) {
        let triangle = Triangle(corners.map(|c| self.viewport.window(c.clip)));
        // Where a triangle ends more than a pixel away it puts nothing in doubt.
        let near = |k: usize, size: u32| {
            let v = triangle.0.map(|v| if k == 0 { v.x } else { v.y });
            let (low, high) = (v[0].min(v[1]).min(v[2]) - 2.0, v[0].max(v[1]).max(v[2]) + 2.0);
            (low.max(0.0) as u32).min(size)..(high.max(0.0) as u32).min(size)
        };
        for y in near(1, self.height) {
            for x in near(0, self.width) {
                let d = triangle.edge_distance(f64::from(x) + 0.5, f64::from(y) + 0.5).abs();
                let p = &mut picture.pixels[(y * self.width + x) as usize];
                p.nearest_edge = p.nearest_edge.min(d);
            }
        }
        let offset = self.offset.map_or(0.0, |(f, u)| triangle.offset(f, u, 1.0 / f64::from((1 << 24) - 1)));
        let window = [[0, i64::from(self.width) - 1], [0, i64::from(self.height) - 1]];
        for [x, y] in coverage_within(triangle.snapped(), window) {
            let (Ok(px), Ok(py)) = (u32::try_from(x), u32::try_from(y)) else { continue };
            let v = &self.viewport;
            let (fx, fy) = (x as f64, y as f64);
            let inside = fx >= v.x && fx < v.x + v.width && fy >= v.y && fy < v.y + v.height;
            if !inside || px >= self.width || py >= self.height {
                continue;
            }
            let at = [fx + 0.5, fy + 0.5];
            let depth = (triangle.depth(at) + offset).clamp(0.0, 1.0);
            let (color, story) = self.shade(index, &triangle, corners, at);
            self.store(color, depth, story, &mut picture.pixels[(py * self.width + px) as usize]);
        }
    }

    /// The colour of a fragment after texturing, colour sum and fog (chapter 3).
    fn shade(&self, index: usize, triangle: &Triangle, corners: [&Corner; 3], at: V2) -> (V4, Story) {
        let value = |f: &dyn Fn(&Corner) -> f64| triangle.interpolate(at, corners.map(f), [1.0; 3]).0;
        let color = |k: usize| -> V4 { clamp01(std::array::from_fn(|i| value(&|c| c.colors[k][i]))) };
        let (primary, secondary) = (color(0), color(1));
        let mut story = Story { to_edge: triangle.edge_distance(at[0], at[1]), triangle: index, ..Story::default() };
        story.to_boundary = f64::INFINITY;
        for (u, unit) in self.units.iter().enumerate() {
            let Some(texture) = &unit.texture else {
                story.coords.push([0.0; 3]);
                story.samples.push(None);
                continue;
            };
            let q = corners.map(|c| c.tex[u][3]);
            let part = [0, 1, 2].map(|k| triangle.interpolate(at, corners.map(|c| c.tex[u][k]), q));
            let coords: V3 = part.map(|(f, _)| f);
            let sample = texture.sample(coords, part.map(|(_, d)| d[0]), part.map(|(_, d)| d[1]));
            story.coords.push(coords);
            story.to_boundary = story.to_boundary.min(sample.to_boundary);
            story.samples.push(Some(sample));
        }
        let textures: Vec<V4> = story.samples.iter().map(|s| s.map_or([0.0; 4], |s| s.color)).collect();
        let mut previous = primary;
        for (u, unit) in self.units.iter().enumerate() {
            if let Some(texture) = &unit.texture {
                let base_format = match texture.base_format {
                    GL_DEPTH_COMPONENT => texture.depth_mode,
                    f => f,
                };
                let inputs = Inputs { texture: textures[u], base_format, textures: &textures, primary, previous };
                previous = unit.env.apply(&inputs);
            }
        }
        if self.color_sum || self.vertex.lighting.is_some() {
            previous = color_sum(previous, secondary);
        }
        if let Some(fog) = &self.fog {
            // The distance is that of the fragment's point (3.10), which may lie before the eye where a vertex lies behind it.
            let c = value(&|c| c.fog);
            let signed = self.vertex.fog_from_coordinate || self.vertex.fog_distance == GL_EYE_PLANE;
            previous = fog.apply(previous, if signed { c } else { c.abs() });
        }
        (previous, story)
    }

    /// The tests, blending and storage (chapter 4).
    fn store(&self, color: V4, depth: f64, story: Story, pixel: &mut Pixel) {
        if let Some((func, reference)) = self.alpha
            && !passes(func, (color[3] * 255.0).round(), (reference.clamp(0.0, 1.0) * 255.0).round())
        {
            return;
        }
        if let Some((func, mask)) = self.depth {
            let steps = |z: f64| (z * f64::from((1 << 24) - 1)).round();
            if !passes(func, steps(depth), steps(pixel.depth)) {
                return;
            }
            if mask {
                pixel.depth = depth;
            }
        }
        pixel.ideal = match &self.blend {
            Some(blend) => blend.apply(color, stored(pixel.ideal)),
            None => clamp01(color),
        };
        pixel.hits += 1;
        pixel.story = Some(story);
    }
}

#[cfg(test)]
mod tests {
    use super::super::assert_near;
    use super::super::matrix::M4;
    use super::super::texel::Image;
    use super::*;

    fn square(z: f64) -> [Vertex; 4] {
        let v = |x, y| Vertex::at(x, y, z).st((x + 1.0) / 2.0, (y + 1.0) / 2.0);
        [v(-1.0, -1.0), v(1.0, -1.0), v(1.0, 1.0), v(-1.0, 1.0)]
    }

    #[test]
    fn a_texture_as_large_as_the_window_is_copied() {
        let mut scene = Scene::new(8, 8);
        let image = Image::from_fn(8, 8, |i, j| [i as f64 / 8.0, j as f64 / 8.0, 0.0, 1.0]);
        let mut texture = Texture::flat(GL_RGBA, image);
        texture.lod.min_filter = GL_NEAREST;
        scene.units[0] = Unit { texture: Some(texture), env: Env { mode: GL_REPLACE, ..Env::default() } };
        scene.quad(square(0.0));
        let picture = scene.render();
        assert!(picture.pixels.iter().all(|p| p.hits == 1));
        assert_near(&picture.at(3, 5).ideal, &[0.375, 0.625, 0.0, 1.0], 1e-14);
        let story = picture.at(3, 5).story.clone().unwrap();
        assert_near(&[story.to_boundary, story.samples[0].unwrap().lambda], &[0.5, 0.0], 1e-12);
        assert_near(&story.coords[0][..2], &[3.5 / 8.0, 5.5 / 8.0], 1e-12);
    }

    #[test]
    fn a_floor_shrinks_with_distance() {
        let mut scene = Scene::new(16, 16);
        scene.vertex.projection = M4::perspective(90.0, 1.0, 0.1, 100.0);
        let image = |n: i64| vec![Image::from_fn(n, n, |_, _| [1.0; 4])];
        let mut texture = Texture::new(GL_TEXTURE_2D, GL_RGBA, (0..7).map(|l| image(64 >> l)).collect());
        texture.lod.min_filter = GL_LINEAR_MIPMAP_LINEAR;
        scene.units[0].texture = Some(texture);
        let v = |x: f64, z: f64| Vertex::at(x, -1.0, z).st(x, z);
        scene.quad([v(-50.0, 10.0), v(50.0, 10.0), v(50.0, -50.0), v(-50.0, -50.0)]);
        let picture = scene.render();
        let lambda = |y| picture.at(8, y).story.as_ref().unwrap().samples[0].unwrap().lambda;
        assert!(lambda(7) > lambda(5) && lambda(5) > lambda(0));
        // The centre of row 0 is at -15/16 of the half height: z = -16/15; t = z changes by dz/dy = (16/15)^2 / 8
        // a pixel, and s = z / 16 with it.
        let want = (64.0 * (16.0f64 / 15.0).powi(2) / 8.0 * (1.0 + 1.0 / 256.0f64).sqrt()).log2();
        assert_near(&[lambda(0)], &[want], 1e-9);
        assert_eq!(picture.at(8, 9).hits, 0);
    }

    #[test]
    fn depth_blend_alpha_and_fog_in_order() {
        let mut scene = Scene::new(4, 4);
        scene.depth = Some((GL_LESS, true));
        scene.blend = Some(Blend::func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
        scene.alpha = Some((GL_GREATER, 0.25));
        let colored = |z: f64, c: V4| square(z).map(|v| v.colored(c));
        scene.quad(colored(0.5, [1.0, 0.0, 0.0, 1.0]));
        scene.quad(colored(0.7, [0.0, 1.0, 0.0, 1.0])); // behind
        scene.quad(colored(0.0, [0.0, 0.0, 1.0, 0.5]));
        scene.quad(colored(-0.5, [1.0, 1.0, 1.0, 0.2])); // alpha too small
        let picture = scene.render();
        assert_near(&picture.at(1, 2).ideal, &[0.5, 0.0, 0.5, 0.75], 1e-12);
        assert_near(&[picture.at(1, 2).depth], &[0.5], 1e-12);
        assert_eq!(picture.at(1, 2).hits, 2);
    }

    #[test]
    fn faces_turn_and_are_culled() {
        let mut scene = Scene::new(4, 4);
        scene.cull = Some(GL_BACK);
        scene.quad(square(0.0));
        assert_eq!(scene.render().at(0, 0).hits, 1);
        scene.clockwise = true;
        assert_eq!(scene.render().at(0, 0).hits, 0);
    }
}
