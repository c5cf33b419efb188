//! Quadrics: spheres, cylinders (and cones), disks and parts of disks (GLU 1.3, chapter 6).
//!
//! A [`Quadric`] only keeps how its surfaces are to look; each surface is a row of numbers for the code that draws
//! surfaces of revolution. Texture coordinates are those of the original GLU: around a sphere or cylinder s runs from 1 at +y over
//! 0.75 at +x down to 0, so that an image is not mirrored when seen from outside; a disk cuts its circle out of the image.

use super::constants::*;
use super::revolution::{Look, Mapping, QuadricSink, Revolution, Ring, Shape};
use crate::context::Context;
use crate::enums::*;
use crate::num::sin_cos_deg;

/// More slices, stacks or loops than this count as this many: no image could show more.
const MOST: i32 = 1024;

/// The function that is told of errors (`gluQuadricCallback`).
pub type ErrorCallback = fn(GLenum);

/// How quadric surfaces are drawn: filled, with smooth outward normals and without texture coordinates at first.
#[derive(Clone, Debug)]
pub struct Quadric {
    style: GLenum,
    normals: GLenum,
    orientation: GLenum,
    texture: bool,
    callback: Option<ErrorCallback>,
    error: Option<GLenum>,
}

impl Default for Quadric {
    fn default() -> Self {
        Self {
            style: GLU_FILL,
            normals: GLU_SMOOTH,
            orientation: GLU_OUTSIDE,
            texture: false,
            callback: None,
            error: None,
        }
    }
}

impl Quadric {
    /// A quadric with the initial values (`gluNewQuadric`).
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the style: `GLU_POINT`, `GLU_LINE`, `GLU_SILHOUETTE` or `GLU_FILL` (`gluQuadricDrawStyle`).
    pub fn draw_style(&mut self, style: GLenum) {
        match style {
            GLU_POINT | GLU_LINE | GLU_SILHOUETTE | GLU_FILL => self.style = style,
            _ => self.report(GLU_INVALID_ENUM),
        }
    }

    /// Sets the normals: `GLU_NONE`, `GLU_FLAT` or `GLU_SMOOTH` (`gluQuadricNormals`).
    pub fn normals(&mut self, normals: GLenum) {
        match normals {
            GLU_NONE | GLU_FLAT | GLU_SMOOTH => self.normals = normals,
            _ => self.report(GLU_INVALID_ENUM),
        }
    }

    /// Sets which side the normals and front faces are on: `GLU_OUTSIDE` or `GLU_INSIDE` (`gluQuadricOrientation`).
    pub fn orientation(&mut self, orientation: GLenum) {
        match orientation {
            GLU_OUTSIDE | GLU_INSIDE => self.orientation = orientation,
            _ => self.report(GLU_INVALID_ENUM),
        }
    }

    /// Sets whether texture coordinates are sent (`gluQuadricTexture`).
    pub fn texture(&mut self, texture: bool) {
        self.texture = texture;
    }

    /// Sets the function that is told of errors (`gluQuadricCallback` with `GLU_ERROR`).
    pub fn callback(&mut self, which: GLenum, callback: Option<ErrorCallback>) {
        match which {
            GLU_ERROR => self.callback = callback,
            _ => self.report(GLU_INVALID_ENUM),
        }
    }

    /// The first error since the last call of this method.
    pub fn take_error(&mut self) -> Option<GLenum> {
        self.error.take()
    }

    /// Draws a sphere around the origin, its poles on the z axis (`gluSphere`). t is 0 at -z and 1 at +z.
    #[track_caller]
    pub fn sphere(&mut self, cx: &mut Context, radius: f64, slices: i32, stacks: i32) {
        let result = sphere(self.look(), radius, slices, stacks, cx);
        self.note(result);
    }

    /// Draws the side of a cylinder or cone from z = 0 to `height` (`gluCylinder`). t is 0 at the base and 1 at the top.
    #[track_caller]
    pub fn cylinder(&mut self, cx: &mut Context, base: f64, top: f64, height: f64, slices: i32, stacks: i32) {
        let result = cylinder(self.look(), [base, top], height, slices, stacks, cx);
        self.note(result);
    }

    /// Draws a disk in the plane z = 0 with a hole of radius `inner` (`gluDisk`).
    #[track_caller]
    pub fn disk(&mut self, cx: &mut Context, inner: f64, outer: f64, slices: i32, loops: i32) {
        self.partial_disk(cx, inner, outer, slices, loops, 0.0, 360.0);
    }

    /// Draws the part of a disk from `start` over `sweep` degrees, counted from +y towards +x (`gluPartialDisk`).
    #[track_caller]
    #[expect(clippy::too_many_arguments, reason = "the arguments of gluPartialDisk")]
    pub fn partial_disk(
        &mut self,
        cx: &mut Context,
        inner: f64,
        outer: f64,
        slices: i32,
        loops: i32,
        start: f64,
        sweep: f64,
    ) {
        let result = partial_disk(self.look(), [inner, outer], slices, loops, [start, sweep], cx);
        self.note(result);
    }

    fn look(&self) -> Look {
        Look { style: self.style, normals: self.normals, inside: self.orientation == GLU_INSIDE, texture: self.texture }
    }

    fn note(&mut self, result: Result<(), GLenum>) {
        if let Err(error) = result {
            self.report(error);
        }
    }

    fn report(&mut self, error: GLenum) {
        self.error = self.error.or(Some(error));
        if let Some(callback) = self.callback {
            callback(error);
        }
    }
}

/// The numbers of slices and bands, if there are enough of both.
fn counts(slices: i32, bands: i32) -> Result<(u32, u32), GLenum> {
    if slices < 2 || bands < 1 {
        return Err(GLU_INVALID_VALUE);
    }
    Ok((slices.min(MOST) as u32, bands.min(MOST) as u32))
}

/// An error unless all of the numbers are 0 or more; NaN is less than that.
fn not_negative(numbers: &[f64]) -> Result<(), GLenum> {
    if numbers.iter().all(|n| *n >= 0.0) { Ok(()) } else { Err(GLU_INVALID_VALUE) }
}

fn sphere(look: Look, radius: f64, slices: i32, stacks: i32, sink: &mut impl QuadricSink) -> Result<(), GLenum> {
    let (slices, bands) = counts(slices, stacks)?;
    not_negative(&[radius])?;
    // Ring 0 is the pole at -z: then the pair (ring j, ring j+1) faces outward.
    let ring = |j: f64| {
        let (sin, cos) = sin_cos_deg(180.0 * j / f64::from(bands));
        Ring { radius: radius * sin, z: -radius * cos, normal: [sin, -cos] }
    };
    let (start, sweep, mapping) = (0.0, 360.0, Mapping::Around);
    Revolution { ring, bands, slices, start, sweep, mapping, shape: Shape::Ball }.draw(look, sink);
    Ok(())
}

fn cylinder(
    look: Look,
    [base, top]: [f64; 2],
    height: f64,
    slices: i32,
    stacks: i32,
    sink: &mut impl QuadricSink,
) -> Result<(), GLenum> {
    let (slices, bands) = counts(slices, stacks)?;
    not_negative(&[base, top, height])?;
    let lean = base - top;
    let length = (lean * lean + height * height).sqrt();
    if length == 0.0 {
        return Err(GLU_INVALID_VALUE);
    }
    let ring = |j: f64| {
        let t = j / f64::from(bands);
        Ring { radius: base - lean * t, z: height * t, normal: [height / length, lean / length] }
    };
    let (start, sweep, mapping) = (0.0, 360.0, Mapping::Around);
    Revolution { ring, bands, slices, start, sweep, mapping, shape: Shape::Tube }.draw(look, sink);
    Ok(())
}

fn partial_disk(
    look: Look,
    [inner, outer]: [f64; 2],
    slices: i32,
    loops: i32,
    [start, sweep]: [f64; 2],
    sink: &mut impl QuadricSink,
) -> Result<(), GLenum> {
    let (slices, bands) = counts(slices, loops)?;
    not_negative(&[inner, outer - inner])?;
    if outer <= 0.0 || !start.is_finite() || sweep.is_nan() {
        return Err(GLU_INVALID_VALUE);
    }
    // A part that is swept backwards is the part that begins at its end.
    let sweep = sweep.clamp(-360.0, 360.0);
    let (start, sweep) = if sweep < 0.0 { (start + sweep, -sweep) } else { (start, sweep) };
    let ring = |j: f64| {
        let radius = outer - (outer - inner) * j / f64::from(bands);
        Ring { radius, z: 0.0, normal: [0.0, 1.0] }
    };
    let shape = if inner == 0.0 { Shape::Disk } else { Shape::Ring };
    let mapping = Mapping::Flat(outer);
    Revolution { ring, bands, slices, start, sweep, mapping, shape }.draw(look, sink);
    Ok(())
}

impl QuadricSink for Context {
    fn begin(&mut self, mode: GLenum) {
        Context::begin(self, mode);
    }
    fn end(&mut self) {
        Context::end(self);
    }
    fn normal(&mut self, [x, y, z]: [f64; 3]) {
        self.normal3f(x as f32, y as f32, z as f32);
    }
    fn tex_coord(&mut self, [s, t]: [f64; 2]) {
        self.tex_coord2f(s as f32, t as f32);
    }
    fn vertex(&mut self, [x, y, z]: [f64; 3]) {
        self.vertex3f(x as f32, y as f32, z as f32);
    }
}

#[cfg(test)]
mod tests;
