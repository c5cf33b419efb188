//! The client's pixel store, read and set aside: GLU reads images under the unpack state of the program and hands its
//! own, tight ones to the GL (GLU 1.3, section 3.2: the state is as before afterwards).

use crate::context::Context;
use crate::enums::*;
use crate::state::pixel::PixelStore;

/// One direction of the pixel store by its names, in the order of the fields of [`PixelStore`].
type Names = [GLenum; 8];

const UNPACK: Names = [
    GL_UNPACK_SWAP_BYTES,
    GL_UNPACK_LSB_FIRST,
    GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_IMAGE_HEIGHT,
    GL_UNPACK_SKIP_ROWS,
    GL_UNPACK_SKIP_PIXELS,
    GL_UNPACK_SKIP_IMAGES,
    GL_UNPACK_ALIGNMENT,
];

const PACK: Names = [
    GL_PACK_SWAP_BYTES,
    GL_PACK_LSB_FIRST,
    GL_PACK_ROW_LENGTH,
    GL_PACK_IMAGE_HEIGHT,
    GL_PACK_SKIP_ROWS,
    GL_PACK_SKIP_PIXELS,
    GL_PACK_SKIP_IMAGES,
    GL_PACK_ALIGNMENT,
];

#[track_caller]
fn read(cx: &mut Context, names: &Names) -> PixelStore {
    let numbers = names.map(|pname| {
        let mut value = [0];
        cx.get_integerv(pname, &mut value);
        value[0].max(0).unsigned_abs()
    });
    let [swap, lsb, row_length, image_height, skip_rows, skip_pixels, skip_images, alignment] = numbers;
    PixelStore {
        swap_bytes: swap != 0,
        lsb_first: lsb != 0,
        row_length,
        image_height,
        skip_rows,
        skip_pixels,
        skip_images,
        alignment: alignment.max(1),
    }
}

/// Changes the unpack state from what it is to what it shall be: only what differs.
#[track_caller]
fn change_unpack(cx: &mut Context, from: &PixelStore, to: &PixelStore) {
    let fields = |s: &PixelStore| {
        [
            u32::from(s.swap_bytes),
            u32::from(s.lsb_first),
            s.row_length,
            s.image_height,
            s.skip_rows,
            s.skip_pixels,
            s.skip_images,
            s.alignment,
        ]
    };
    for ((name, old), new) in UNPACK.into_iter().zip(fields(from)).zip(fields(to)) {
        if old != new {
            cx.pixel_storei(name, new as i32);
        }
    }
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

/// Runs `f` while rows of images follow each other without a gap; `store` is the state to come back to.
#[track_caller]
pub(super) fn tight_unpack<T>(cx: &mut Context, store: &PixelStore, f: impl FnOnce(&mut Context) -> T) -> T {
    change_unpack(cx, store, &PixelStore::TIGHT);
    let result = f(cx);
    change_unpack(cx, &PixelStore::TIGHT, store);
    result
}
