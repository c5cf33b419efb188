//! What the command line of `view` asks for.

use crate::surroundings::Generation;
use std::path::PathBuf;

pub const USAGE: &str = "\
usage: view [MODEL.obj] [--texture IMAGE] [--gen reflection|sphere|object|eye] [-o OUT.png]
            [--angle DEGREES] [--tilt DEGREES] [--turntable N] [--size WIDTHxHEIGHT]

Draws an OBJ file with its materials and textures into a PNG. Without a file it draws a model of its own.

  --texture IMAGE   a PNG, JPEG, BMP or TGA in the place of the model's own textures
  --gen KIND        generated texture coordinates: the reflection of a sky, a sphere map, or a
                    pattern that sticks to the model (object) or to space (eye)
  --angle DEGREES   how far the model is turned around its upright axis (30)
  --tilt DEGREES    how far the camera looks down (15)
  --turntable N     N sides in one picture, from 1 to 36
  --size WxH        the size of a side in pixels (800x600)
  -o OUT.png        where to write (out/view.png)
";

/// The options.
pub struct Options {
    pub model: Option<PathBuf>,
    pub texture: Option<PathBuf>,
    pub generation: Option<Generation>,
    pub out: PathBuf,
    pub angle: f32,
    pub tilt: f32,
    pub turntable: u32,
    pub size: [u32; 2],
}

impl Options {
    /// How many columns and rows of sides the picture has.
    pub fn grid(&self) -> [u32; 2] {
        let columns = (1..).find(|n| n * n >= self.turntable).unwrap_or(1);
        [columns, self.turntable.div_ceil(columns)]
    }
}

/// Reads the arguments; the error says which of them is wrong.
pub fn parse(arguments: &mut dyn Iterator<Item = String>) -> Result<Options, String> {
    let mut options = Options {
        model: None,
        texture: None,
        generation: None,
        out: PathBuf::from("out/view.png"),
        angle: 30.0,
        tilt: 15.0,
        turntable: 1,
        size: [800, 600],
    };
    while let Some(argument) = arguments.next() {
        if !argument.starts_with('-') {
            if options.model.replace(PathBuf::from(&argument)).is_some() {
                return Err(format!("{argument}: only one model can be looked at; an image is given by --texture"));
            }
            continue;
        }
        if !["--texture", "--gen", "-o", "--angle", "--tilt", "--turntable", "--size"].contains(&argument.as_str()) {
            return Err(format!("{argument} is not an option"));
        }
        let value = arguments.next().ok_or_else(|| format!("{argument} needs a value"))?;
        let wrong = |what: &str| format!("{argument} {value}: {what}");
        let degrees =
            || value.parse::<f32>().ok().filter(|v| v.is_finite()).ok_or_else(|| wrong("not a number of degrees"));
        match argument.as_str() {
            "--texture" => options.texture = Some(PathBuf::from(value)),
            "--gen" => {
                let known = Generation::from_name(&value);
                options.generation = Some(known.ok_or_else(|| wrong("there is reflection, sphere, object, eye"))?);
            }
            "-o" => options.out = PathBuf::from(value),
            "--angle" => options.angle = degrees()?,
            "--tilt" => options.tilt = degrees()?,
            "--turntable" => {
                let sides = value.parse().ok().filter(|n| (1..=36).contains(n));
                options.turntable = sides.ok_or_else(|| wrong("a number of sides from 1 to 36"))?;
            }
            _ => {
                let sides = value.split_once('x').and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
                let sides = sides.filter(|s: &[u32; 2]| s.iter().all(|n| (1..=8192).contains(n)));
                options.size = sides.ok_or_else(|| wrong("write WIDTHxHEIGHT, each from 1 to 8192"))?;
            }
        }
    }
    if options.texture.is_some() && options.generation == Some(Generation::Reflection) {
        return Err("--gen reflection shows a sky of its own; for an image of yours take --gen sphere".into());
    }
    let [columns, rows] = options.grid();
    if columns * options.size[0] > 8192 || rows * options.size[1] > 8192 {
        return Err(format!("{columns} by {rows} sides of that size are more than 8192 pixels; give a smaller --size"));
    }
    Ok(options)
}
