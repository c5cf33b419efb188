//! Chapter of the table: Begin, End and everything that may stand between them to make vertices (OpenGL 1.5, sections
//! 2.6, 2.7, 2.12; 2.10 for Rect): every typed form becomes one canonical command with a float vector. Integer colours
//! and normals are mapped by table 2.6; coordinates that a form leaves out are (0, 0, 1).

macro_rules! vertex_table { ($generate:ident) => { $generate! {
    title "Vertices, current values and rectangles (sections 2.6, 2.7, 2.10, 2.12)";
    canonical {
        begin Vertex vertex(position: {[f32; 4]});
        begin Color color(color: {[f32; 4]});
        begin SecondaryColor secondary_color(color: {[f32; 4]});
        begin Normal normal(normal: {[f32; 3]});
        begin TexCoord tex_coord(coordinates: {[f32; 4]});
        begin MultiTexCoord multi_tex_coord(target: enum, coordinates: {[f32; 4]});
        begin FogCoord fog_coord(coordinate: f32);
        begin Index index(index: f32);
        begin EdgeFlag edge_flag(flag: bool);
        list RasterPos raster_pos(position: {[f32; 4]});
        list WindowPos window_pos(position: {[f32; 3]});
        list Rect rect(corners: {[f32; 4]});
    }
    commands {
        /// Starts a primitive (section 2.6). `INVALID_ENUM` if `mode` is not `POINTS` to `POLYGON`.
        #[doc = include_str!("examples/begin.md")]
        list glBegin begin(mode: enum);
        /// Ends the primitive of the last Begin (section 2.6). `INVALID_OPERATION` without one.
        begin glEnd end();
    }
    forms {
        family "Issues a vertex with the current attributes (section 2.7)." {
            begin glVertex2s vertex2s(x: i16, y: i16) => vertex(point([x, y]));
            begin glVertex2sv vertex2sv(v: [i16; 2]) => vertex(point(*v));
            begin glVertex2i vertex2i(x: i32, y: i32) => vertex(point([x, y]));
            begin glVertex2iv vertex2iv(v: [i32; 2]) => vertex(point(*v));
            begin glVertex2f vertex2f(x: f32, y: f32) => vertex(point([x, y]));
            begin glVertex2fv vertex2fv(v: [f32; 2]) => vertex(point(*v));
            begin glVertex2d vertex2d(x: f64, y: f64) => vertex(point([x, y]));
            begin glVertex2dv vertex2dv(v: [f64; 2]) => vertex(point(*v));
            begin glVertex3s vertex3s(x: i16, y: i16, z: i16) => vertex(point([x, y, z]));
            begin glVertex3sv vertex3sv(v: [i16; 3]) => vertex(point(*v));
            begin glVertex3i vertex3i(x: i32, y: i32, z: i32) => vertex(point([x, y, z]));
            begin glVertex3iv vertex3iv(v: [i32; 3]) => vertex(point(*v));
            #[doc = include_str!("examples/vertex.md")]
            begin glVertex3f vertex3f(x: f32, y: f32, z: f32) => vertex(point([x, y, z]));
            begin glVertex3fv vertex3fv(v: [f32; 3]) => vertex(point(*v));
            begin glVertex3d vertex3d(x: f64, y: f64, z: f64) => vertex(point([x, y, z]));
            begin glVertex3dv vertex3dv(v: [f64; 3]) => vertex(point(*v));
            begin glVertex4s vertex4s(x: i16, y: i16, z: i16, w: i16) => vertex(point([x, y, z, w]));
            begin glVertex4sv vertex4sv(v: [i16; 4]) => vertex(point(*v));
            begin glVertex4i vertex4i(x: i32, y: i32, z: i32, w: i32) => vertex(point([x, y, z, w]));
            begin glVertex4iv vertex4iv(v: [i32; 4]) => vertex(point(*v));
            begin glVertex4f vertex4f(x: f32, y: f32, z: f32, w: f32) => vertex(point([x, y, z, w]));
            begin glVertex4fv vertex4fv(v: [f32; 4]) => vertex(point(*v));
            begin glVertex4d vertex4d(x: f64, y: f64, z: f64, w: f64) => vertex(point([x, y, z, w]));
            begin glVertex4dv vertex4dv(v: [f64; 4]) => vertex(point(*v));
        }
        family "Sets the current colour (section 2.7); integers are fractions of their range, alpha is 1 if left out." {
            begin glColor3b color3b(red: i8, green: i8, blue: i8) => color(color([red, green, blue]));
            begin glColor3bv color3bv(v: [i8; 3]) => color(color(*v));
            begin glColor3s color3s(red: i16, green: i16, blue: i16) => color(color([red, green, blue]));
            begin glColor3sv color3sv(v: [i16; 3]) => color(color(*v));
            begin glColor3i color3i(red: i32, green: i32, blue: i32) => color(color([red, green, blue]));
            begin glColor3iv color3iv(v: [i32; 3]) => color(color(*v));
            begin glColor3f color3f(red: f32, green: f32, blue: f32) => color(color([red, green, blue]));
            begin glColor3fv color3fv(v: [f32; 3]) => color(color(*v));
            begin glColor3d color3d(red: f64, green: f64, blue: f64) => color(color([red, green, blue]));
            begin glColor3dv color3dv(v: [f64; 3]) => color(color(*v));
            begin glColor3ub color3ub(red: u8, green: u8, blue: u8) => color(color([red, green, blue]));
            begin glColor3ubv color3ubv(v: [u8; 3]) => color(color(*v));
            begin glColor3us color3us(red: u16, green: u16, blue: u16) => color(color([red, green, blue]));
            begin glColor3usv color3usv(v: [u16; 3]) => color(color(*v));
            begin glColor3ui color3ui(red: u32, green: u32, blue: u32) => color(color([red, green, blue]));
            begin glColor3uiv color3uiv(v: [u32; 3]) => color(color(*v));
            begin glColor4b color4b(red: i8, green: i8, blue: i8, alpha: i8) => color(color([red, green, blue, alpha]));
            begin glColor4bv color4bv(v: [i8; 4]) => color(color(*v));
            begin glColor4s color4s(red: i16, green: i16, blue: i16, alpha: i16) => color(color([red, green, blue, alpha]));
            begin glColor4sv color4sv(v: [i16; 4]) => color(color(*v));
            begin glColor4i color4i(red: i32, green: i32, blue: i32, alpha: i32) => color(color([red, green, blue, alpha]));
            begin glColor4iv color4iv(v: [i32; 4]) => color(color(*v));
            #[doc = include_str!("examples/color.md")]
            begin glColor4f color4f(red: f32, green: f32, blue: f32, alpha: f32) => color(color([red, green, blue, alpha]));
            begin glColor4fv color4fv(v: [f32; 4]) => color(color(*v));
            begin glColor4d color4d(red: f64, green: f64, blue: f64, alpha: f64) => color(color([red, green, blue, alpha]));
            begin glColor4dv color4dv(v: [f64; 4]) => color(color(*v));
            begin glColor4ub color4ub(red: u8, green: u8, blue: u8, alpha: u8) => color(color([red, green, blue, alpha]));
            begin glColor4ubv color4ubv(v: [u8; 4]) => color(color(*v));
            begin glColor4us color4us(red: u16, green: u16, blue: u16, alpha: u16) => color(color([red, green, blue, alpha]));
            begin glColor4usv color4usv(v: [u16; 4]) => color(color(*v));
            begin glColor4ui color4ui(red: u32, green: u32, blue: u32, alpha: u32) => color(color([red, green, blue, alpha]));
            begin glColor4uiv color4uiv(v: [u32; 4]) => color(color(*v));
        }
        family "Sets the current secondary colour, which the colour sum adds after texturing (sections 2.7 and 3.9)." {
            begin glSecondaryColor3b | glSecondaryColor3bEXT secondary_color3b(red: i8, green: i8, blue: i8) => secondary_color(color([red, green, blue]));
            begin glSecondaryColor3bv | glSecondaryColor3bvEXT secondary_color3bv(v: [i8; 3]) => secondary_color(color(*v));
            begin glSecondaryColor3s | glSecondaryColor3sEXT secondary_color3s(red: i16, green: i16, blue: i16) => secondary_color(color([red, green, blue]));
            begin glSecondaryColor3sv | glSecondaryColor3svEXT secondary_color3sv(v: [i16; 3]) => secondary_color(color(*v));
            begin glSecondaryColor3i | glSecondaryColor3iEXT secondary_color3i(red: i32, green: i32, blue: i32) => secondary_color(color([red, green, blue]));
            begin glSecondaryColor3iv | glSecondaryColor3ivEXT secondary_color3iv(v: [i32; 3]) => secondary_color(color(*v));
            begin glSecondaryColor3f | glSecondaryColor3fEXT secondary_color3f(red: f32, green: f32, blue: f32) => secondary_color(color([red, green, blue]));
            begin glSecondaryColor3fv | glSecondaryColor3fvEXT secondary_color3fv(v: [f32; 3]) => secondary_color(color(*v));
            begin glSecondaryColor3d | glSecondaryColor3dEXT secondary_color3d(red: f64, green: f64, blue: f64) => secondary_color(color([red, green, blue]));
            begin glSecondaryColor3dv | glSecondaryColor3dvEXT secondary_color3dv(v: [f64; 3]) => secondary_color(color(*v));
            begin glSecondaryColor3ub | glSecondaryColor3ubEXT secondary_color3ub(red: u8, green: u8, blue: u8) => secondary_color(color([red, green, blue]));
            begin glSecondaryColor3ubv | glSecondaryColor3ubvEXT secondary_color3ubv(v: [u8; 3]) => secondary_color(color(*v));
            begin glSecondaryColor3us | glSecondaryColor3usEXT secondary_color3us(red: u16, green: u16, blue: u16) => secondary_color(color([red, green, blue]));
            begin glSecondaryColor3usv | glSecondaryColor3usvEXT secondary_color3usv(v: [u16; 3]) => secondary_color(color(*v));
            begin glSecondaryColor3ui | glSecondaryColor3uiEXT secondary_color3ui(red: u32, green: u32, blue: u32) => secondary_color(color([red, green, blue]));
            begin glSecondaryColor3uiv | glSecondaryColor3uivEXT secondary_color3uiv(v: [u32; 3]) => secondary_color(color(*v));
        }
        family "Sets the current normal (section 2.7); integers are fractions of their range." {
            begin glNormal3b normal3b(nx: i8, ny: i8, nz: i8) => normal(normal([nx, ny, nz]));
            begin glNormal3bv normal3bv(v: [i8; 3]) => normal(normal(*v));
            begin glNormal3s normal3s(nx: i16, ny: i16, nz: i16) => normal(normal([nx, ny, nz]));
            begin glNormal3sv normal3sv(v: [i16; 3]) => normal(normal(*v));
            begin glNormal3i normal3i(nx: i32, ny: i32, nz: i32) => normal(normal([nx, ny, nz]));
            begin glNormal3iv normal3iv(v: [i32; 3]) => normal(normal(*v));
            #[doc = include_str!("examples/normal.md")]
            begin glNormal3f normal3f(nx: f32, ny: f32, nz: f32) => normal(normal([nx, ny, nz]));
            begin glNormal3fv normal3fv(v: [f32; 3]) => normal(normal(*v));
            begin glNormal3d normal3d(nx: f64, ny: f64, nz: f64) => normal(normal([nx, ny, nz]));
            begin glNormal3dv normal3dv(v: [f64; 3]) => normal(normal(*v));
        }
        family "Sets the current texture coordinates of unit 0 (section 2.7)." {
            begin glTexCoord1s tex_coord1s(s: i16) => tex_coord(point([s]));
            begin glTexCoord1sv tex_coord1sv(v: [i16; 1]) => tex_coord(point(*v));
            begin glTexCoord1i tex_coord1i(s: i32) => tex_coord(point([s]));
            begin glTexCoord1iv tex_coord1iv(v: [i32; 1]) => tex_coord(point(*v));
            begin glTexCoord1f tex_coord1f(s: f32) => tex_coord(point([s]));
            begin glTexCoord1fv tex_coord1fv(v: [f32; 1]) => tex_coord(point(*v));
            begin glTexCoord1d tex_coord1d(s: f64) => tex_coord(point([s]));
            begin glTexCoord1dv tex_coord1dv(v: [f64; 1]) => tex_coord(point(*v));
            begin glTexCoord2s tex_coord2s(s: i16, t: i16) => tex_coord(point([s, t]));
            begin glTexCoord2sv tex_coord2sv(v: [i16; 2]) => tex_coord(point(*v));
            begin glTexCoord2i tex_coord2i(s: i32, t: i32) => tex_coord(point([s, t]));
            begin glTexCoord2iv tex_coord2iv(v: [i32; 2]) => tex_coord(point(*v));
            #[doc = include_str!("examples/tex_coord.md")]
            begin glTexCoord2f tex_coord2f(s: f32, t: f32) => tex_coord(point([s, t]));
            begin glTexCoord2fv tex_coord2fv(v: [f32; 2]) => tex_coord(point(*v));
            begin glTexCoord2d tex_coord2d(s: f64, t: f64) => tex_coord(point([s, t]));
            begin glTexCoord2dv tex_coord2dv(v: [f64; 2]) => tex_coord(point(*v));
            begin glTexCoord3s tex_coord3s(s: i16, t: i16, r: i16) => tex_coord(point([s, t, r]));
            begin glTexCoord3sv tex_coord3sv(v: [i16; 3]) => tex_coord(point(*v));
            begin glTexCoord3i tex_coord3i(s: i32, t: i32, r: i32) => tex_coord(point([s, t, r]));
            begin glTexCoord3iv tex_coord3iv(v: [i32; 3]) => tex_coord(point(*v));
            begin glTexCoord3f tex_coord3f(s: f32, t: f32, r: f32) => tex_coord(point([s, t, r]));
            begin glTexCoord3fv tex_coord3fv(v: [f32; 3]) => tex_coord(point(*v));
            begin glTexCoord3d tex_coord3d(s: f64, t: f64, r: f64) => tex_coord(point([s, t, r]));
            begin glTexCoord3dv tex_coord3dv(v: [f64; 3]) => tex_coord(point(*v));
            begin glTexCoord4s tex_coord4s(s: i16, t: i16, r: i16, q: i16) => tex_coord(point([s, t, r, q]));
            begin glTexCoord4sv tex_coord4sv(v: [i16; 4]) => tex_coord(point(*v));
            begin glTexCoord4i tex_coord4i(s: i32, t: i32, r: i32, q: i32) => tex_coord(point([s, t, r, q]));
            begin glTexCoord4iv tex_coord4iv(v: [i32; 4]) => tex_coord(point(*v));
            begin glTexCoord4f tex_coord4f(s: f32, t: f32, r: f32, q: f32) => tex_coord(point([s, t, r, q]));
            begin glTexCoord4fv tex_coord4fv(v: [f32; 4]) => tex_coord(point(*v));
            begin glTexCoord4d tex_coord4d(s: f64, t: f64, r: f64, q: f64) => tex_coord(point([s, t, r, q]));
            begin glTexCoord4dv tex_coord4dv(v: [f64; 4]) => tex_coord(point(*v));
        }
        family "Sets the current texture coordinates of a unit (section 2.7). `INVALID_ENUM` for a unit that does not exist." {
            begin glMultiTexCoord1s | glMultiTexCoord1sARB multi_tex_coord1s(target: enum, s: i16) => multi_tex_coord(target, point([s]));
            begin glMultiTexCoord1sv | glMultiTexCoord1svARB multi_tex_coord1sv(target: unit, v: [i16; 1]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord1i | glMultiTexCoord1iARB multi_tex_coord1i(target: enum, s: i32) => multi_tex_coord(target, point([s]));
            begin glMultiTexCoord1iv | glMultiTexCoord1ivARB multi_tex_coord1iv(target: unit, v: [i32; 1]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord1f | glMultiTexCoord1fARB multi_tex_coord1f(target: enum, s: f32) => multi_tex_coord(target, point([s]));
            begin glMultiTexCoord1fv | glMultiTexCoord1fvARB multi_tex_coord1fv(target: unit, v: [f32; 1]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord1d | glMultiTexCoord1dARB multi_tex_coord1d(target: enum, s: f64) => multi_tex_coord(target, point([s]));
            begin glMultiTexCoord1dv | glMultiTexCoord1dvARB multi_tex_coord1dv(target: unit, v: [f64; 1]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord2s | glMultiTexCoord2sARB multi_tex_coord2s(target: enum, s: i16, t: i16) => multi_tex_coord(target, point([s, t]));
            begin glMultiTexCoord2sv | glMultiTexCoord2svARB multi_tex_coord2sv(target: unit, v: [i16; 2]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord2i | glMultiTexCoord2iARB multi_tex_coord2i(target: enum, s: i32, t: i32) => multi_tex_coord(target, point([s, t]));
            begin glMultiTexCoord2iv | glMultiTexCoord2ivARB multi_tex_coord2iv(target: unit, v: [i32; 2]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord2f | glMultiTexCoord2fARB multi_tex_coord2f(target: enum, s: f32, t: f32) => multi_tex_coord(target, point([s, t]));
            begin glMultiTexCoord2fv | glMultiTexCoord2fvARB multi_tex_coord2fv(target: unit, v: [f32; 2]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord2d | glMultiTexCoord2dARB multi_tex_coord2d(target: enum, s: f64, t: f64) => multi_tex_coord(target, point([s, t]));
            begin glMultiTexCoord2dv | glMultiTexCoord2dvARB multi_tex_coord2dv(target: unit, v: [f64; 2]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord3s | glMultiTexCoord3sARB multi_tex_coord3s(target: enum, s: i16, t: i16, r: i16) => multi_tex_coord(target, point([s, t, r]));
            begin glMultiTexCoord3sv | glMultiTexCoord3svARB multi_tex_coord3sv(target: unit, v: [i16; 3]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord3i | glMultiTexCoord3iARB multi_tex_coord3i(target: enum, s: i32, t: i32, r: i32) => multi_tex_coord(target, point([s, t, r]));
            begin glMultiTexCoord3iv | glMultiTexCoord3ivARB multi_tex_coord3iv(target: unit, v: [i32; 3]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord3f | glMultiTexCoord3fARB multi_tex_coord3f(target: enum, s: f32, t: f32, r: f32) => multi_tex_coord(target, point([s, t, r]));
            begin glMultiTexCoord3fv | glMultiTexCoord3fvARB multi_tex_coord3fv(target: unit, v: [f32; 3]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord3d | glMultiTexCoord3dARB multi_tex_coord3d(target: enum, s: f64, t: f64, r: f64) => multi_tex_coord(target, point([s, t, r]));
            begin glMultiTexCoord3dv | glMultiTexCoord3dvARB multi_tex_coord3dv(target: unit, v: [f64; 3]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord4s | glMultiTexCoord4sARB multi_tex_coord4s(target: enum, s: i16, t: i16, r: i16, q: i16) => multi_tex_coord(target, point([s, t, r, q]));
            begin glMultiTexCoord4sv | glMultiTexCoord4svARB multi_tex_coord4sv(target: unit, v: [i16; 4]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord4i | glMultiTexCoord4iARB multi_tex_coord4i(target: enum, s: i32, t: i32, r: i32, q: i32) => multi_tex_coord(target, point([s, t, r, q]));
            begin glMultiTexCoord4iv | glMultiTexCoord4ivARB multi_tex_coord4iv(target: unit, v: [i32; 4]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord4f | glMultiTexCoord4fARB multi_tex_coord4f(target: enum, s: f32, t: f32, r: f32, q: f32) => multi_tex_coord(target, point([s, t, r, q]));
            begin glMultiTexCoord4fv | glMultiTexCoord4fvARB multi_tex_coord4fv(target: unit, v: [f32; 4]) => multi_tex_coord(target, point(*v));
            begin glMultiTexCoord4d | glMultiTexCoord4dARB multi_tex_coord4d(target: enum, s: f64, t: f64, r: f64, q: f64) => multi_tex_coord(target, point([s, t, r, q]));
            begin glMultiTexCoord4dv | glMultiTexCoord4dvARB multi_tex_coord4dv(target: unit, v: [f64; 4]) => multi_tex_coord(target, point(*v));
        }
        family "Sets the current fog coordinate (section 2.7)." {
            begin glFogCoordf | glFogCoordfEXT fog_coordf(coord: f32) => fog_coord(number(coord));
            begin glFogCoordfv | glFogCoordfvEXT fog_coordfv(v: [f32; 1]) => fog_coord(number(v[0]));
            begin glFogCoordd | glFogCoorddEXT fog_coordd(coord: f64) => fog_coord(number(coord));
            begin glFogCoorddv | glFogCoorddvEXT fog_coorddv(v: [f64; 1]) => fog_coord(number(v[0]));
        }
        family "Sets the current colour index (section 2.7)." {
            begin glIndexs indexs(c: i16) => index(number(c));
            begin glIndexsv indexsv(v: [i16; 1]) => index(number(v[0]));
            begin glIndexi indexi(c: i32) => index(number(c));
            begin glIndexiv indexiv(v: [i32; 1]) => index(number(v[0]));
            begin glIndexf indexf(c: f32) => index(number(c));
            begin glIndexfv indexfv(v: [f32; 1]) => index(number(v[0]));
            begin glIndexd indexd(c: f64) => index(number(c));
            begin glIndexdv indexdv(v: [f64; 1]) => index(number(v[0]));
            begin glIndexub indexub(c: u8) => index(number(c));
            begin glIndexubv indexubv(v: [u8; 1]) => index(number(v[0]));
        }
        family "Sets whether edges that start at the next vertices are boundary edges (section 2.6.2)." {
            begin glEdgeFlag edge_flag(flag: bool) => edge_flag(flag);
            begin glEdgeFlagv edge_flagv(flag: [u8; 1]) => edge_flag(flag[0] != 0);
        }
        family "Sets the raster position from object coordinates (section 2.12)." {
            list glRasterPos2s raster_pos2s(x: i16, y: i16) => raster_pos(point([x, y]));
            list glRasterPos2sv raster_pos2sv(v: [i16; 2]) => raster_pos(point(*v));
            list glRasterPos2i raster_pos2i(x: i32, y: i32) => raster_pos(point([x, y]));
            list glRasterPos2iv raster_pos2iv(v: [i32; 2]) => raster_pos(point(*v));
            list glRasterPos2f raster_pos2f(x: f32, y: f32) => raster_pos(point([x, y]));
            list glRasterPos2fv raster_pos2fv(v: [f32; 2]) => raster_pos(point(*v));
            list glRasterPos2d raster_pos2d(x: f64, y: f64) => raster_pos(point([x, y]));
            list glRasterPos2dv raster_pos2dv(v: [f64; 2]) => raster_pos(point(*v));
            list glRasterPos3s raster_pos3s(x: i16, y: i16, z: i16) => raster_pos(point([x, y, z]));
            list glRasterPos3sv raster_pos3sv(v: [i16; 3]) => raster_pos(point(*v));
            list glRasterPos3i raster_pos3i(x: i32, y: i32, z: i32) => raster_pos(point([x, y, z]));
            list glRasterPos3iv raster_pos3iv(v: [i32; 3]) => raster_pos(point(*v));
            list glRasterPos3f raster_pos3f(x: f32, y: f32, z: f32) => raster_pos(point([x, y, z]));
            list glRasterPos3fv raster_pos3fv(v: [f32; 3]) => raster_pos(point(*v));
            list glRasterPos3d raster_pos3d(x: f64, y: f64, z: f64) => raster_pos(point([x, y, z]));
            list glRasterPos3dv raster_pos3dv(v: [f64; 3]) => raster_pos(point(*v));
            list glRasterPos4s raster_pos4s(x: i16, y: i16, z: i16, w: i16) => raster_pos(point([x, y, z, w]));
            list glRasterPos4sv raster_pos4sv(v: [i16; 4]) => raster_pos(point(*v));
            list glRasterPos4i raster_pos4i(x: i32, y: i32, z: i32, w: i32) => raster_pos(point([x, y, z, w]));
            list glRasterPos4iv raster_pos4iv(v: [i32; 4]) => raster_pos(point(*v));
            list glRasterPos4f raster_pos4f(x: f32, y: f32, z: f32, w: f32) => raster_pos(point([x, y, z, w]));
            list glRasterPos4fv raster_pos4fv(v: [f32; 4]) => raster_pos(point(*v));
            list glRasterPos4d raster_pos4d(x: f64, y: f64, z: f64, w: f64) => raster_pos(point([x, y, z, w]));
            list glRasterPos4dv raster_pos4dv(v: [f64; 4]) => raster_pos(point(*v));
        }
        family "Sets the raster position in window coordinates (section 2.12)." {
            list glWindowPos2s | glWindowPos2sARB | glWindowPos2sMESA window_pos2s(x: i16, y: i16) => window_pos(window([x, y]));
            list glWindowPos2sv | glWindowPos2svARB | glWindowPos2svMESA window_pos2sv(v: [i16; 2]) => window_pos(window(*v));
            list glWindowPos2i | glWindowPos2iARB | glWindowPos2iMESA window_pos2i(x: i32, y: i32) => window_pos(window([x, y]));
            list glWindowPos2iv | glWindowPos2ivARB | glWindowPos2ivMESA window_pos2iv(v: [i32; 2]) => window_pos(window(*v));
            list glWindowPos2f | glWindowPos2fARB | glWindowPos2fMESA window_pos2f(x: f32, y: f32) => window_pos(window([x, y]));
            list glWindowPos2fv | glWindowPos2fvARB | glWindowPos2fvMESA window_pos2fv(v: [f32; 2]) => window_pos(window(*v));
            list glWindowPos2d | glWindowPos2dARB | glWindowPos2dMESA window_pos2d(x: f64, y: f64) => window_pos(window([x, y]));
            list glWindowPos2dv | glWindowPos2dvARB | glWindowPos2dvMESA window_pos2dv(v: [f64; 2]) => window_pos(window(*v));
            list glWindowPos3s | glWindowPos3sARB | glWindowPos3sMESA window_pos3s(x: i16, y: i16, z: i16) => window_pos(window([x, y, z]));
            list glWindowPos3sv | glWindowPos3svARB | glWindowPos3svMESA window_pos3sv(v: [i16; 3]) => window_pos(window(*v));
            list glWindowPos3i | glWindowPos3iARB | glWindowPos3iMESA window_pos3i(x: i32, y: i32, z: i32) => window_pos(window([x, y, z]));
            list glWindowPos3iv | glWindowPos3ivARB | glWindowPos3ivMESA window_pos3iv(v: [i32; 3]) => window_pos(window(*v));
            list glWindowPos3f | glWindowPos3fARB | glWindowPos3fMESA window_pos3f(x: f32, y: f32, z: f32) => window_pos(window([x, y, z]));
            list glWindowPos3fv | glWindowPos3fvARB | glWindowPos3fvMESA window_pos3fv(v: [f32; 3]) => window_pos(window(*v));
            list glWindowPos3d | glWindowPos3dARB | glWindowPos3dMESA window_pos3d(x: f64, y: f64, z: f64) => window_pos(window([x, y, z]));
            list glWindowPos3dv | glWindowPos3dvARB | glWindowPos3dvMESA window_pos3dv(v: [f64; 3]) => window_pos(window(*v));
        }
        family "Draws a rectangle with two opposite corners (section 2.10)." {
            list glRects rects(x1: i16, y1: i16, x2: i16, y2: i16) => rect(corners([x1, y1], [x2, y2]));
            list glRectsv rectsv(v1: [i16; 2], v2: [i16; 2]) => rect(corners(*v1, *v2));
            list glRecti recti(x1: i32, y1: i32, x2: i32, y2: i32) => rect(corners([x1, y1], [x2, y2]));
            list glRectiv rectiv(v1: [i32; 2], v2: [i32; 2]) => rect(corners(*v1, *v2));
            list glRectf rectf(x1: f32, y1: f32, x2: f32, y2: f32) => rect(corners([x1, y1], [x2, y2]));
            list glRectfv rectfv(v1: [f32; 2], v2: [f32; 2]) => rect(corners(*v1, *v2));
            list glRectd rectd(x1: f64, y1: f64, x2: f64, y2: f64) => rect(corners([x1, y1], [x2, y2]));
            list glRectdv rectdv(v1: [f64; 2], v2: [f64; 2]) => rect(corners(*v1, *v2));
        }
    }
    context {}
    now {}
    queries {}
    answers {}
    manual {}
} } }

pub(crate) use vertex_table;
