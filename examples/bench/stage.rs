//! What the scenes of the benchmark share: a context with its projection, textures made of noise, the quads, the ground
//! plane and the meshes that are drawn again and again.

use fixedgl::Config;
use fixedgl::Context;
use fixedgl::enums::*;
use fixedgl::math::{cos, sin};
use std::collections::BTreeMap;
use std::sync::Mutex;

/// Degrees to radians.
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// A vertex of a mesh: position, normal, texture coordinate.
type Vertex = [f32; 8];

/// Where the vertices of a mesh lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Arrays {
    /// In memory of the program.
    Client,
    /// In buffer objects.
    Buffers,
}

/// A context with what a scene draws.
pub struct Stage {
    /// The context.
    pub gl: Context,
    /// Width and height of the framebuffer.
    pub size: u32,
    /// By what the cells of a mesh on each side are divided: 1 to measure, more where it is drawn again and again.
    pub coarser: usize,
    /// Depth of the quad.
    pub z: f32,
    /// Whether its corners have colours of their own.
    pub colored: bool,
    /// How many units the ground has coordinates for.
    pub units: usize,
    /// s and t of the quad for each pixel in x and y.
    slopes: [[f32; 2]; 2],
    /// The mesh.
    pub vertices: Vec<Vertex>,
    /// Its triangles.
    pub indices: Vec<u32>,
    /// Where its vertices lie.
    arrays: Option<Arrays>,
    /// How many triangles one drawing has.
    pub triangles: usize,
    /// Texels to upload.
    pub upload: Vec<u8>,
}

/// A texture of noise.
pub struct Tex {
    /// The target, or the face of a cube map.
    pub target: GLenum,
    /// Width and height.
    pub size: usize,
    /// Minification; a mipmap filter gets its levels.
    pub min: GLenum,
    /// Magnification.
    pub mag: GLenum,
    /// Wrapping of s and t.
    pub wrap: GLenum,
    /// Whether alpha is not 1.
    pub alpha: bool,
}

impl Default for Tex {
    fn default() -> Self {
        Self {
            target: GL_TEXTURE_2D,
            size: 256,
            min: GL_LINEAR_MIPMAP_LINEAR,
            mag: GL_LINEAR,
            wrap: GL_REPEAT,
            alpha: false,
        }
    }
}

/// Noise of seven scales, RGBA. It is kept: scenes ask for the same again and again.
pub fn noise(size: usize, alpha: bool) -> Vec<u8> {
    static KEPT: Mutex<BTreeMap<(usize, bool), Vec<u8>>> = Mutex::new(BTreeMap::new());
    let Ok(mut kept) = KEPT.lock() else { return make_noise(size, alpha) };
    kept.entry((size, alpha)).or_insert_with(|| make_noise(size, alpha)).clone()
}

fn make_noise(size: usize, alpha: bool) -> Vec<u8> {
    let hash = |x: usize, y: usize, c: usize, k: usize| {
        let h = (x >> k).wrapping_mul(0x9E37_79B1) ^ (y >> k).wrapping_mul(0x85EB_CA77) ^ (c * 31 + k);
        let h = (h ^ (h >> 15)).wrapping_mul(0x2C1B_3C6D);
        (h >> 12) & 0xFF
    };
    let mut texels = Vec::with_capacity(size * size * 4);
    for i in 0..size * size {
        let (x, y) = (i % size, i / size);
        let mut channel = |c| texels.push(((0..7).map(|k| hash(x, y, c, k)).sum::<usize>() / 7) as u8);
        (0..3).for_each(&mut channel);
        if alpha { channel(3) } else { texels.push(255) }
    }
    texels
}

impl Stage {
    /// A fresh context, one unit a pixel, nothing enabled.
    pub fn new(size: u32, config: Config) -> Self {
        let mut gl = Context::with_config(size, size, config);
        gl.matrix_mode(GL_PROJECTION);
        gl.ortho(0.0, f64::from(size), 0.0, f64::from(size), -1.0, 1.0);
        gl.matrix_mode(GL_MODELVIEW);
        gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        Self {
            gl,
            size,
            coarser: 1,
            z: 0.0,
            colored: false,
            units: 1,
            slopes: [[0.0; 2]; 2],
            vertices: Vec::new(),
            indices: Vec::new(),
            arrays: None,
            triangles: 2,
            upload: Vec::new(),
        }
    }

    /// Turns the depth test on.
    pub fn depth(&mut self, func: GLenum) {
        self.gl.enable(GL_DEPTH_TEST);
        self.gl.depth_func(func);
    }

    /// Uploads a texture to a new object of the active unit (faces of a cube map share one) and enables its target.
    pub fn texture(&mut self, tex: Tex) -> u32 {
        let faces = GL_TEXTURE_CUBE_MAP_POSITIVE_X..=GL_TEXTURE_CUBE_MAP_NEGATIVE_Z;
        let target = if faces.contains(&tex.target) { GL_TEXTURE_CUBE_MAP } else { tex.target };
        let gl = &mut self.gl;
        let mut name = [0];
        if target == GL_TEXTURE_2D {
            gl.gen_textures(1, &mut name);
            gl.bind_texture(target, name[0]);
        }
        for (pname, value) in [
            (GL_TEXTURE_MIN_FILTER, tex.min),
            (GL_TEXTURE_MAG_FILTER, tex.mag),
            (GL_TEXTURE_WRAP_S, tex.wrap),
            (GL_TEXTURE_WRAP_T, tex.wrap),
        ] {
            gl.tex_parameteri(target, pname, value);
        }
        let mipmaps = !matches!(tex.min, GL_NEAREST | GL_LINEAR);
        gl.tex_parameteri(target, GL_GENERATE_MIPMAP, i32::from(mipmaps));
        let (n, texels) = (tex.size as i32, noise(tex.size, tex.alpha));
        gl.tex_image_2d(tex.target, 0, GL_RGBA8, n, n, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
        gl.enable(target);
        name[0]
    }

    /// The quad's coordinates: so many of the texture a pixel, turned by an angle.
    pub fn turn(&mut self, scale: f64, degrees: f64) {
        let (c, s) = (cos(degrees * DEGREE) * scale, sin(degrees * DEGREE) * scale);
        self.slopes = [[c as f32, -s as f32], [s as f32, c as f32]];
    }

    /// A quad over the whole framebuffer.
    pub fn quad(&mut self) {
        const COLORS: [[f32; 4]; 4] =
            [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0], [1.0, 1.0, 1.0, 1.0]];
        let side = self.size as f32;
        let [s, t] = self.slopes;
        self.gl.begin(GL_QUADS);
        for ([x, y], [r, g, b, a]) in [[0.0f32, 0.0], [side, 0.0], [side, side], [0.0, side]].into_iter().zip(COLORS) {
            if self.colored {
                self.gl.color4f(r, g, b, a);
            }
            self.gl.tex_coord2f(s[0] * x + s[1] * y, t[0] * x + t[1] * y);
            self.gl.vertex3f(x, y, self.z);
        }
        self.gl.end();
    }

    /// A perspective projection.
    pub fn perspective(&mut self, degrees: f64, near: f64, far: f64) {
        let top = near * sin(0.5 * degrees * DEGREE) / cos(0.5 * degrees * DEGREE);
        self.gl.matrix_mode(GL_PROJECTION);
        self.gl.load_identity();
        self.gl.frustum(-top, top, -top, top, near, far);
        self.gl.matrix_mode(GL_MODELVIEW);
        self.gl.load_identity();
    }

    /// The view of [`Stage::tilted`], magnified everywhere.
    pub fn tilt(&mut self) {
        self.perspective(60.0, 0.1, 100.0);
        self.gl.translatef(0.0, 0.0, -2.0);
        self.gl.rotatef(-35.0, 1.0, 0.0, 0.0);
        self.gl.rotatef(10.0, 0.0, 0.0, 1.0);
        self.depth(GL_LEQUAL);
    }

    /// A tilted quad that covers the whole framebuffer.
    pub fn tilted(&mut self) {
        self.gl.begin(GL_QUADS);
        for ([r, g, b], [x, y]) in [
            ([1.0, 0.5, 0.5], [-7.0, -7.0]),
            ([0.5, 1.0, 0.5], [7.0, -7.0]),
            ([0.5, 0.5, 1.0], [7.0, 7.0]),
            ([1.0, 1.0, 1.0], [-7.0, 7.0]),
        ] {
            self.gl.color4f(r, g, b, 1.0);
            self.gl.tex_coord2f(0.25 * x, 0.25 * y);
            self.gl.vertex3f(x, y, 0.0);
        }
        self.gl.end();
    }

    /// The view of [`Stage::ground`]: 1.5 above it, looking down a little.
    pub fn stand_on_ground(&mut self) {
        self.perspective(60.0, 0.25, 1200.0);
        self.gl.rotatef(12.0, 1.0, 0.0, 0.0);
        self.gl.translatef(0.0, -1.5, 0.0);
        self.depth(GL_LEQUAL);
    }

    /// A plane from under the viewer to the horizon.
    pub fn ground(&mut self) {
        self.gl.begin(GL_QUADS);
        for [x, z] in [[-600.0f32, 6.0], [600.0, 6.0], [600.0, -600.0], [-600.0, -600.0]] {
            self.gl.tex_coord2f(0.25 * x, 0.25 * z);
            if self.units > 1 {
                self.gl.multi_tex_coord2f(GL_TEXTURE1, x / 64.0, z / 64.0);
            }
            self.gl.vertex3f(x, 0.0, z);
        }
        self.gl.end();
    }

    /// Two triangles for each cell of a lattice of vertices.
    pub fn lattice(&mut self, [nu, nv]: [usize; 2], vertex: impl Fn(usize, usize) -> Vertex) {
        self.vertices = (0..=nv).flat_map(|j| (0..=nu).map(move |i| (i, j))).map(|(i, j)| vertex(i, j)).collect();
        let cells = (0..nv).flat_map(|j| (0..nu).map(move |i| (j * (nu + 1) + i) as u32));
        let up = nu as u32 + 1;
        self.indices = cells.flat_map(|a| [a, a + 1, a + up + 1, a, a + up + 1, a + up]).collect();
        self.triangles = self.indices.len() / 3;
    }

    /// A grid over the framebuffer with wavy normals.
    pub fn grid(&mut self, nu: usize, nv: usize) {
        let side = self.size as f32;
        self.lattice([nu, nv], |i, j| {
            let (s, t) = (i as f32 / nu as f32, j as f32 / nv as f32);
            let nx = 0.4 * sin(i as f64 * 0.1) as f32;
            let ny = 0.4 * cos(j as f64 * 0.13) as f32;
            [side * s, side * t, 0.0, nx, ny, (1.0 - nx * nx - ny * ny).sqrt(), 4.0 * s, 4.0 * t]
        });
    }

    /// A torus of 100,000 triangles before the viewer.
    pub fn torus(&mut self, arrays: Arrays) {
        let [nu, nv] = [250, 200].map(|cells| cells / self.coarser);
        self.lattice([nu, nv], |i, j| {
            let (u, w) = (360.0 * DEGREE * i as f64 / nu as f64, 360.0 * DEGREE * j as f64 / nv as f64);
            let n = [cos(w) * cos(u), cos(w) * sin(u), sin(w)];
            let p = [(1.0 + 0.45 * cos(w)) * cos(u), (1.0 + 0.45 * cos(w)) * sin(u), 0.45 * sin(w)];
            let t = [8.0 * i as f64 / nu as f64, 3.0 * j as f64 / nv as f64];
            [p[0], p[1], p[2], n[0], n[1], n[2], t[0], t[1]].map(|v| v as f32)
        });
        self.perspective(45.0, 0.1, 100.0);
        self.gl.translatef(0.0, 0.0, -3.6);
        self.gl.rotatef(-40.0, 1.0, 0.0, 0.0);
        self.depth(GL_LEQUAL);
        self.gl.enable(GL_CULL_FACE);
        self.bind_mesh(arrays);
    }

    /// Makes the mesh the source of arrays.
    pub fn bind_mesh(&mut self, arrays: Arrays) {
        let (gl, flat) = (&mut self.gl, self.vertices.as_flattened());
        if arrays == Arrays::Buffers {
            let mut names = [0; 2];
            gl.gen_buffers(2, &mut names);
            gl.bind_buffer(GL_ARRAY_BUFFER, names[0]);
            gl.buffer_data(GL_ARRAY_BUFFER, size_of_val(flat) as isize, flat, GL_STATIC_DRAW);
            gl.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
            let bytes = size_of_val(&self.indices[..]) as isize;
            gl.buffer_data(GL_ELEMENT_ARRAY_BUFFER, bytes, &self.indices, GL_STATIC_DRAW);
            gl.vertex_pointer(3, GL_FLOAT, 32, 0usize);
            gl.normal_pointer(GL_FLOAT, 32, 12usize);
            gl.tex_coord_pointer(2, GL_FLOAT, 32, 24usize);
        } else {
            gl.vertex_pointer(3, GL_FLOAT, 32, flat);
            gl.normal_pointer(GL_FLOAT, 32, &flat[3..]);
            gl.tex_coord_pointer(2, GL_FLOAT, 32, &flat[6..]);
        }
        for array in [GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY] {
            gl.enable_client_state(array);
        }
        self.arrays = Some(arrays);
    }

    /// Draws the mesh from its arrays.
    pub fn mesh(&mut self) {
        let count = self.indices.len() as i32;
        if self.arrays == Some(Arrays::Buffers) {
            self.gl.draw_elements(GL_TRIANGLES, count, GL_UNSIGNED_INT, 0usize);
        } else {
            self.gl.draw_elements(GL_TRIANGLES, count, GL_UNSIGNED_INT, &self.indices);
        }
    }

    /// How many pixels a scene covers: drawn once more in plain white.
    pub fn covered(&mut self, draw: fn(&mut Self)) -> usize {
        for unit in [GL_TEXTURE1, GL_TEXTURE0] {
            self.gl.active_texture(unit);
            for target in [GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP] {
                self.gl.disable(target);
            }
        }
        for capability in [GL_FOG, GL_ALPHA_TEST, GL_BLEND, GL_LIGHTING] {
            self.gl.disable(capability);
        }
        self.colored = false;
        self.gl.color4f(1.0, 1.0, 1.0, 1.0);
        self.gl.depth_mask(true);
        self.gl.clear_color(0.0, 0.0, 0.0, 0.0);
        self.gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw(self);
        self.gl.pixels().as_chunks::<4>().0.iter().filter(|pixel| pixel[1] != 0).count()
    }
}
