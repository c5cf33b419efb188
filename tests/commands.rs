//! The table of commands and the way through it: every command of GL 1.0 to 1.5 has a row, the first error sticks and
//! is told in words with its place, a trace shows every call, and C's names work on the context of the thread.

use fixedgl::Call;
use fixedgl::Context;
use fixedgl::enums::*;
use fixedgl::internals::table;
use std::collections::BTreeSet;
use std::sync::{Arc, Mutex};

/// The commands that each version added, as the specification's appendices list them, without the prefix `gl`.
const VERSIONS: [(&str, &str); 7] = [
    (
        "1.0",
        "Accum AlphaFunc Begin Bitmap BlendFunc CallList CallLists Clear ClearAccum ClearColor ClearDepth \
         ClearIndex ClearStencil ClipPlane Color3b Color3bv Color3d Color3dv Color3f Color3fv Color3i \
         Color3iv Color3s Color3sv Color3ub Color3ubv Color3ui Color3uiv Color3us Color3usv Color4b Color4bv \
         Color4d Color4dv Color4f Color4fv Color4i Color4iv Color4s Color4sv Color4ub Color4ubv Color4ui \
         Color4uiv Color4us Color4usv ColorMask ColorMaterial CopyPixels CullFace DeleteLists DepthFunc \
         DepthMask DepthRange Disable DrawBuffer DrawPixels EdgeFlag EdgeFlagv Enable End EndList EvalCoord1d \
         EvalCoord1dv EvalCoord1f EvalCoord1fv EvalCoord2d EvalCoord2dv EvalCoord2f EvalCoord2fv EvalMesh1 \
         EvalMesh2 EvalPoint1 EvalPoint2 FeedbackBuffer Finish Flush Fogf Fogfv Fogi Fogiv FrontFace Frustum \
         GenLists GetBooleanv GetClipPlane GetDoublev GetError GetFloatv GetIntegerv GetLightfv GetLightiv \
         GetMapdv GetMapfv GetMapiv GetMaterialfv GetMaterialiv GetPixelMapfv GetPixelMapuiv GetPixelMapusv \
         GetPolygonStipple GetString GetTexEnvfv GetTexEnviv GetTexGendv GetTexGenfv GetTexGeniv GetTexImage \
         GetTexLevelParameterfv GetTexLevelParameteriv GetTexParameterfv GetTexParameteriv Hint IndexMask \
         Indexd Indexdv Indexf Indexfv Indexi Indexiv Indexs Indexsv InitNames IsEnabled IsList LightModelf \
         LightModelfv LightModeli LightModeliv Lightf Lightfv Lighti Lightiv LineStipple LineWidth ListBase \
         LoadIdentity LoadMatrixd LoadMatrixf LoadName LogicOp Map1d Map1f Map2d Map2f MapGrid1d MapGrid1f \
         MapGrid2d MapGrid2f Materialf Materialfv Materiali Materialiv MatrixMode MultMatrixd MultMatrixf \
         NewList Normal3b Normal3bv Normal3d Normal3dv Normal3f Normal3fv Normal3i Normal3iv Normal3s \
         Normal3sv Ortho PassThrough PixelMapfv PixelMapuiv PixelMapusv PixelStoref PixelStorei \
         PixelTransferf PixelTransferi PixelZoom PointSize PolygonMode PolygonStipple PopAttrib PopMatrix \
         PopName PushAttrib PushMatrix PushName RasterPos2d RasterPos2dv RasterPos2f RasterPos2fv RasterPos2i \
         RasterPos2iv RasterPos2s RasterPos2sv RasterPos3d RasterPos3dv RasterPos3f RasterPos3fv RasterPos3i \
         RasterPos3iv RasterPos3s RasterPos3sv RasterPos4d RasterPos4dv RasterPos4f RasterPos4fv RasterPos4i \
         RasterPos4iv RasterPos4s RasterPos4sv ReadBuffer ReadPixels Rectd Rectdv Rectf Rectfv Recti Rectiv \
         Rects Rectsv RenderMode Rotated Rotatef Scaled Scalef Scissor SelectBuffer ShadeModel StencilFunc \
         StencilMask StencilOp TexCoord1d TexCoord1dv TexCoord1f TexCoord1fv TexCoord1i TexCoord1iv \
         TexCoord1s TexCoord1sv TexCoord2d TexCoord2dv TexCoord2f TexCoord2fv TexCoord2i TexCoord2iv \
         TexCoord2s TexCoord2sv TexCoord3d TexCoord3dv TexCoord3f TexCoord3fv TexCoord3i TexCoord3iv \
         TexCoord3s TexCoord3sv TexCoord4d TexCoord4dv TexCoord4f TexCoord4fv TexCoord4i TexCoord4iv \
         TexCoord4s TexCoord4sv TexEnvf TexEnvfv TexEnvi TexEnviv TexGend TexGendv TexGenf TexGenfv TexGeni \
         TexGeniv TexImage1D TexImage2D TexParameterf TexParameterfv TexParameteri TexParameteriv Translated \
         Translatef Vertex2d Vertex2dv Vertex2f Vertex2fv Vertex2i Vertex2iv Vertex2s Vertex2sv Vertex3d \
         Vertex3dv Vertex3f Vertex3fv Vertex3i Vertex3iv Vertex3s Vertex3sv Vertex4d Vertex4dv Vertex4f \
         Vertex4fv Vertex4i Vertex4iv Vertex4s Vertex4sv Viewport",
    ),
    (
        "1.1",
        "AreTexturesResident ArrayElement BindTexture ColorPointer CopyTexImage1D CopyTexImage2D \
         CopyTexSubImage1D CopyTexSubImage2D DeleteTextures DisableClientState DrawArrays DrawElements \
         EdgeFlagPointer EnableClientState GenTextures GetPointerv IndexPointer Indexub Indexubv \
         InterleavedArrays IsTexture NormalPointer PolygonOffset PopClientAttrib PrioritizeTextures \
         PushClientAttrib TexCoordPointer TexSubImage1D TexSubImage2D VertexPointer",
    ),
    ("1.2", "CopyTexSubImage3D DrawRangeElements TexImage3D TexSubImage3D"),
    (
        "1.2 imaging",
        "ColorSubTable ColorTable ColorTableParameterfv ColorTableParameteriv ConvolutionFilter1D \
         ConvolutionFilter2D ConvolutionParameterf ConvolutionParameterfv ConvolutionParameteri \
         ConvolutionParameteriv CopyColorSubTable CopyColorTable CopyConvolutionFilter1D \
         CopyConvolutionFilter2D GetColorTable GetColorTableParameterfv GetColorTableParameteriv \
         GetConvolutionFilter GetConvolutionParameterfv GetConvolutionParameteriv GetHistogram \
         GetHistogramParameterfv GetHistogramParameteriv GetMinmax GetMinmaxParameterfv GetMinmaxParameteriv \
         GetSeparableFilter Histogram Minmax ResetHistogram ResetMinmax SeparableFilter2D",
    ),
    (
        "1.3",
        "ActiveTexture ClientActiveTexture CompressedTexImage1D CompressedTexImage2D CompressedTexImage3D \
         CompressedTexSubImage1D CompressedTexSubImage2D CompressedTexSubImage3D GetCompressedTexImage \
         LoadTransposeMatrixd LoadTransposeMatrixf MultTransposeMatrixd MultTransposeMatrixf MultiTexCoord1d \
         MultiTexCoord1dv MultiTexCoord1f MultiTexCoord1fv MultiTexCoord1i MultiTexCoord1iv MultiTexCoord1s \
         MultiTexCoord1sv MultiTexCoord2d MultiTexCoord2dv MultiTexCoord2f MultiTexCoord2fv MultiTexCoord2i \
         MultiTexCoord2iv MultiTexCoord2s MultiTexCoord2sv MultiTexCoord3d MultiTexCoord3dv MultiTexCoord3f \
         MultiTexCoord3fv MultiTexCoord3i MultiTexCoord3iv MultiTexCoord3s MultiTexCoord3sv MultiTexCoord4d \
         MultiTexCoord4dv MultiTexCoord4f MultiTexCoord4fv MultiTexCoord4i MultiTexCoord4iv MultiTexCoord4s \
         MultiTexCoord4sv SampleCoverage",
    ),
    (
        "1.4",
        "BlendColor BlendEquation BlendFuncSeparate FogCoordPointer FogCoordd FogCoorddv FogCoordf FogCoordfv \
         MultiDrawArrays MultiDrawElements PointParameterf PointParameterfv PointParameteri PointParameteriv \
         SecondaryColor3b SecondaryColor3bv SecondaryColor3d SecondaryColor3dv SecondaryColor3f \
         SecondaryColor3fv SecondaryColor3i SecondaryColor3iv SecondaryColor3s SecondaryColor3sv \
         SecondaryColor3ub SecondaryColor3ubv SecondaryColor3ui SecondaryColor3uiv SecondaryColor3us \
         SecondaryColor3usv SecondaryColorPointer WindowPos2d WindowPos2dv WindowPos2f WindowPos2fv \
         WindowPos2i WindowPos2iv WindowPos2s WindowPos2sv WindowPos3d WindowPos3dv WindowPos3f WindowPos3fv \
         WindowPos3i WindowPos3iv WindowPos3s WindowPos3sv",
    ),
    (
        "1.5",
        "BeginQuery BindBuffer BufferData BufferSubData DeleteBuffers DeleteQueries EndQuery GenBuffers \
         GenQueries GetBufferParameteriv GetBufferPointerv GetBufferSubData GetQueryObjectiv \
         GetQueryObjectuiv GetQueryiv IsBuffer IsQuery MapBuffer UnmapBuffer",
    ),
];

/// Extension names of the same commands that programs of the time call.
const ALIASES: &str = "ActiveTextureARB ClientActiveTextureARB MultiTexCoord2fARB MultiTexCoord4svARB BindBufferARB \
     BufferDataARB MapBufferARB UnmapBufferARB SecondaryColor3fEXT FogCoordfEXT BlendEquationEXT BlendColorEXT \
     TexImage3DEXT PointParameterfARB PointParameterfvEXT WindowPos2iARB CompressedTexImage2DARB \
     LoadTransposeMatrixfARB SampleCoverageARB GenTexturesEXT BindTextureEXT DrawRangeElementsEXT \
     MultiDrawArraysEXT GenerateMipmapEXT ArrayElementEXT BeginQueryARB LockArraysEXT UnlockArraysEXT GenerateMipmap";

#[test]
fn every_command_of_every_version_has_exactly_one_row() {
    let mut seen = BTreeSet::new();
    for name in table::rows().map(|row| row.name) {
        assert!(seen.insert(name), "{name} has two rows");
    }
    let mut all = 0;
    for (version, names) in VERSIONS {
        for name in names.split_whitespace() {
            assert!(seen.contains(format!("gl{name}").as_str()), "GL {version}: {name} has no row");
            all += 1;
        }
    }
    assert_eq!(all, 484, "452 commands of GL 1.0 to 1.5 and 32 of the imaging subset");
    let aliases: BTreeSet<_> = table::rows().flat_map(|row| row.aliases.iter().copied().chain([row.name])).collect();
    for name in ALIASES.split_whitespace() {
        assert!(aliases.contains(format!("gl{name}").as_str()), "{name}");
    }
}

#[test]
fn the_first_error_sticks_and_reading_clears_it() {
    let mut cx = Context::new(4, 4);
    cx.enable(0x1234);
    cx.viewport(0, 0, -1, 4);
    cx.matrix_mode(GL_LINES);
    let line = line!() - 3;
    let error = cx.check().expect_err("three errors");
    assert_eq!((error.code, error.command, error.line), (GL_INVALID_ENUM, "glEnable", line));
    assert!(error.file.ends_with("commands.rs"));
    assert!(!error.message.is_empty());
    assert_eq!(cx.check(), Ok(()));
    cx.viewport(0, 0, -1, 4);
    assert_eq!(cx.get_error(), GL_INVALID_VALUE);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn the_debug_callback_hears_every_error_with_its_place() {
    let heard = Arc::new(Mutex::new(Vec::new()));
    let mut cx = Context::new(4, 4);
    let sink = Arc::clone(&heard);
    cx.set_debug_callback(Some(Box::new(move |m| {
        sink.lock().unwrap().push((m.source, m.type_, m.id, m.severity, m.command, m.line, m.message.to_string()));
    })));
    cx.enable(0x1234);
    cx.load_matrixf(&[1.0; 15]);
    let line = line!() - 1;
    let heard = heard.lock().unwrap();
    assert_eq!(heard.len(), 2);
    let (source, type_, id, severity, command, at, message) = &heard[1];
    assert_eq!(
        (*source, *type_, *id, *severity),
        (GL_DEBUG_SOURCE_API, GL_DEBUG_TYPE_ERROR, GL_INVALID_VALUE, GL_DEBUG_SEVERITY_HIGH)
    );
    assert_eq!((*command, *at), ("glLoadMatrixf", line));
    assert!(message.contains("16 values") && message.contains("15"), "{message}");
}

#[test]
fn a_trace_shows_the_calls_in_order_with_enumerants_by_name() {
    let calls: Arc<Mutex<Vec<Call>>> = Arc::default();
    let mut cx = Context::new(4, 4);
    let sink = Arc::clone(&calls);
    cx.set_trace_callback(Some(Box::new(move |call| sink.lock().unwrap().push(call.clone()))));
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    cx.new_list(1, GL_COMPILE);
    cx.color3ub(1, 2, 3);
    cx.lightfv(GL_LIGHT0, GL_POSITION, &[0.0, 1.0, 0.0, 0.0]);
    cx.end_list();
    cx.set_trace_callback(None);
    cx.call_list(1);
    let calls: Vec<String> = calls.lock().unwrap().iter().map(ToString::to_string).collect();
    assert_eq!(
        calls,
        [
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, 10497)",
            "glNewList(1, GL_COMPILE)",
            "glColor3ub(1, 2, 3)",
            "glLightfv(GL_LIGHT0, GL_POSITION, [0.0, 1.0, 0.0, 0.0])",
            "glEndList()",
        ]
    );
}

#[test]
fn the_c_names_work_on_the_current_context_of_the_thread() {
    use fixedgl::c::*;
    assert!(take_current().is_none());
    glEnable(GL_BLEND);
    assert_eq!(glGetError(), GL_NO_ERROR);
    assert_eq!(calls_without_context(), 2);
    assert!(make_current(Context::new(4, 4)).is_none());
    glEnable(GL_BLEND);
    assert_eq!(glIsEnabled(GL_BLEND), GL_TRUE);
    let mut name: GLuint = 0;
    glGenTextures(1, &mut name);
    let mut names = [0; 2];
    glGenTextures(2, &mut names);
    assert!(name != 0 && names[0] != 0 && names[1] != names[0]);
    let px = vec![[[255_u8, 0, 0]; 2]; 2];
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, 3, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, &px);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    glLightfv(GL_LIGHT0, GL_POSITION, &[1.0, 1.0, 1.0, 0.0]);
    glDepthMask(GL_FALSE);
    let m = [[1.0_f32, 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
    glLoadMatrixf(&m);
    assert_eq!(glGetError(), GL_NO_ERROR);
    let short = [0_u8; 3];
    glTexImage2D(GL_TEXTURE_2D, 0, 3, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, &short);
    let error = with_current(Context::check).expect("a context").expect_err("three bytes are too few");
    assert!(error.message.contains("12") && error.message.contains('3'), "{}", error.message);
    assert!(glGetString(GL_VERSION).starts_with("1.5"));
    // A context moves to another thread, and back.
    let cx = take_current().expect("the context");
    let cx = std::thread::spawn(move || {
        make_current(cx);
        glDisable(GL_BLEND);
        take_current().expect("the context")
    });
    make_current(cx.join().expect("the thread"));
    assert_eq!(glIsEnabled(GL_BLEND), GL_FALSE);
}

#[test]
fn a_context_is_send_and_sizes_come_in_any_integer() {
    fn send<T: Send>(_: &T) {}
    let mut cx = Context::new(4, 4);
    send(&cx);
    let data = [1.0_f32, 2.0, 3.0];
    cx.bind_buffer(GL_ARRAY_BUFFER, 1);
    cx.buffer_data(GL_ARRAY_BUFFER, size_of_val(&data), &data, GL_STATIC_DRAW);
    let mut back = [0.0_f32; 2];
    cx.get_buffer_sub_data(GL_ARRAY_BUFFER, 4, 8, &mut back);
    assert_eq!(back, [2.0, 3.0]);
    assert_eq!(cx.check(), Ok(()));
    cx.buffer_data(GL_ARRAY_BUFFER, u64::MAX, &data, GL_STATIC_DRAW);
    assert_eq!(cx.get_error(), GL_INVALID_VALUE);
}
