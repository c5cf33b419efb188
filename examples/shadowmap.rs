//! Shadows by a depth texture (after the Red Book's `shadowmap`): the scene is drawn from the light, its depths are copied
//! into a texture, and when the scene is drawn from the eye, texture coordinates generated in eye space say where each
//! point lies for the light and how far it is; the comparison decides whether the light reaches it.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;

support::port!(
    "shadowmap",
    [512, 512],
    "A torus and a cube throw shadows: a depth texture copied from the light's view and compared with r.",
    [
        "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, 256, 256, 0)",
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE)",
        "glTexGenfv(GL_R, GL_EYE_PLANE, &row)",
    ]
);

const MAP: GLsizei = 256;
const LIGHT: [GLfloat; 4] = [25.0, 25.0, 25.0, 1.0];

fn objects() {
    glColor3f(0.85, 0.8, 0.7);
    glNormal3f(0.0, 0.0, 1.0);
    glRectf(-20.0, -20.0, 20.0, 20.0);

    glColor3f(0.9, 0.4, 0.3);
    glPushMatrix();
    glTranslatef(3.0, 6.0, 8.0);
    glRotatef(40.0, 1.0, 0.3, 0.0);
    support::shapes::solid_torus(1.6, 5.0, 24, 40);
    glPopMatrix();

    glColor3f(0.35, 0.55, 0.9);
    glPushMatrix();
    glTranslatef(-8.0, -7.0, 5.5);
    glRotatef(30.0, 0.2, 0.3, 1.0);
    support::shapes::solid_cube(7.0);
    glPopMatrix();
}

fn light_view() {
    gluLookAt(25.0, 25.0, 25.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0);
}

fn make_shadow_map() {
    glViewport(0, 0, MAP, MAP);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(55.0, 1.0, 15.0, 70.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    light_view();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPolygonOffset(2.0, 4.0);
    glEnable(GL_POLYGON_OFFSET_FILL);
    objects();
    glDisable(GL_POLYGON_OFFSET_FILL);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, MAP, MAP, 0);
}

/// Rows of bias x projection x view of the light, as eye planes.
fn generate_texture_coordinates() {
    let mut m: [GLfloat; 16] = [0.0; 16];
    glPushMatrix();
    glLoadIdentity();
    glTranslatef(0.5, 0.5, 0.5);
    glScalef(0.5, 0.5, 0.5);
    gluPerspective(55.0, 1.0, 15.0, 70.0);
    light_view();
    glGetFloatv(GL_TRANSPOSE_MODELVIEW_MATRIX, &mut m);
    glPopMatrix();
    for (i, (coord, cap)) in
        [(GL_S, GL_TEXTURE_GEN_S), (GL_T, GL_TEXTURE_GEN_T), (GL_R, GL_TEXTURE_GEN_R), (GL_Q, GL_TEXTURE_GEN_Q)]
            .into_iter()
            .enumerate()
    {
        glTexGeni(coord, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
        glTexGenfv(coord, GL_EYE_PLANE, &m[4 * i..4 * i + 4]);
        glEnable(cap);
    }
}

fn init() {
    let mut name: GLuint = 0;
    glGenTextures(1, &mut name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_LUMINANCE);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, &[0.1, 0.1, 0.1, 1.0]);
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    init();
    make_shadow_map();
    support::reshape(45.0, SIZE, 10.0, 150.0);
    gluLookAt(-10.0, -45.0, 45.0, 0.0, 0.0, 2.0, 0.0, 0.0, 1.0);
    glClearColor(0.25, 0.3, 0.4, 1.0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_LIGHTING);
    // Once with little light for everything, once with the full light where it arrives.
    glLightfv(GL_LIGHT0, GL_POSITION, &LIGHT);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, &[0.2, 0.2, 0.25, 1.0]);
    objects();
    glLightfv(GL_LIGHT0, GL_DIFFUSE, &[0.9, 0.9, 0.85, 1.0]);
    generate_texture_coordinates();
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDepthFunc(GL_EQUAL);
    objects();
    glFlush();
}
