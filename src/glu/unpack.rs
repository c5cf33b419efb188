//! The client's pixel store, read and set aside: GLU reads images under the unpack state of the program and hands its
//! own, tight ones to the GL (GLU 1.3, section 3.2: the state is as before afterwards).

use crate::context::Context;
use crate::enums::*;
use crate::state::pixel::PixelStore;

/// One direction of the pixel store by its names.
struct Names {
    swap_bytes: GLenum,
    lsb_first: GLenum,
    row_length: GLenum,
    image_height: GLenum,
    skip_rows: GLenum,
    skip_pixels: GLenum,
    skip_images: GLenum,
    alignment: GLenum,
}

const UNPACK: Names = Names {
    swap_bytes: GL_UNPACK_SWAP_BYTES,
    lsb_first: GL_UNPACK_LSB_FIRST,
    row_length: GL_UNPACK_ROW_LENGTH,
    image_height: GL_UNPACK_IMAGE_HEIGHT,
    skip_rows: GL_UNPACK_SKIP_ROWS,
    skip_pixels: GL_UNPACK_SKIP_PIXELS,
    skip_images: GL_UNPACK_SKIP_IMAGES,
    alignment: GL_UNPACK_ALIGNMENT,
};

const PACK: Names = Names {
    swap_bytes: GL_PACK_SWAP_BYTES,
    lsb_first: GL_PACK_LSB_FIRST,
    row_length: GL_PACK_ROW_LENGTH,
    image_height: GL_PACK_IMAGE_HEIGHT,
    skip_rows: GL_PACK_SKIP_ROWS,
    skip_pixels: GL_PACK_SKIP_PIXELS,
    skip_images: GL_PACK_SKIP_IMAGES,
    alignment: GL_PACK_ALIGNMENT,
};

#[track_caller]
fn read(cx: &mut Context, names: &Names) -> PixelStore {
    let mut number = |pname| {
        let mut value = [0];
        cx.get_integerv(pname, &mut value);
        value[0].max(0).unsigned_abs()
    };
    PixelStore {
        swap_bytes: number(names.swap_bytes) != 0,
        lsb_first: number(names.lsb_first) != 0,
        row_length: number(names.row_length),
        image_height: number(names.image_height),
        skip_rows: number(names.skip_rows),
        skip_pixels: number(names.skip_pixels),
        skip_images: number(names.skip_images),
        alignment: number(names.alignment).max(1),
    }
}

#[track_caller]
fn write_unpack(cx: &mut Context, store: &PixelStore) {
    cx.pixel_storei(UNPACK.swap_bytes, i32::from(store.swap_bytes));
    cx.pixel_storei(UNPACK.lsb_first, i32::from(store.lsb_first));
    cx.pixel_storei(UNPACK.row_length, store.row_length as i32);
    cx.pixel_storei(UNPACK.image_height, store.image_height as i32);
    cx.pixel_storei(UNPACK.skip_rows, store.skip_rows as i32);
    cx.pixel_storei(UNPACK.skip_pixels, store.skip_pixels as i32);
    cx.pixel_storei(UNPACK.skip_images, store.skip_images as i32);
    cx.pixel_storei(UNPACK.alignment, store.alignment as i32);
}

/// How the program lays out what it hands over.
#[track_caller]
pub(super) fn unpack_store(cx: &mut Context) -> PixelStore {
    read(cx, &UNPACK)
}

/// How the program wants what it gets back.
#[track_caller]
pub(super) fn pack_store(cx: &mut Context) -> PixelStore {
    read(cx, &PACK)
}

/// Runs `f` with rows of images that follow each other without a gap.
#[track_caller]
pub(super) fn tight_unpack(cx: &mut Context, f: impl FnOnce(&mut Context)) {
    let store = unpack_store(cx);
    write_unpack(cx, &PixelStore::TIGHT);
    f(cx);
    write_unpack(cx, &store);
}
