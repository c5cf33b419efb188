//! Every command of GL 1.0 to 1.5 and of the imaging subset has exactly one row.

use super::rows::rows;
use std::collections::BTreeSet;

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
    for name in rows().map(|row| row.name) {
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
    let aliases: BTreeSet<_> = rows().flat_map(|row| row.aliases.iter().copied().chain([row.name])).collect();
    for name in ALIASES.split_whitespace() {
        assert!(aliases.contains(format!("gl{name}").as_str()), "{name}");
    }
}
