//! What becomes of the vertex stages (OpenGL 1.5, sections 2.10 to 2.14) in a state: a row says which steps of the plan
//! do a stage's work, why it is there, and why it is not. The plan itself decides; this file only puts it in words.

use crate::fragment::program::{Decision, Fate};
use crate::simd::Stage;
use crate::state::State;
use crate::vertex::plan::VertexPlan;
use crate::vertex::stages::VertFn;
use crate::vertex::stages::lighting::{LIGHT_CLEAR, LIGHT_DIFFUSE, LIGHT_LOCAL, LIGHT_SPECULAR};
use crate::vertex::stages::normal::{NORMAL, NORMAL_UNIT};
use crate::vertex::stages::tex_coord::{
    GEN_EYE, GEN_NORMAL, GEN_OBJECT, GEN_REFLECTION, GEN_SPHERE, REFLECTION, TEX_MATRIX,
};
use crate::vertex::stages::transform::{EYE, EYE_POINT, POINT_DISTANCE, USER_PLANE};

/// A stage in words.
struct Row {
    stage: &'static str,
    /// Those that do its work.
    steps: &'static [&'static Stage<VertFn>],
    kept: &'static str,
    left_out: fn(&State) -> &'static str,
}

/// Why lighting is not computed.
fn unlit(state: &State) -> &'static str {
    if state.lighting.enabled { "no fragment stage reads a colour" } else { "GL_LIGHTING is off" }
}

/// Why a term of lighting is not computed.
fn no_light_term(state: &State) -> &'static str {
    if !state.lighting.enabled {
        "GL_LIGHTING is off"
    } else if !state.lighting.lights.iter().any(|light| light.enabled) {
        "no light is on"
    } else {
        "its product is exactly black, or nothing reads a colour"
    }
}

static ROWS: &[Row] = &[
    Row {
        stage: "eye coordinates",
        steps: &[&EYE, &EYE_POINT],
        kept: "lighting, generation, fog or a clip plane needs them",
        left_out: |_| "nothing needs them: positions go to clip coordinates by one matrix",
    },
    Row {
        stage: "clip planes of the user",
        steps: &[&USER_PLANE],
        kept: "a GL_CLIP_PLANE is on",
        left_out: |_| "no GL_CLIP_PLANE is on",
    },
    Row {
        stage: "normals",
        steps: &[&NORMAL, &NORMAL_UNIT],
        kept: "a light or a generated coordinate needs them",
        left_out: |_| "no light and no generated coordinate needs them",
    },
    Row {
        stage: "reflection vectors",
        steps: &[&REFLECTION],
        kept: "a sphere map or a reflection map is generated",
        left_out: |_| "no sphere map and no reflection map is generated",
    },
    Row { stage: "lighting", steps: &[&LIGHT_CLEAR], kept: "GL_LIGHTING is on", left_out: unlit },
    Row {
        stage: "attenuation and spots",
        steps: &[&LIGHT_LOCAL],
        kept: "a light has a position, an attenuation or a cutoff",
        left_out: |state| match state.lighting.enabled {
            true => "every light is directional, not attenuated and no spot",
            false => "GL_LIGHTING is off",
        },
    },
    Row {
        stage: "diffuse light",
        steps: &[&LIGHT_DIFFUSE],
        kept: "a light and the material have a diffuse or specular colour",
        left_out: no_light_term,
    },
    Row {
        stage: "specular light",
        steps: &[&LIGHT_SPECULAR],
        kept: "a light and the material have a specular colour",
        left_out: no_light_term,
    },
    Row {
        stage: "texture generation",
        steps: &[&GEN_OBJECT, &GEN_EYE, &GEN_SPHERE, &GEN_REFLECTION, &GEN_NORMAL],
        kept: "a GL_TEXTURE_GEN coordinate that the target uses is on",
        left_out: |_| "no generated coordinate is used",
    },
    Row {
        stage: "texture matrices",
        steps: &[&TEX_MATRIX],
        kept: "a unit's matrix is not the identity",
        left_out: |_| "no unit that is used has a matrix other than the identity",
    },
    Row {
        stage: "point size by distance",
        steps: &[&POINT_DISTANCE],
        kept: "the distance attenuation of points is not 1, 0, 0",
        left_out: |_| "the distance attenuation of points is 1, 0, 0",
    },
];

/// A line for each stage.
pub(super) fn decisions(state: &State, plan: &VertexPlan) -> Vec<Decision> {
    let runs = |row: &Row| {
        let mut steps = plan.plan.steps.iter();
        steps.any(|step| row.steps.iter().any(|stage| step.is(stage)))
    };
    let line = |row: &Row| {
        let kept = runs(row);
        Decision {
            stage: row.stage.into(),
            fate: if kept { Fate::Kept } else { Fate::LeftOut },
            reason: if kept { row.kept } else { (row.left_out)(state) }.into(),
        }
    };
    ROWS.iter().map(line).collect()
}
