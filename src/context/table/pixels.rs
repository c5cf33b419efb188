//! Chapter of the table: pixel rectangles and bitmaps (OpenGL 1.5, sections 3.6, 3.7 and 4.3). Images are read under the
//! unpack state and written under the pack state; a display list keeps an image as it was when it was compiled.

macro_rules! pixels_table { ($generate:ident) => { $generate! {
    title "Pixels (sections 3.6, 4.3)";
    canonical {
        list PixelTransfer pixel_transfer(pname: enum, params: params);
        list PixelMap pixel_map(map: enum, mapsize: i32, values: (upto f32:));
    }
    commands {
        /// Draws a rectangle of pixels at the raster position (section 3.6.4).
        list glDrawPixels draw_pixels(width: i32, height: i32, format: enum, type_: enum,
            pixels: (rect [width, height], format, type_));
        /// Draws a bitmap at the raster position and moves the position (section 3.7).
        list glBitmap bitmap(width: i32, height: i32, xorig: f32, yorig: f32, xmove: f32, ymove: f32,
            bitmap: (rect [width, height], GL_COLOR_INDEX, GL_BITMAP));
        /// Copies pixels of the read buffer to the raster position (section 4.3.3).
        list glCopyPixels copy_pixels(x: i32, y: i32, width: i32, height: i32, type_: enum);
        /// Sets the zoom of pixel rectangles (section 3.6.5).
        list glPixelZoom pixel_zoom(xfactor: f32, yfactor: f32);
        /// Selects the buffer that pixels are read from (section 4.3.2).
        list glReadBuffer read_buffer(mode: enum);
    }
    forms {
        family "Sets scale, bias, shift, offset or mapping of pixel transfer (section 3.6.3)." {
            list glPixelTransferi pixel_transferi(pname: enum, param: i32) => pixel_transfer(pname, &Params::int(param));
            list glPixelTransferf pixel_transferf(pname: enum, param: f32) => pixel_transfer(pname, &Params::float(param));
        }
        family "Sets a table of pixel transfer (section 3.6.3). `INVALID_VALUE` for sizes that are not positive, too large or, for index maps, no power of two." {
            list glPixelMapfv pixel_mapfv(map: enum, mapsize: i32, values: (upto f32: pixel_map(mapsize)))
                => pixel_map(map, mapsize, values);
            list glPixelMapuiv pixel_mapuiv(map: enum, mapsize: i32, values: (upto u32: pixel_map(mapsize)))
                => pixel_map(map, mapsize, &map_of(map, values));
            list glPixelMapusv pixel_mapusv(map: enum, mapsize: i32, values: (upto u16: pixel_map(mapsize)))
                => pixel_map(map, mapsize, &map_of(map, values));
        }
    }
    context {}
    now {
        /// Reads pixels of the read buffer under the pack state (section 4.3.2).
        #[doc = include_str!("examples/read_pixels.md")]
        now glReadPixels read_pixels(x: i32, y: i32, width: i32, height: i32, format: enum, type_: enum,
            pixels: (rect_out [width, height], format, type_));
    }
    queries {
        family "A table of pixel transfer (section 6.1.3)." {
            glGetPixelMapfv get_pixel_mapfv(map: enum) -> f32 => get_pixel_map(map);
            glGetPixelMapuiv get_pixel_mapuiv(map: enum) -> u32 => get_pixel_map(map);
            glGetPixelMapusv get_pixel_mapusv(map: enum) -> u16 => get_pixel_map(map);
        }
    }
    answers {
        get_pixel_map(map: enum);
    }
    manual {}
} } }

pub(crate) use pixels_table;
