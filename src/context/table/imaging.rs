//! Chapter of the table: the optional imaging subset (OpenGL 1.5, sections 3.6.3 and 6.1.7 to 6.1.10): colour tables,
//! convolution, histogram and minmax. The C headers declare these commands, so a program may link against them.

macro_rules! imaging_table { ($generate:ident) => { $generate! {
    title "The imaging subset (section 3.6)";
    canonical {
        list ColorTableParameter color_table_parameter(target: enum, pname: enum, params: params);
        list ConvolutionParameter convolution_parameter(target: enum, pname: enum, params: params);
    }
    commands {
        /// Specifies a colour table (section 3.6.3). A proxy target only asks whether it would fit.
        proxy glColorTable | glColorTableEXT | glColorTableSGI color_table(target: enum, internal_format: enum, width: i32,
            format: enum, type_: enum, table: (rect [width, 1], format, type_));
        /// Replaces a part of a colour table (section 3.6.3).
        list glColorSubTable | glColorSubTableEXT color_sub_table(target: enum, start: i32, count: i32, format: enum,
            type_: enum, data: (rect [count, 1], format, type_));
        /// Makes a colour table of pixels of the read buffer (section 3.6.3).
        list glCopyColorTable | glCopyColorTableSGI copy_color_table(target: enum, internal_format: enum, x: i32, y: i32,
            width: i32);
        /// Replaces a part of a colour table by pixels of the read buffer (section 3.6.3).
        list glCopyColorSubTable | glCopyColorSubTableEXT copy_color_sub_table(target: enum, start: i32, x: i32, y: i32,
            width: i32);
        /// Specifies a one-dimensional convolution filter (section 3.6.3).
        list glConvolutionFilter1D | glConvolutionFilter1DEXT convolution_filter_1d(target: enum, internal_format: enum,
            width: i32, format: enum, type_: enum, image: (rect [width, 1], format, type_));
        /// Specifies a two-dimensional convolution filter (section 3.6.3).
        list glConvolutionFilter2D | glConvolutionFilter2DEXT convolution_filter_2d(target: enum, internal_format: enum,
            width: i32, height: i32, format: enum, type_: enum, image: (rect [width, height], format, type_));
        /// Specifies a separable convolution filter (section 3.6.3).
        list glSeparableFilter2D | glSeparableFilter2DEXT separable_filter_2d(target: enum, internal_format: enum,
            width: i32, height: i32, format: enum, type_: enum, row: (rect [width, 1], format, type_),
            column: (rect [height, 1], format, type_));
        /// Makes a one-dimensional convolution filter of pixels of the read buffer (section 3.6.3).
        list glCopyConvolutionFilter1D | glCopyConvolutionFilter1DEXT copy_convolution_filter_1d(target: enum,
            internal_format: enum, x: i32, y: i32, width: i32);
        /// Makes a two-dimensional convolution filter of pixels of the read buffer (section 3.6.3).
        list glCopyConvolutionFilter2D | glCopyConvolutionFilter2DEXT copy_convolution_filter_2d(target: enum,
            internal_format: enum, x: i32, y: i32, width: i32, height: i32);
        /// Specifies a histogram (section 3.6.3). A proxy target only asks whether it would fit.
        proxy glHistogram | glHistogramEXT histogram(target: enum, width: i32, internal_format: enum, sink: bool);
        /// Sets all counters of a histogram to 0 (section 6.1.9).
        list glResetHistogram | glResetHistogramEXT reset_histogram(target: enum);
        /// Specifies the minmax table (section 3.6.3).
        list glMinmax | glMinmaxEXT minmax(target: enum, internal_format: enum, sink: bool);
        /// Resets the minmax table (section 6.1.10).
        list glResetMinmax | glResetMinmaxEXT reset_minmax(target: enum);
    }
    forms {
        family "Sets scale or bias of a colour table (section 3.6.3)." {
            list glColorTableParameteriv | glColorTableParameterivSGI color_table_parameteriv(target: enum, pname: enum,
                params: (upto i32: imaging_parameter(pname)))
                => color_table_parameter(target, pname, &Params::ints(params));
            list glColorTableParameterfv | glColorTableParameterfvSGI color_table_parameterfv(target: enum, pname: enum,
                params: (upto f32: imaging_parameter(pname)))
                => color_table_parameter(target, pname, &Params::floats(params));
        }
        family "Sets scale, bias or border of convolution (section 3.6.3)." {
            list glConvolutionParameteri | glConvolutionParameteriEXT convolution_parameteri(target: enum, pname: enum, param: i32) => convolution_parameter(target, pname, &Params::int(param));
            list glConvolutionParameterf | glConvolutionParameterfEXT convolution_parameterf(target: enum, pname: enum, param: f32) => convolution_parameter(target, pname, &Params::float(param));
            list glConvolutionParameteriv | glConvolutionParameterivEXT convolution_parameteriv(target: enum, pname: enum, params: (upto i32: imaging_parameter(pname))) => convolution_parameter(target, pname, &Params::ints(params));
            list glConvolutionParameterfv | glConvolutionParameterfvEXT convolution_parameterfv(target: enum, pname: enum, params: (upto f32: imaging_parameter(pname))) => convolution_parameter(target, pname, &Params::floats(params));
        }
    }
    context {}
    now {
        /// Writes a colour table under the pack state (section 6.1.7).
        now glGetColorTable | glGetColorTableEXT | glGetColorTableSGI get_color_table(target: enum, format: enum,
            type_: enum, table: (imaging_out target, format, type_));
        /// Writes a convolution filter under the pack state (section 6.1.8).
        now glGetConvolutionFilter | glGetConvolutionFilterEXT get_convolution_filter(target: enum, format: enum,
            type_: enum, image: (imaging_out target, format, type_));
        /// Writes both parts of a separable filter under the pack state (section 6.1.8).
        now glGetSeparableFilter | glGetSeparableFilterEXT get_separable_filter(target: enum, format: enum, type_: enum,
            row: (imaging_out target, format, type_),
            column: (imaging_out crate::context::imaging_tables::COLUMN, format, type_), span: (bytes_out 0));
        /// Writes a histogram under the pack state (section 6.1.9).
        now glGetHistogram | glGetHistogramEXT get_histogram(target: enum, reset: bool, format: enum, type_: enum,
            values: (imaging_out target, format, type_));
        /// Writes the minmax table under the pack state (section 6.1.10).
        now glGetMinmax | glGetMinmaxEXT get_minmax(target: enum, reset: bool, format: enum, type_: enum,
            values: (rect_out [2, 1], format, type_));
    }
    queries {
        family "A property of a colour table (section 6.1.7)." {
            glGetColorTableParameteriv | glGetColorTableParameterivEXT | glGetColorTableParameterivSGI get_color_table_parameteriv(target: enum, pname: enum) -> i32
                => get_color_table_parameter(target, pname);
            glGetColorTableParameterfv | glGetColorTableParameterfvEXT | glGetColorTableParameterfvSGI get_color_table_parameterfv(target: enum, pname: enum) -> f32
                => get_color_table_parameter(target, pname);
        }
        family "A property of a convolution filter (section 6.1.8)." {
            glGetConvolutionParameteriv | glGetConvolutionParameterivEXT get_convolution_parameteriv(target: enum, pname: enum) -> i32
                => get_convolution_parameter(target, pname);
            glGetConvolutionParameterfv | glGetConvolutionParameterfvEXT get_convolution_parameterfv(target: enum, pname: enum) -> f32
                => get_convolution_parameter(target, pname);
        }
        family "A property of a histogram (section 6.1.9)." {
            glGetHistogramParameteriv | glGetHistogramParameterivEXT get_histogram_parameteriv(target: enum, pname: enum) -> i32
                => get_histogram_parameter(target, pname);
            glGetHistogramParameterfv | glGetHistogramParameterfvEXT get_histogram_parameterfv(target: enum, pname: enum) -> f32
                => get_histogram_parameter(target, pname);
        }
        family "A property of the minmax table (section 6.1.10)." {
            glGetMinmaxParameteriv | glGetMinmaxParameterivEXT get_minmax_parameteriv(target: enum, pname: enum) -> i32
                => get_minmax_parameter(target, pname);
            glGetMinmaxParameterfv | glGetMinmaxParameterfvEXT get_minmax_parameterfv(target: enum, pname: enum) -> f32
                => get_minmax_parameter(target, pname);
        }
    }
    answers {
        get_color_table_parameter(target: enum, pname: enum);
        get_convolution_parameter(target: enum, pname: enum);
        get_histogram_parameter(target: enum, pname: enum);
        get_minmax_parameter(target: enum, pname: enum);
    }
    manual {}
} } }

pub(crate) use imaging_table;
