//! How cost grows: with the fragments of a frame, its triangles, the size of a texture, the units in use and the draws with
//! state changes between them. Each table has the least of several times on one thread (memory also with two) and the slope: the exponent b of
//! cost = a * n^b, fitted to the logarithms, so 1 is linear and 0 constant. Memory is the greatest size of the process
//! (VmHWM) above what it had before the frame; the system forgets the old greatest size when it is asked to.

use super::Options;
use super::stage::{Arrays, Stage, Tex, noise};
use super::timing::timed;
use fixedgl::Config;
use fixedgl::enums::*;
use std::fs;
use std::process::Command;

/// How long a point is measured at least, in seconds, unless one time is longer.
const LEAST: f64 = 0.25;

/// A number on the axis, what the frames cost in seconds, and further cells of the row.
struct Point {
    n: f64,
    cost: f64,
    cells: Vec<String>,
}

/// Prints the five tables.
pub fn run(options: &Options) {
    println!("One thread, {:?}.", options.level);
    fragments(options);
    triangles(options);
    texels(options);
    units(options);
    draws(options);
}

fn stage(options: &Options, size: u32) -> Stage {
    threaded(options, size, 1)
}

fn threaded(options: &Options, size: u32, threads: usize) -> Stage {
    Stage::new(size, Config::default().with_threads(threads).with_level(options.level))
}

/// The least time of a frame, the first one not counted.
fn least(stage: &mut Stage, mut draw: impl FnMut(&mut Stage)) -> f64 {
    let (mut least, mut sum) = (f64::MAX, timed(stage, &mut draw));
    let mut rounds = 0;
    while rounds < 2 || (sum < LEAST && rounds < 1000) {
        let time = timed(stage, &mut draw);
        (least, sum, rounds) = (least.min(time), sum + time, rounds + 1);
    }
    if let Err(error) = stage.gl.check() {
        eprintln!("{error}");
    }
    least
}

/// The exponent of the power law that fits best.
fn slope(points: &[Point]) -> f64 {
    let logs: Vec<_> = points.iter().filter(|p| p.n > 0.0 && p.cost > 0.0).map(|p| (p.n.ln(), p.cost.ln())).collect();
    let count = logs.len().max(1) as f64;
    let (x, y) = logs.iter().fold((0.0, 0.0), |(x, y), log| (x + log.0 / count, y + log.1 / count));
    let products = logs.iter().map(|log| (log.0 - x) * (log.1 - y)).sum::<f64>();
    products / logs.iter().map(|log| (log.0 - x).powi(2)).sum::<f64>()
}

/// Prints a table; the slopes are those of the whole axis and of its upper half.
fn print(title: &str, axis: &str, unit: &str, further: &[&str], points: &[Point]) {
    println!("\n### {title}\n");
    println!("| {axis} | ms | ns a {unit} |{}", further.iter().map(|f| format!(" {f} |")).collect::<String>());
    println!("|---|---|---|{}", "---|".repeat(further.len()));
    for Point { n, cost, cells } in points {
        let cells: String = cells.iter().map(|cell| format!(" {cell} |")).collect();
        println!("| {n} | {:.3} | {:.2} |{cells}", cost * 1e3, cost * 1e9 / n.max(1.0));
    }
    let upper = &points[points.len() / 2..];
    println!("\nSlope {:.2}; over the upper half {:.2}.", slope(points), slope(upper));
}

fn fragments(options: &Options) {
    let sizes = [64, 128, 256, 512, 1024, 2048, 4096];
    let points = sizes.map(|size| {
        let mut stage = stage(options, size);
        stage.texture(Tex { min: GL_LINEAR, ..Tex::default() });
        stage.turn(0.45 / 256.0, 30.0);
        let cost = least(&mut stage, Stage::quad);
        Point { n: f64::from(size).powi(2), cost, cells: vec![format!("{size} x {size}")] }
    });
    print("Fragments of a quad, LINEAR", "fragments", "fragment", &["framebuffer"], &points);
}

/// How many triangles lie in arrays; more of them are drawn in several calls of one frame.
const MESH: usize = 100_000;

/// Separate triangles of 4.5 pixels with normals and texture coordinates, in rows.
fn loose_triangles(stage: &mut Stage) {
    let columns = stage.size as usize / 4;
    let corners = |t: usize| {
        let (x, y) = ((t % columns * 4) as f32, (t / columns % columns * 4) as f32);
        [[0.0, 0.0], [3.0, 0.0], [0.0, 3.0]].map(|[dx, dy]| [x + dx, y + dy, 0.0, 0.0, 0.0, 1.0, dx / 3.0, dy / 3.0])
    };
    stage.vertices = (0..MESH).flat_map(corners).collect();
    stage.bind_mesh(Arrays::Buffers);
}

/// A frame of `n` triangles.
fn draw_triangles(stage: &mut Stage, n: usize) {
    for _ in 0..n.div_ceil(MESH) {
        stage.gl.draw_arrays(GL_TRIANGLES, 0, (3 * n.min(MESH)) as i32);
    }
}

fn ready_for_triangles(options: &Options, threads: usize) -> Stage {
    let mut stage = threaded(options, 1024, threads);
    stage.texture(Tex::default());
    stage.depth(GL_LEQUAL);
    loose_triangles(&mut stage);
    stage
}

fn triangles(options: &Options) {
    let points = (2..=7).map(|power| 10usize.pow(power)).map(|n| {
        let cost = least(&mut ready_for_triangles(options, 1), |stage| draw_triangles(stage, n));
        Point {
            n: n as f64,
            cost,
            cells: [1, 2].map(|threads| peak_of(n, threads).unwrap_or("unknown".into())).to_vec(),
        }
    });
    print(
        "Triangles of 4.5 pixels",
        "triangles",
        "triangle",
        &["memory, MiB", "with 2 threads"],
        &points.collect::<Vec<_>>(),
    );
}

/// What [`peak`] prints in a process of its own: here memory that was used and freed before would hide it.
fn peak_of(n: usize, threads: usize) -> Option<String> {
    let program = std::env::current_exe().ok()?;
    let output =
        Command::new(program).args(["--peak", &n.to_string(), "--threads", &threads.to_string()]).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?.trim().to_string();
    (!text.is_empty()).then_some(text)
}

/// Prints by how much a frame of `n` triangles lets the process grow, in MiB; nothing where the system does not say it.
pub fn peak(options: &Options, n: usize) {
    let mut stage = ready_for_triangles(options, options.threads);
    let before = forget_peak();
    draw_triangles(&mut stage, n);
    stage.gl.finish();
    if let Some((after, before)) = memory("VmHWM").zip(before) {
        println!("{:.1}", after.saturating_sub(before) as f64 / 1024.0);
    }
}

/// Makes the present size of the process its greatest one and gives it in KiB.
fn forget_peak() -> Option<u64> {
    fs::write("/proc/self/clear_refs", "5").ok()?;
    memory("VmHWM")
}

/// A size of the process, in KiB.
fn memory(name: &str) -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with(name))?;
    line.split_ascii_whitespace().nth(1)?.parse().ok()
}

fn texels(options: &Options) {
    let tile = noise(16, false);
    let points = (4..=13).map(|power| 1usize << power).map(|size| {
        let mut stage = stage(options, 1024);
        stage.texture(Tex { size: 16, ..Tex::default() });
        let row: Vec<u8> = tile[..64].iter().copied().cycle().take(4 * size).collect();
        stage.upload = row.repeat(size);
        let mut cost = [0.0; 3];
        for (generate, cost) in [0, 1].into_iter().zip(&mut cost) {
            stage.gl.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, generate);
            *cost = least(&mut stage, |stage| {
                let (n, texels) = (size as i32, &stage.upload);
                stage.gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, n, n, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
            });
        }
        // The whole texture once over the framebuffer, whatever its size.
        stage.turn(1.0 / 1024.0, 0.0);
        let [_, _, trilinear] = &mut cost;
        *trilinear = least(&mut stage, Stage::quad);
        let cells = vec![
            format!("{size} x {size}"),
            format!("{:.2}", cost[1] * 1e9 / (size * size) as f64),
            format!("{:.2}", cost[2] * 1e9 / 1024f64.powi(2)),
        ];
        Point { n: (size * size) as f64, cost: cost[0], cells }
    });
    let further = ["texture", "with levels, ns a texel", "trilinear, ns a fragment"];
    print("Texels of an upload", "texels", "texel", &further, &points.collect::<Vec<_>>());
}

fn units(options: &Options) {
    let points = (0..=8u32).map(|units| {
        let mut stage = stage(options, 1024);
        for unit in 0..units {
            stage.gl.active_texture(GL_TEXTURE0 + unit);
            stage.texture(Tex { min: GL_LINEAR, ..Tex::default() });
        }
        let cost = least(&mut stage, |stage| {
            stage.gl.begin(GL_QUADS);
            for [x, y] in [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
                for unit in 0..units {
                    // 0.4 to 0.5 texels a pixel, no two units alike.
                    let scale = 1.8 + 0.02 * unit as f32;
                    stage.gl.multi_tex_coord2f(GL_TEXTURE0 + unit, scale * x + 0.3 * y, scale * y - 0.3 * x);
                }
                stage.gl.vertex2f(1024.0 * x, 1024.0 * y);
            }
            stage.gl.end();
        });
        let cells = vec![format!("{:.2}", cost * 1e9 / 1024f64.powi(2))];
        Point { n: f64::from(units), cost, cells }
    });
    print("Units, LINEAR and MODULATE", "units", "unit", &["ns a fragment"], &points.collect::<Vec<_>>());
}

/// The eight corners of a cube of four pixels and its twelve triangles.
fn cube(stage: &mut Stage) {
    let side = |corner: usize, axis: usize| (corner >> axis & 1) as f32;
    let corner = |c| [4.0 * side(c, 0), 4.0 * side(c, 1), 0.5 * side(c, 2), 0.0, 0.0, 1.0, side(c, 0), side(c, 1)];
    stage.vertices = (0..8).map(corner).collect();
    let faces = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    stage.indices = faces.into_iter().flat_map(|[a, b, c, d]| [a, b, c, a, c, d]).collect();
    stage.bind_mesh(Arrays::Buffers);
}

fn draws(options: &Options) {
    let points = (1..=5).map(|power| 10u32.pow(power)).map(|n| {
        let mut stage = stage(options, 1024);
        let textures = [64, 32].map(|size| stage.texture(Tex { size, ..Tex::default() }));
        stage.depth(GL_LEQUAL);
        stage.gl.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        cube(&mut stage);
        let cost = least(&mut stage, |stage| {
            for i in 0..n {
                let gl = &mut stage.gl;
                gl.bind_texture(GL_TEXTURE_2D, textures[i as usize % 2]);
                if i % 2 == 0 {
                    gl.enable(GL_BLEND)
                } else {
                    gl.disable(GL_BLEND)
                }
                gl.color4f(1.0, (i % 7) as f32 / 7.0, 1.0, 0.5);
                gl.load_identity();
                gl.translatef((i % 250 * 4) as f32, (i / 250 % 250 * 4) as f32, 0.0);
                stage.mesh();
            }
        });
        Point { n: f64::from(n), cost, cells: Vec::new() }
    });
    print("Draws of 12 triangles, state changed before each", "draws", "draw", &[], &points.collect::<Vec<_>>());
}
