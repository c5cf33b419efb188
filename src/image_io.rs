//! Image files and GL (cargo feature `image`): a texture from a decoded image, the framebuffer as an image.
//!
//! The one thing that goes wrong between the two is the order of rows: GL's first row is the lowest, an image file's is
//! the highest. A [`Picture`] holds its rows as GL wants them, so that t = 0 is the lower edge of what an image viewer
//! shows, and everything that leaves GL here is turned back.
//!
//! ```no_run
//! use fixedgl::{Context, image_io};
//! # fn main() -> Result<(), fixedgl::FileError> {
//! let mut cx = Context::new(640, 480);
//! let picture = image_io::Picture::open("brick.png")?;
//! picture.build_mipmaps(&mut cx, fixedgl::enums::GL_TEXTURE_2D);
//! // ... draw ...
//! image_io::save_png(&mut cx, "picture.png")
//! # }
//! ```

use crate::context::{Context, Pixels};
use crate::enums::*;
use crate::error::FileError;
use crate::glu;
use image::{DynamicImage, ImageDecoder, ImageReader, RgbImage, RgbaImage};
use std::borrow::Cow;
use std::path::Path;

/// What can be read.
const READ: &str = "PNG, JPEG, BMP and TGA";

/// A decoded image as `TexImage2D` takes it: rows from the bottom up, without padding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    width: u32,
    height: u32,
    format: GLenum,
    type_: GLenum,
    bytes: Vec<u8>,
}

impl Picture {
    /// Reads a PNG, JPEG, BMP or TGA file; what it is is told by its content, and only of a TGA by its name. A photo is
    /// turned as a viewer shows it (the orientation of its EXIF data).
    ///
    /// # Errors
    /// A file that cannot be read, is no image of these kinds, or needs more memory than the decoder allows.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, FileError> {
        let path = path.as_ref();
        let failed = |what: &str, e: &dyn std::fmt::Display| FileError::new(path, format!("{what}: {e}"));
        let reader = ImageReader::open(path)
            .and_then(ImageReader::with_guessed_format)
            .map_err(|e| failed("cannot be read", &e))?;
        if let Some(format) = reader.format().filter(|format| !format.reading_enabled()) {
            let name = format.extensions_str().first().unwrap_or(&"").to_uppercase();
            return Err(FileError::new(path, format!("is a {name} image, which is not read; there is {READ}")));
        }
        let decoded = reader.into_decoder().and_then(|mut decoder| {
            let orientation = decoder.orientation()?;
            let mut image = DynamicImage::from_decoder(decoder)?;
            image.apply_orientation(orientation);
            Ok(image)
        });
        match decoded {
            Ok(image) => Ok(Self::from_image(&image)),
            Err(e) => Err(failed(&format!("is not an image that can be decoded ({READ})"), &e)),
        }
    }

    /// The picture of a decoded image. Gray, gray with alpha, RGB and RGBA keep their components, 16 bits stay 16 bits
    /// (an image of floats becomes one of 16 bits).
    #[must_use]
    pub fn from_image(image: &DynamicImage) -> Self {
        let flat = |shorts: &[u16]| shorts.iter().flat_map(|s| s.to_ne_bytes()).collect::<Vec<u8>>();
        let (format, type_, bytes) = match image {
            DynamicImage::ImageLuma8(i) => (GL_LUMINANCE, GL_UNSIGNED_BYTE, i.as_raw().clone()),
            DynamicImage::ImageLumaA8(i) => (GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, i.as_raw().clone()),
            DynamicImage::ImageRgb8(i) => (GL_RGB, GL_UNSIGNED_BYTE, i.as_raw().clone()),
            DynamicImage::ImageRgba8(i) => (GL_RGBA, GL_UNSIGNED_BYTE, i.as_raw().clone()),
            DynamicImage::ImageLuma16(i) => (GL_LUMINANCE, GL_UNSIGNED_SHORT, flat(i.as_raw())),
            DynamicImage::ImageLumaA16(i) => (GL_LUMINANCE_ALPHA, GL_UNSIGNED_SHORT, flat(i.as_raw())),
            DynamicImage::ImageRgb16(i) => (GL_RGB, GL_UNSIGNED_SHORT, flat(i.as_raw())),
            other => (GL_RGBA, GL_UNSIGNED_SHORT, flat(other.to_rgba16().as_raw())),
        };
        Self { width: image.width(), height: image.height(), format, type_, bytes }.flipped()
    }

    /// The picture with its rows in the other order. The faces of cube maps are stored from the top down, so a face
    /// from an image file is turned once more.
    #[must_use]
    pub fn flipped(mut self) -> Self {
        let row = self.bytes.len() / (self.height as usize).max(1);
        let mut rows: Vec<u8> = Vec::with_capacity(self.bytes.len());
        for r in self.bytes.chunks_exact(row.max(1)).rev() {
            rows.extend_from_slice(r);
        }
        self.bytes = rows;
        self
    }

    /// The width in texels.
    #[must_use]
    pub fn width(&self) -> i32 {
        i32::try_from(self.width).unwrap_or(i32::MAX)
    }

    /// The height in texels.
    #[must_use]
    pub fn height(&self) -> i32 {
        i32::try_from(self.height).unwrap_or(i32::MAX)
    }

    /// The pixel format: `GL_LUMINANCE`, `GL_LUMINANCE_ALPHA`, `GL_RGB` or `GL_RGBA`.
    #[must_use]
    pub fn format(&self) -> GLenum {
        self.format
    }

    /// The pixel type: `GL_UNSIGNED_BYTE` or `GL_UNSIGNED_SHORT`.
    #[must_use]
    pub fn type_(&self) -> GLenum {
        self.type_
    }

    /// The internal format that keeps every bit.
    #[must_use]
    pub fn internal_format(&self) -> GLenum {
        match (self.format, self.type_) {
            (GL_LUMINANCE, GL_UNSIGNED_BYTE) => GL_LUMINANCE8,
            (GL_LUMINANCE, _) => GL_LUMINANCE16,
            (GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE) => GL_LUMINANCE8_ALPHA8,
            (GL_LUMINANCE_ALPHA, _) => GL_LUMINANCE16_ALPHA16,
            (GL_RGB, GL_UNSIGNED_BYTE) => GL_RGB8,
            (GL_RGB, _) => GL_RGB16,
            (_, GL_UNSIGNED_BYTE) => GL_RGBA8,
            _ => GL_RGBA16,
        }
    }

    /// The rows, from the bottom up, in the machine's byte order: what a pixel argument takes with an alignment of 1.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Loads the picture as one level of a 2D texture (`glTexImage2D`), whatever the unpack state is.
    #[track_caller]
    pub fn tex_image_2d(&self, cx: &mut Context, target: GLenum, level: i32) {
        self.with_tight_rows(cx, |cx, pixels| {
            let (w, h) = (self.width(), self.height());
            cx.tex_image_2d(target, level, self.internal_format(), w, h, 0, self.format, self.type_, pixels);
        });
    }

    /// Loads the picture and all its mipmap levels (`gluBuild2DMipmaps`, which makes the sizes powers of two), whatever
    /// the unpack state is. 0 or a code of GLU.
    #[track_caller]
    pub fn build_mipmaps(&self, cx: &mut Context, target: GLenum) -> i32 {
        let (w, h) = (self.width(), self.height());
        self.with_tight_rows(cx, |cx, pixels| {
            glu::build_2d_mipmaps(cx, target, self.internal_format(), w, h, self.format, self.type_, pixels)
        })
    }

    /// Calls `f` while the unpack state is that of the picture.
    fn with_tight_rows<T>(&self, cx: &mut Context, f: impl FnOnce(&mut Context, Pixels<'_>) -> T) -> T {
        cx.with_tight_rows(|cx| f(cx, Pixels::Bytes(Cow::Borrowed(&self.bytes))))
    }
}

/// The framebuffer as an image with its first row at the top. Finishes what was drawn first. An image without pixels, and
/// `GL_OUT_OF_MEMORY` is recorded, where there is no memory for it.
#[must_use]
#[track_caller]
pub fn framebuffer(cx: &mut Context) -> RgbaImage {
    let (width, height) = cx.size();
    let mut bytes = cx.pixels();
    turn_rows(&mut bytes, width as usize * 4);
    RgbaImage::from_raw(width, height, bytes).unwrap_or_default()
}

/// Puts rows in the other order, in place.
fn turn_rows(bytes: &mut [u8], row: usize) {
    let rows = bytes.len() / row.max(1);
    let (upper, lower) = bytes.split_at_mut(row * (rows / 2));
    for (a, b) in upper.chunks_exact_mut(row.max(1)).zip(lower.rchunks_exact_mut(row.max(1))) {
        a.swap_with_slice(b);
    }
}

/// Writes the framebuffer as a PNG file without its alpha, which in GL is seldom an opacity. Finishes what was drawn
/// first.
///
/// # Errors
/// A file that cannot be written to its last byte, or no memory for the picture.
#[track_caller]
pub fn save_png(cx: &mut Context, path: impl AsRef<Path>) -> Result<(), FileError> {
    let path = path.as_ref();
    let failed = |e: &dyn std::fmt::Display| FileError::new(path, format!("cannot be written: {e}"));
    let (width, height) = cx.size();
    let mut bytes = cx.pixels();
    if bytes.len() != width as usize * height as usize * 4 {
        return Err(failed(&"no memory for the picture"));
    }
    turn_rows(&mut bytes, width as usize * 4);
    // In place: three bytes of each four.
    let pixels = bytes.len() / 4;
    for pixel in 0..pixels {
        bytes.copy_within(4 * pixel..4 * pixel + 3, 3 * pixel);
    }
    bytes.truncate(3 * pixels);
    let opaque = RgbImage::from_raw(width, height, bytes).ok_or_else(|| failed(&"no pixels"))?;
    // A writer that is buffered loses what its last flush says, so the file is made here and written in one piece.
    let mut file = std::io::Cursor::new(Vec::new());
    opaque.write_to(&mut file, image::ImageFormat::Png).map_err(|e| failed(&e))?;
    std::fs::write(path, file.into_inner()).map_err(|e| failed(&e))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Red above, green below; blue is the column.
    fn two_rows() -> DynamicImage {
        DynamicImage::ImageRgb8(
            RgbImage::from_raw(2, 2, vec![255, 0, 0, 255, 0, 10, 0, 255, 0, 0, 255, 10]).expect("four pixels"),
        )
    }

    #[test]
    fn the_lowest_row_comes_first() {
        let picture = Picture::from_image(&two_rows());
        assert_eq!((picture.width(), picture.height(), picture.format()), (2, 2, GL_RGB));
        assert_eq!(picture.bytes(), [0, 255, 0, 0, 255, 10, 255, 0, 0, 255, 0, 10]);
        assert_eq!(picture.clone().flipped().bytes()[..3], [255, 0, 0]);
    }

    #[test]
    fn a_texture_is_the_image_whatever_the_unpack_state() {
        let mut cx = Context::new(4, 4);
        cx.pixel_storei(GL_UNPACK_ALIGNMENT, 8);
        cx.pixel_storei(GL_UNPACK_ROW_LENGTH, 77);
        cx.pixel_storei(GL_PACK_ALIGNMENT, 1);
        let picture = Picture::from_image(&two_rows());
        picture.tex_image_2d(&mut cx, GL_TEXTURE_2D, 0);
        let mut back = [0u8; 12];
        cx.get_tex_image(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, &mut back);
        assert_eq!(back, picture.bytes());
        assert_eq!(picture.build_mipmaps(&mut cx, GL_TEXTURE_2D), 0);
        let mut mean = [0u8; 3];
        cx.get_tex_image(GL_TEXTURE_2D, 1, GL_RGB, GL_UNSIGNED_BYTE, &mut mean);
        assert_eq!(mean, [128, 128, 5]);
        let mut length = [0];
        cx.get_integerv(GL_UNPACK_ROW_LENGTH, &mut length);
        assert_eq!(length, [77]);
        cx.check().expect("no error");
    }

    #[test]
    fn sixteen_bits_and_alpha_are_kept() {
        let gray = image::ImageBuffer::from_raw(1, 2, vec![0x1234u16, 0xffff]).expect("two pixels");
        let picture = Picture::from_image(&DynamicImage::ImageLuma16(gray));
        assert_eq!((picture.format(), picture.type_()), (GL_LUMINANCE, GL_UNSIGNED_SHORT));
        assert_eq!(picture.internal_format(), GL_LUMINANCE16);
        assert_eq!(picture.bytes(), [0xffffu16.to_ne_bytes(), 0x1234u16.to_ne_bytes()].concat());
        let image = RgbaImage::from_raw(1, 1, vec![1, 2, 3, 4]).expect("a pixel");
        let picture = Picture::from_image(&DynamicImage::ImageRgba8(image));
        assert_eq!((picture.format(), picture.bytes()), (GL_RGBA, &[1u8, 2, 3, 4][..]));
    }

    #[test]
    fn the_framebuffer_is_turned_back_and_saved() {
        let mut cx = Context::new(3, 2);
        cx.enable(GL_SCISSOR_TEST);
        cx.scissor(0, 1, 3, 1);
        cx.clear_color(1.0, 0.0, 0.0, 0.0);
        cx.clear(GL_COLOR_BUFFER_BIT);
        let image = framebuffer(&mut cx);
        assert_eq!(image.get_pixel(0, 0).0, [255, 0, 0, 0], "the upper row was cleared to red");
        assert_eq!(image.get_pixel(0, 1).0[0], 0);
        let path = std::env::temp_dir().join(format!("fixedgl-{}.png", std::process::id()));
        save_png(&mut cx, &path).expect("written");
        let picture = Picture::open(&path).expect("read");
        std::fs::remove_file(&path).expect("removed");
        assert_eq!((picture.width(), picture.height(), picture.format()), (3, 2, GL_RGB));
        assert_eq!(picture.bytes()[9..12], [255, 0, 0]);
    }

    /// A file of this test with a content, as a picture.
    fn opened(name: &str, content: &[u8]) -> Result<Picture, FileError> {
        let path = std::env::temp_dir().join(format!("fixedgl-{}-{name}", std::process::id()));
        std::fs::write(&path, content).expect("written");
        let picture = Picture::open(&path);
        std::fs::remove_file(&path).expect("removed");
        picture
    }

    #[test]
    fn a_photo_is_turned_as_its_exif_data_say() {
        // EXIF 2.3, tag 0112: on which side of what is shown the first row and the first column of the file lie.
        let sides = [
            ("top", "left"),
            ("top", "right"),
            ("bottom", "right"),
            ("bottom", "left"),
            ("left", "top"),
            ("right", "top"),
            ("right", "bottom"),
            ("left", "bottom"),
        ];
        // Quarters of 8 pixels, in gray: first row 0 and 80, second row 160 and 240.
        let file = image::GrayImage::from_fn(16, 16, |x, y| image::Luma([(x / 8 * 80 + y / 8 * 160) as u8]));
        let mut jpeg = Vec::new();
        image::codecs::jpeg::JpegEncoder::new_with_quality(&mut jpeg, 100).encode_image(&file).expect("encoded");
        for (i, (row, column)) in sides.into_iter().enumerate() {
            let exif = [
                &b"\xff\xe1\x00\x22Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0"[..],
                &[i as u8 + 1],
                &[0; 6],
            ];
            let content = [&jpeg[..2], &exif.concat(), &jpeg[2..]].concat();
            let picture = opened(&format!("{i}.jpg"), &content).expect("a photo");
            // The quarter of the file that is shown at the left or right, at the top or bottom.
            for (x, shown_x) in [(0, "left"), (15, "right")] {
                for (y, shown_y) in [(15, "top"), (0, "bottom")] {
                    let first_row = row == shown_x || row == shown_y;
                    let first_column = column == shown_x || column == shown_y;
                    let expected = u8::from(!first_column) * 80 + u8::from(!first_row) * 160;
                    let shown = picture.bytes()[y * 16 + x];
                    assert!(shown.abs_diff(expected) <= 2, "orientation {}: {shown} for {expected}", i + 1);
                }
            }
        }
    }

    #[test]
    fn bmp_and_tga_files_are_read() {
        // Two pixels: red on the left, (0, 10, 255) on the right. Both formats store blue, green, red.
        let mut bmp = b"BM\x3e\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x02\0\0\0\x01\0\0\0\x01\0\x18\0".to_vec();
        bmp.extend([0; 24]);
        bmp.extend([0, 0, 255, 255, 10, 0, 0, 0]);
        let mut tga = vec![0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 24, 0];
        tga.extend([0, 0, 255, 255, 10, 0]);
        for (name, content) in [("two.bmp", bmp), ("two.tga", tga)] {
            let picture = opened(name, &content).expect(name);
            assert_eq!((picture.width(), picture.height(), picture.format()), (2, 1, GL_RGB), "{name}");
            assert_eq!(picture.bytes(), [255, 0, 0, 0, 10, 255], "{name}");
        }
        let gif = opened("x.gif", b"GIF89a\x01\0\x01\0\0\0\0;").expect_err("an error");
        assert_eq!(gif.message, "is a GIF image, which is not read; there is PNG, JPEG, BMP and TGA");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_an_error() {
        // Small pictures fit into every buffer between here and the disk.
        let full = save_png(&mut Context::new(4, 4), "/dev/full").expect_err("an error");
        assert!(full.to_string().starts_with("/dev/full: cannot be written: "), "{full}");
    }

    #[test]
    fn files_that_are_no_images_say_so() {
        let missing = Picture::open("no/such/file.png").expect_err("an error");
        assert!(missing.to_string().starts_with("no/such/file.png: cannot be read: "), "{missing}");
        let path = std::env::temp_dir().join(format!("fixedgl-broken-{}.png", std::process::id()));
        for content in [&b""[..], b"hello", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"] {
            std::fs::write(&path, content).expect("written");
            let broken = Picture::open(&path).expect_err("an error");
            assert!(broken.message.starts_with("is not an image that can be decoded"), "{broken}");
        }
        std::fs::remove_file(&path).expect("removed");
        let unwritable = save_png(&mut Context::new(1, 1), "no/such/folder/x.png").expect_err("an error");
        assert!(unwritable.to_string().contains("cannot be written"), "{unwritable}");
    }
}
