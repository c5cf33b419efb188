//! Chapter of the table: texturing (OpenGL 1.5, section 3.8). Images are read under the unpack state; a display list
//! keeps them as they were when it was compiled, and images of proxy targets are never compiled but answered at once.

macro_rules! texture_table { ($generate:ident) => { $generate! {
    title "Texturing (section 3.8)";
    canonical {
        list TexParameter tex_parameter(target: enum, pname: enum, params: params);
        list TexEnv tex_env(target: enum, pname: enum, params: params);
    }
    commands {
        /// Specifies a one-dimensional texture image (section 3.8.1). `INVALID_ENUM` for other targets, formats and types,
        /// `INVALID_VALUE` for levels, sizes, borders and internal formats that do not exist, `INVALID_OPERATION` for
        /// formats that do not fit the type or the internal format. A proxy target only asks whether it would fit.
        proxy glTexImage1D tex_image_1d(target: enum, level: i32, internal_format: i32, width: i32, border: i32,
            format: enum, type_: enum, pixels: (rect [width, 1], format, type_));
        /// Specifies a two-dimensional texture image, a face of a cube map or a rectangle texture (section 3.8.1). Errors
        /// as for the one-dimensional image. A proxy target only asks whether it would fit.
        #[doc = include_str!("examples/tex_image_2d.md")]
        proxy glTexImage2D tex_image_2d(target: enum, level: i32, internal_format: i32, width: i32, height: i32,
            border: i32, format: enum, type_: enum, pixels: (rect [width, height], format, type_));
        /// Specifies a three-dimensional texture image (section 3.8.1). Errors as for the one-dimensional image. A proxy
        /// target only asks whether it would fit.
        proxy glTexImage3D | glTexImage3DEXT tex_image_3d(target: enum, level: i32, internal_format: i32, width: i32,
            height: i32, depth: i32, border: i32, format: enum, type_: enum,
            pixels: (rect [width, height, depth], format, type_));
        /// Replaces a part of a one-dimensional texture image (section 3.8.2). `INVALID_OPERATION` if there is no image,
        /// `INVALID_VALUE` if the part lies outside.
        list glTexSubImage1D | glTexSubImage1DEXT tex_sub_image_1d(target: enum, level: i32, xoffset: i32, width: i32,
            format: enum, type_: enum, pixels: (rect [width, 1], format, type_));
        /// Replaces a part of a two-dimensional texture image (section 3.8.2). Errors as for one dimension.
        list glTexSubImage2D | glTexSubImage2DEXT tex_sub_image_2d(target: enum, level: i32, xoffset: i32, yoffset: i32,
            width: i32, height: i32, format: enum, type_: enum, pixels: (rect [width, height], format, type_));
        /// Replaces a part of a three-dimensional texture image (section 3.8.2). Errors as for one dimension.
        list glTexSubImage3D | glTexSubImage3DEXT tex_sub_image_3d(target: enum, level: i32, xoffset: i32, yoffset: i32,
            zoffset: i32, width: i32, height: i32, depth: i32, format: enum, type_: enum,
            pixels: (rect [width, height, depth], format, type_));
        /// Makes a one-dimensional texture image of pixels of the read buffer (section 3.8.2).
        list glCopyTexImage1D | glCopyTexImage1DEXT copy_tex_image_1d(target: enum, level: i32, internal_format: enum,
            x: i32, y: i32, width: i32, border: i32);
        /// Makes a two-dimensional texture image of pixels of the read buffer (section 3.8.2).
        list glCopyTexImage2D | glCopyTexImage2DEXT copy_tex_image_2d(target: enum, level: i32, internal_format: enum,
            x: i32, y: i32, width: i32, height: i32, border: i32);
        /// Replaces a part of a one-dimensional texture image by pixels of the read buffer (section 3.8.2).
        list glCopyTexSubImage1D | glCopyTexSubImage1DEXT copy_tex_sub_image_1d(target: enum, level: i32, xoffset: i32,
            x: i32, y: i32, width: i32);
        /// Replaces a part of a two-dimensional texture image by pixels of the read buffer (section 3.8.2).
        list glCopyTexSubImage2D | glCopyTexSubImage2DEXT copy_tex_sub_image_2d(target: enum, level: i32, xoffset: i32,
            yoffset: i32, x: i32, y: i32, width: i32, height: i32);
        /// Replaces a part of a slice of a three-dimensional texture image by pixels of the read buffer (section 3.8.2).
        list glCopyTexSubImage3D | glCopyTexSubImage3DEXT copy_tex_sub_image_3d(target: enum, level: i32, xoffset: i32,
            yoffset: i32, zoffset: i32, x: i32, y: i32, width: i32, height: i32);
        /// Specifies a one-dimensional texture image in a compressed format (section 3.8.3).
        proxy glCompressedTexImage1D | glCompressedTexImage1DARB compressed_tex_image_1d(target: enum, level: i32,
            internal_format: enum, width: i32, border: i32, image_size: i32, data: (bytes image_size));
        /// Specifies a two-dimensional texture image in a compressed format (section 3.8.3). `INVALID_VALUE` if
        /// `image_size` is not what the format needs.
        proxy glCompressedTexImage2D | glCompressedTexImage2DARB compressed_tex_image_2d(target: enum, level: i32,
            internal_format: enum, width: i32, height: i32, border: i32, image_size: i32, data: (bytes image_size));
        /// Specifies a three-dimensional texture image in a compressed format (section 3.8.3).
        proxy glCompressedTexImage3D | glCompressedTexImage3DARB compressed_tex_image_3d(target: enum, level: i32,
            internal_format: enum, width: i32, height: i32, depth: i32, border: i32, image_size: i32,
            data: (bytes image_size));
        /// Replaces a part of a one-dimensional compressed texture image (section 3.8.3).
        list glCompressedTexSubImage1D | glCompressedTexSubImage1DARB compressed_tex_sub_image_1d(target: enum, level: i32,
            xoffset: i32, width: i32, format: enum, image_size: i32, data: (bytes image_size));
        /// Replaces a part of a two-dimensional compressed texture image (section 3.8.3).
        list glCompressedTexSubImage2D | glCompressedTexSubImage2DARB compressed_tex_sub_image_2d(target: enum, level: i32,
            xoffset: i32, yoffset: i32, width: i32, height: i32, format: enum, image_size: i32,
            data: (bytes image_size));
        /// Replaces a part of a three-dimensional compressed texture image (section 3.8.3).
        list glCompressedTexSubImage3D | glCompressedTexSubImage3DARB compressed_tex_sub_image_3d(target: enum, level: i32,
            xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: enum,
            image_size: i32, data: (bytes image_size));
        /// Binds a texture object to a target of the active unit and makes it if it is new (section 3.8.12).
        /// `INVALID_OPERATION` if it has another target.
        #[doc = include_str!("examples/bind_texture.md")]
        list glBindTexture | glBindTextureEXT bind_texture(target: enum, texture: uint);
        /// Sets priorities of texture objects (section 3.8.12); they are kept and have no effect.
        list glPrioritizeTextures | glPrioritizeTexturesEXT prioritize_textures(n: i32, textures: (slice u32: count(n)),
            priorities: (slice f32: count(n)));
        /// Makes the smaller levels of the bound texture from its base level (EXT_framebuffer_object).
        list glGenerateMipmap | glGenerateMipmapEXT generate_mipmap(target: enum);
    }
    forms {
        family "Sets how a texture is filtered, wrapped and compared (section 3.8.4). `INVALID_ENUM` for other targets, names and values, `INVALID_VALUE` for negative levels." {
            #[doc = include_str!("examples/tex_parameter.md")]
            list glTexParameteri tex_parameteri(target: enum, pname: enum, param: i32) => tex_parameter(target, pname, &Params::int(param));
            list glTexParameterf tex_parameterf(target: enum, pname: enum, param: f32) => tex_parameter(target, pname, &Params::float(param));
            list glTexParameteriv tex_parameteriv(target: enum, pname: enum, params: (upto i32: tex_parameter(pname))) => tex_parameter(target, pname, &Params::ints(params));
            list glTexParameterfv tex_parameterfv(target: enum, pname: enum, params: (upto f32: tex_parameter(pname))) => tex_parameter(target, pname, &Params::floats(params));
        }
        family "Sets the environment of the active texture unit: function, colour, combiners, LOD bias, point sprites (section 3.8.13). `INVALID_ENUM` for other targets, names and values." {
            #[doc = include_str!("examples/tex_env.md")]
            list glTexEnvi tex_envi(target: enum, pname: enum, param: i32) => tex_env(target, pname, &Params::int(param));
            list glTexEnvf tex_envf(target: enum, pname: enum, param: f32) => tex_env(target, pname, &Params::float(param));
            list glTexEnviv tex_enviv(target: enum, pname: enum, params: (upto i32: tex_env(pname))) => tex_env(target, pname, &Params::ints(params));
            list glTexEnvfv tex_envfv(target: enum, pname: enum, params: (upto f32: tex_env(pname))) => tex_env(target, pname, &Params::floats(params));
        }
    }
    context {}
    now {
        /// Makes names of textures that are not in use (section 3.8.12).
        now glGenTextures | glGenTexturesEXT gen_textures(n: i32, textures: (out u32: count(n)));
        /// Deletes textures; names that do not exist and 0 are ignored (section 3.8.12).
        now glDeleteTextures | glDeleteTexturesEXT delete_textures(n: i32, textures: (slice u32: count(n)));
        /// Whether a name is that of a texture object (section 6.1.4).
        now glIsTexture | glIsTextureEXT is_texture(texture: uint) -> bool;
        /// Whether all textures are resident; if not, says which (section 3.8.12). `INVALID_VALUE` for a name that does not
        /// exist.
        now glAreTexturesResident | glAreTexturesResidentEXT are_textures_resident(n: i32,
            textures: (slice u32: count(n)), residences: (out u8: count(n))) -> bool;
        /// Writes a texture image under the pack state (section 6.1.4).
        now glGetTexImage get_tex_image(target: enum, level: i32, format: enum, type_: enum,
            pixels: (tex_out target, level, format, type_));
        /// Writes a compressed texture image as it was given (section 6.1.4). `INVALID_OPERATION` if it is not compressed.
        now glGetCompressedTexImage | glGetCompressedTexImageARB get_compressed_tex_image(target: enum, level: i32,
            image: (bytes_out compressed_size(target, level)));
    }
    queries {
        family "A parameter of the texture that is bound to a target (section 6.1.3)." {
            glGetTexParameteriv get_tex_parameteriv(target: enum, pname: enum) -> i32 => get_tex_parameter(target, pname);
            glGetTexParameterfv get_tex_parameterfv(target: enum, pname: enum) -> f32 => get_tex_parameter(target, pname);
        }
        family "A property of a texture image, or of a proxy (section 6.1.3)." {
            glGetTexLevelParameteriv get_tex_level_parameteriv(target: enum, level: i32, pname: enum) -> i32 => get_tex_level_parameter(target, level, pname);
            glGetTexLevelParameterfv get_tex_level_parameterfv(target: enum, level: i32, pname: enum) -> f32 => get_tex_level_parameter(target, level, pname);
        }
        family "A parameter of the texture environment (section 6.1.3)." {
            glGetTexEnviv get_tex_enviv(target: enum, pname: enum) -> i32 => get_tex_env(target, pname);
            glGetTexEnvfv get_tex_envfv(target: enum, pname: enum) -> f32 => get_tex_env(target, pname);
        }
    }
    answers {
        get_tex_parameter(target: enum, pname: enum);
        get_tex_level_parameter(target: enum, level: i32, pname: enum);
        get_tex_env(target: enum, pname: enum);
    }
    manual {}
} } }

pub(crate) use texture_table;
