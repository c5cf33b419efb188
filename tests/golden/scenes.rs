//! The table of scenes: every port of examples/ with its name, size, caption and the calls that matter. The gallery draws
//! it, the golden tests compare its bytes, the invariance tests run it at every level, thread count and batch cut.

/// A picture that a GL program draws.
#[derive(Clone, Copy)]
pub struct Scene {
    /// Name of the example program.
    pub name: &'static str,
    /// Width and height of the framebuffer.
    pub size: [u32; 2],
    /// What the picture shows, in a sentence.
    #[allow(dead_code, reason = "the tests do not print it")]
    pub caption: &'static str,
    /// The GL calls that make it so.
    #[allow(dead_code, reason = "the tests do not print them")]
    pub calls: &'static [&'static str],
    /// Draws into the current context.
    pub draw: fn(),
}

macro_rules! scenes {
    ($($name:ident = $path:literal;)*) => {
        $(#[path = $path] mod $name;)*
        /// All scenes.
        pub const SCENES: &[Scene] = &[$(Scene {
            name: $name::NAME,
            size: $name::SIZE,
            caption: $name::CAPTION,
            calls: $name::CALLS,
            draw: $name::draw,
        }),*];
    };
}

scenes! {
    checker = "../../examples/checker.rs";
    mipmap = "../../examples/mipmap.rs";
    texbind = "../../examples/texbind.rs";
    texsub = "../../examples/texsub.rs";
    texprox = "../../examples/texprox.rs";
    wrap = "../../examples/wrap.rs";
    texgen = "../../examples/texgen.rs";
    texture3d = "../../examples/texture3d.rs";
    cubemap = "../../examples/cubemap.rs";
    multitex = "../../examples/multitex.rs";
    combiner = "../../examples/combiner.rs";
    shadowmap = "../../examples/shadowmap.rs";
    texenv = "../../examples/texenv.rs";
    projtex = "../../examples/projtex.rs";
    reflect = "../../examples/reflect.rs";
    lodbias = "../../examples/lodbias.rs";
}
