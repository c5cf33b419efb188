//! Pictures for the page: error against time as SVG with logarithmic axes, and pixels as PNG inside the page.

use super::run::{Outcome, Picture};
use std::fmt::Write as _;
use std::io::Cursor;

/// The colours of the libraries.
pub const COLORS: [&str; 2] = ["#1f5fa8", "#c2571a"];

const WIDTH: f64 = 620.0;
const HEIGHT: f64 = 380.0;
const LEFT: f64 = 56.0;
const BOTTOM: f64 = 44.0;
const TOP: f64 = 14.0;
const RIGHT: f64 = 16.0;

/// A logarithmic axis from one number to another, on paper from `start` to `end`.
struct Axis {
    low: f64,
    high: f64,
    start: f64,
    end: f64,
}

impl Axis {
    fn over(values: &[f64], start: f64, end: f64) -> Axis {
        let low = values.iter().copied().filter(|v| *v > 0.0).fold(f64::MAX, f64::min);
        let high = values.iter().copied().fold(0.0, f64::max);
        if low > high {
            return Axis { low: 1.0, high: 10.0, start, end };
        }
        let room = (high / low).powf(0.08).max(1.15);
        Axis { low: low / room, high: high * room, start, end }
    }

    fn at(&self, v: f64) -> f64 {
        let t = (v.max(self.low) / self.low).ln() / (self.high / self.low).ln();
        self.start + t * (self.end - self.start)
    }

    /// Round numbers on the axis.
    fn ticks(&self) -> Vec<f64> {
        let all = (-4..6).flat_map(|e| [1.0, 2.0, 5.0].map(|m| m * 10f64.powi(e)));
        all.filter(|v| *v >= self.low && *v <= self.high).collect()
    }
}

/// What HTML must not see as markup.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Places of labels that do not lie on each other: moves each down until it is free.
struct Labels(Vec<[f64; 3]>);

impl Labels {
    fn place(&mut self, x: f64, y: f64, width: f64) -> f64 {
        let mut at = y;
        for _ in 0..40 {
            let hit = |b: &[f64; 3]| (b[1] - at).abs() < 11.0 && x < b[0] + b[2] && b[0] < x + width;
            if !self.0.iter().any(hit) {
                break;
            }
            at += 4.0;
        }
        self.0.push([x, at, width]);
        at
    }
}

/// Error against time of a scene.
pub fn plot(o: &Outcome, names: &[&str]) -> String {
    let times: Vec<f64> = o.rows.iter().map(|r| r.ns).collect();
    let errors: Vec<f64> = o.rows.iter().map(|r| r.square.rmse).collect();
    let x = Axis::over(&times, LEFT, WIDTH - RIGHT);
    let y = Axis::over(&errors, HEIGHT - BOTTOM, TOP);
    let mut svg = format!("<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" aria-label=\"error against time\">");
    grid(&mut svg, &x, &y);
    for (library, color) in COLORS.iter().enumerate().take(names.len()) {
        let mut line: Vec<(f64, f64)> =
            o.rows.iter().filter(|r| r.library == library && r.front).map(|r| (r.ns, r.square.rmse)).collect();
        line.sort_by(|a, b| a.0.total_cmp(&b.0));
        let path: Vec<String> = line.iter().map(|(a, b)| format!("{:.1},{:.1}", x.at(*a), y.at(*b))).collect();
        let dash = if library == 0 { "" } else { " stroke-dasharray=\"5 4\"" };
        let _ = write!(
            svg,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"1.5\" opacity=\"0.6\"{dash}/>",
            path.join(" ")
        );
    }
    marks(&mut svg, o, names, &x, &y);
    svg.push_str("</svg>");
    svg
}

fn grid(svg: &mut String, x: &Axis, y: &Axis) {
    for v in x.ticks() {
        let p = x.at(v);
        let _ = write!(
            svg,
            "<line class=\"g\" x1=\"{p:.1}\" x2=\"{p:.1}\" y1=\"{TOP}\" y2=\"{0}\"/><text x=\"{p:.1}\" y=\"{1}\" \
             text-anchor=\"middle\">{v}</text>",
            HEIGHT - BOTTOM,
            HEIGHT - BOTTOM + 15.0
        );
    }
    for v in y.ticks() {
        let p = y.at(v);
        let _ = write!(
            svg,
            "<line class=\"g\" x1=\"{LEFT}\" x2=\"{0}\" y1=\"{p:.1}\" y2=\"{p:.1}\"/><text x=\"{1}\" y=\"{2:.1}\" \
             text-anchor=\"end\">{v}</text>",
            WIDTH - RIGHT,
            LEFT - 6.0,
            p + 4.0
        );
    }
    let _ = write!(
        svg,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" class=\"a\">ns a fragment</text><text transform=\"translate(14 \
         {}) rotate(-90)\" text-anchor=\"middle\" class=\"a\">E_samp, LSB rms</text>",
        (LEFT + WIDTH - RIGHT) / 2.0,
        HEIGHT - 8.0,
        (TOP + HEIGHT - BOTTOM) / 2.0
    );
}

fn marks(svg: &mut String, o: &Outcome, names: &[&str], x: &Axis, y: &Axis) {
    let mut labels = Labels(Vec::new());
    let mut rows: Vec<_> = o.rows.iter().collect();
    rows.sort_by(|a, b| b.square.rmse.total_cmp(&a.square.rmse));
    for r in rows {
        let (px, py, color) = (x.at(r.ns), y.at(r.square.rmse), COLORS[r.library.min(1)]);
        let fill = if r.front { color } else { "var(--paper)" };
        let shape = if r.library == 0 {
            format!("<circle cx=\"{px:.1}\" cy=\"{py:.1}\" r=\"4.5\"")
        } else {
            format!("<rect x=\"{:.1}\" y=\"{:.1}\" width=\"8\" height=\"8\"", px - 4.0, py - 4.0)
        };
        let title = format!("{}, {}: {:.2} ns, {:.2} LSB", names[r.library], r.knobs.name, r.ns, r.square.rmse);
        let _ = write!(
            svg,
            "{shape} fill=\"{fill}\" stroke=\"{color}\" stroke-width=\"1.5\"><title>{}</title></{}>",
            escape(&title),
            if r.library == 0 { "circle" } else { "rect" }
        );
        if r.library == 0 {
            let width = 5.6 * r.knobs.name.len() as f64;
            let right = px + 9.0 + width < WIDTH;
            let left_edge = if right { px + 8.0 } else { px - 8.0 - width };
            let ly = labels.place(left_edge, py + 4.0, width);
            let (lx, anchor) = if right { (px + 8.0, "start") } else { (px - 8.0, "end") };
            let weight = if r.front { " font-weight=\"600\"" } else { " opacity=\"0.65\"" };
            let _ = write!(
                svg,
                "<text x=\"{lx:.1}\" y=\"{ly:.1}\" text-anchor=\"{anchor}\" class=\"l\"{weight}>{}</text>",
                escape(r.knobs.name)
            );
        }
    }
}

/// The difference of two pictures, times `gain`.
pub fn difference(a: &Picture, b: &Picture, gain: u32) -> Picture {
    let channel = |p: u8, q: u8| (u32::from(p.abs_diff(q)) * gain).min(255) as u8;
    a.iter().zip(b).map(|(p, q)| [0, 1, 2, 3].map(|c| channel(p[c], q[c]))).collect()
}

/// An image element with the pixels in it; rows come from the bottom.
pub fn element(picture: &Picture, width: u32, caption: &str) -> String {
    let rows: Vec<&[[u8; 4]]> = picture.chunks(width as usize).rev().collect();
    let rgb: Vec<u8> = rows.iter().flat_map(|row| row.iter().flat_map(|c| [c[0], c[1], c[2]])).collect();
    let mut file = Cursor::new(Vec::new());
    let height = rows.len() as u32;
    let written = image::RgbImage::from_raw(width, height, rgb)
        .is_some_and(|picture| picture.write_to(&mut file, image::ImageFormat::Png).is_ok());
    let data = if written { base64(file.get_ref()) } else { String::new() };
    format!(
        "<figure><img width=\"{width}\" height=\"{height}\" alt=\"\" src=\"data:image/png;base64,{data}\"><figcaption>\
         {}</figcaption></figure>",
        escape(caption)
    )
}

/// Base 64 (RFC 4648).
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for three in bytes.chunks(3) {
        let bits = three.iter().fold(0u32, |b, v| b << 8 | u32::from(*v)) << (8 * (3 - three.len()));
        for i in 0..4 {
            let digit = DIGITS[(bits >> (18 - 6 * i) & 63) as usize];
            text.push(if i <= three.len() { digit as char } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_the_rfc() {
        let cases =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("fooba", "Zm9vYmE=")];
        for (plain, coded) in cases {
            assert_eq!(base64(plain.as_bytes()), coded);
        }
    }

    #[test]
    fn an_axis_is_logarithmic() {
        let axis = Axis { low: 1.0, high: 100.0, start: 0.0, end: 200.0 };
        assert!((axis.at(10.0) - 100.0).abs() < 1e-9);
        assert_eq!(axis.ticks(), [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0]);
    }

    #[test]
    fn labels_make_room() {
        let mut labels = Labels(Vec::new());
        let first = labels.place(0.0, 10.0, 50.0);
        assert!(labels.place(10.0, 12.0, 50.0) >= first + 11.0);
        assert_eq!(labels.place(200.0, 10.0, 50.0), 10.0);
    }
}
