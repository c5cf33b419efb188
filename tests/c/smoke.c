/* A small program for the C door: OSMesa + GL 1.5 + GLU as any C program would use them, linked against the shared
 * library with the ordinary headers. It draws in several formats, asks for state, makes lists, textures, mipmaps and
 * errors, and prints what went wrong; the exit code is the number of failed checks. With a file name as its argument it
 * writes the picture of a textured sphere there. See the script "run" beside it.
 */
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glu.h>
#include <GL/osmesa.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failed;
#define CHECK(what) \
    do { \
        if (!(what)) { failed++; fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #what); } \
    } while (0)

enum { W = 37, H = 23 };

static void quad(float x0, float y0, float x1, float y1) {
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0); glVertex2f(x0, y0);
    glTexCoord2f(1, 0); glVertex2f(x1, y0);
    glTexCoord2f(1, 1); glVertex2f(x1, y1);
    glTexCoord2f(0, 1); glVertex2f(x0, y1);
    glEnd();
}

/* Red below, green above: which end of the memory is which? */
static void two_halves(void) {
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, W, H / 2);
    glClearColor(1, 0, 0, 0.2f);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glFinish();
}

static void state(void) {
    GLint viewport[4], units = 0;
    GLfloat m[16], color[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    CHECK(viewport[0] == 0 && viewport[1] == 0 && viewport[2] == W && viewport[3] == H);
    glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
    CHECK(units >= 2);
    CHECK(glGetString(GL_VERSION) && strncmp((const char *)glGetString(GL_VERSION), "1.5", 3) == 0);
    CHECK(glGetString(GL_VERSION) == glGetString(GL_VERSION));
    CHECK(strlen((const char *)glGetString(GL_EXTENSIONS)) > 0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(1, 2, 3);
    glGetFloatv(GL_MODELVIEW_MATRIX, m);
    CHECK(m[12] == 1 && m[13] == 2 && m[14] == 3 && m[15] == 1);
    glLoadIdentity();
    glColor3ub(255, 0, 51);
    glGetFloatv(GL_CURRENT_COLOR, color);
    CHECK(color[0] == 1 && color[1] == 0 && fabs(color[2] - 0.2) < 1e-6 && color[3] == 1);
    CHECK(glGetError() == GL_NO_ERROR);
}

static void errors(void) {
    glEnable(0x1234);
    glMatrixMode(GL_LINES);
    glViewport(0, 0, -1, 1);
    CHECK(glGetError() == GL_INVALID_ENUM);
    CHECK(glGetError() == GL_NO_ERROR);
    glBegin(GL_TRIANGLES);
    glEnable(GL_DEPTH_TEST);
    glEnd();
    CHECK(glGetError() == GL_INVALID_OPERATION);
    CHECK(!glIsEnabled(GL_DEPTH_TEST));
    glGenTextures(-1, NULL);
    CHECK(glGetError() == GL_INVALID_VALUE);
}

static void lists(void) {
    GLubyte two[2] = {0, 1};
    GLint base = (GLint)glGenLists(3);
    CHECK(base != 0 && glIsList((GLuint)base));
    glNewList((GLuint)base, GL_COMPILE);
    glEnable(GL_BLEND);
    glEndList();
    CHECK(!glIsEnabled(GL_BLEND));
    glNewList((GLuint)base + 1, GL_COMPILE);
    glEnable(GL_FOG);
    glEndList();
    glListBase((GLuint)base);
    glCallLists(2, GL_UNSIGNED_BYTE, two);
    CHECK(glIsEnabled(GL_BLEND) && glIsEnabled(GL_FOG));
    glDisable(GL_BLEND);
    glDisable(GL_FOG);
    glDeleteLists((GLuint)base, 3);
    CHECK(!glIsList((GLuint)base));
    CHECK(glGetError() == GL_NO_ERROR);
}

static void textures(const GLubyte *picture) {
    static const GLubyte texels[2][2][3] = {{{255, 0, 0}, {0, 255, 0}}, {{0, 0, 255}, {255, 255, 255}}};
    GLubyte back[2][2][4];
    GLuint name = 0;
    GLint width = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, 3, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    CHECK(width == 2);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, back);
    CHECK(back[0][1][1] == 255 && back[1][0][2] == 255 && back[1][1][3] == 255);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    quad(-1, -1, 1, 1);
    glDisable(GL_TEXTURE_2D);
    glFinish();
    CHECK(picture[0] == 255 && picture[1] == 0 && picture[2] == 0);
    CHECK(picture[4 * (W - 1) + 1] == 255 && picture[4 * (W - 1)] == 0);
    CHECK(picture[4 * (W * (H - 1)) + 2] == 255 && picture[4 * (W * (H - 1))] == 0);
    glDeleteTextures(1, &name);
    CHECK(glGetError() == GL_NO_ERROR);
}

static void arrays(const GLubyte *picture) {
    /* x, y, unused, red, green, blue, alpha, unused */
    static const GLfloat vertices[] = {-1, -1, 9, 0, 1, 1, 0, 9, 3, -1, 9, 0, 1, 1, 0, 9, -1, 3, 9, 0, 1, 1, 0, 9};
    static const GLushort indices[] = {0, 1, 2};
    GLuint buffers[2];
    GLubyte pixel[4];
    int use_buffers;
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    for (use_buffers = 0; use_buffers < 2; use_buffers++) {
        const char *base = (const char *)vertices;
        const void *list = indices;
        if (use_buffers) {
            glGenBuffers(2, buffers);
            glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
            glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
            glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
            glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
            base = NULL;
            list = NULL;
        }
        glVertexPointer(2, GL_FLOAT, 32, base);
        glColorPointer(4, GL_FLOAT, 32, base + 12);
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
        glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, list);
        glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        CHECK(pixel[0] == 0 && pixel[1] == 255 && pixel[2] == 255 && pixel[3] == 0);
        CHECK(memcmp(picture + 4 * (3 * W + 3), pixel, 4) == 0);
        if (use_buffers) {
            GLfloat *mapped = glMapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
            CHECK(mapped && mapped[4] == 1 && mapped[8] == 3);
            CHECK(glUnmapBuffer(GL_ARRAY_BUFFER));
            glDeleteBuffers(2, buffers);
        }
    }
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
    CHECK(glGetError() == GL_NO_ERROR);
}

/* GLU: a square with a bow tie as its hole, which crosses itself. */
static int tess_vertices, tess_flagged, tess_combined, tess_errors;
static GLboolean tess_boundary;
static void tess_begin(GLenum mode, void *data) { CHECK(mode == GL_TRIANGLES && data == &tess_vertices); }
static void tess_flag(GLboolean flag) { tess_boundary = flag; }
static void tess_vertex(void *vertex) {
    tess_vertices += vertex != NULL;
    tess_flagged += tess_boundary;
}
static void tess_error(GLenum error) { tess_errors += error == GLU_TESS_MISSING_END_CONTOUR; }
static void tess_combine(GLdouble position[3], void *data[4], GLfloat weight[4], void **out) {
    static GLdouble middle[3];
    int i;
    CHECK(data[0] && data[3] && weight[0] == 0.25f && weight[3] == 0.25f);
    for (i = 0; i < 3; i++) middle[i] = position[i];
    CHECK(middle[0] == 4 && middle[1] == 4);
    *out = middle;
    tess_combined++;
}

static void tessellator(void) {
    static GLdouble points[8][3] = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 2}, {6, 6}, {6, 2}, {2, 6}};
    GLUtesselator *tess = gluNewTess();
    GLdouble rule = 0;
    int i;
    CHECK(tess != NULL);
    gluTessCallback(tess, GLU_TESS_BEGIN_DATA, (_GLUfuncptr)tess_begin);
    gluTessCallback(tess, GLU_TESS_EDGE_FLAG, (_GLUfuncptr)tess_flag);
    gluTessCallback(tess, GLU_TESS_VERTEX, (_GLUfuncptr)tess_vertex);
    gluTessCallback(tess, GLU_TESS_ERROR, (_GLUfuncptr)tess_error);
    gluTessCallback(tess, GLU_TESS_COMBINE, (_GLUfuncptr)tess_combine);
    gluTessNormal(tess, 0, 0, 1);
    gluGetTessProperty(tess, GLU_TESS_WINDING_RULE, &rule);
    CHECK(rule == GLU_TESS_WINDING_ODD);
    gluTessBeginPolygon(tess, &tess_vertices);
    for (i = 0; i < 8; i++) {
        if (i % 4 == 0) gluTessBeginContour(tess);
        gluTessVertex(tess, points[i], points[i]);
        if (i == 3) gluTessEndContour(tess);
    }
    gluTessEndPolygon(tess);
    gluDeleteTess(tess);
    /* The hole is a way of six vertices, the middle twice: 4 + 6 - 2 + 2 triangles, all ten sides flagged. */
    CHECK(tess_combined == 1 && tess_errors == 1 && tess_flagged == 10);
    CHECK(tess_vertices == 3 * 10);
}

/* GLU: mipmaps, a camera, a textured and lit sphere. */
static void sphere(const char *file) {
    enum { SIZE = 192, TEXELS = 60 };
    static GLubyte picture[SIZE * SIZE * 4], texels[TEXELS * TEXELS * 3];
    static const GLfloat light[] = {-2, -4, 4, 1};
    GLUquadric *quadric = gluNewQuadric();
    OSMesaContext cx = OSMesaCreateContext(OSMESA_RGBA, NULL);
    GLint width = 0;
    GLdouble model[16], projection[16], x, y, z;
    GLint viewport[4];
    int i, covered = 0;
    CHECK(quadric && cx && OSMesaMakeCurrent(cx, picture, GL_UNSIGNED_BYTE, SIZE, SIZE));
    for (i = 0; i < TEXELS * TEXELS; i++) {
        int light_square = ((i % TEXELS / 6) ^ (i / TEXELS / 6)) & 1;
        texels[3 * i] = light_square ? 250 : 40;
        texels[3 * i + 1] = light_square ? 240 : 60;
        texels[3 * i + 2] = light_square ? 220 : 140;
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    CHECK(gluBuild2DMipmaps(GL_TEXTURE_2D, 3, TEXELS, TEXELS, GL_RGB, GL_UNSIGNED_BYTE, texels) == 0);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    CHECK(width == 64);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 6, GL_TEXTURE_WIDTH, &width);
    CHECK(width == 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(40, 1, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    gluLookAt(0, -3, 1.5, 0, 0, 0, 0, 0, 1);
    glGetDoublev(GL_MODELVIEW_MATRIX, model);
    glGetDoublev(GL_PROJECTION_MATRIX, projection);
    glGetIntegerv(GL_VIEWPORT, viewport);
    CHECK(gluProject(0, 0, 0, model, projection, viewport, &x, &y, &z) && fabs(x - SIZE / 2) < 1e-3);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    glClearColor(0.1f, 0.1f, 0.15f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gluQuadricTexture(quadric, GL_TRUE);
    gluSphere(quadric, 1, 48, 24);
    gluDeleteQuadric(quadric);
    glFinish();
    CHECK(glGetError() == GL_NO_ERROR);
    CHECK(strcmp((const char *)gluErrorString(GL_INVALID_ENUM), "") != 0);
    for (i = 0; i < SIZE * SIZE; i++) covered += picture[4 * i] != picture[0] || picture[4 * i + 2] != picture[2];
    /* The silhouette is a circle of about 0.93 times half the window's height: a third of the pixels at least. */
    CHECK(covered > SIZE * SIZE / 3 && covered < SIZE * SIZE * 4 / 5);
    if (file) {
        FILE *f = fopen(file, "wb");
        CHECK(f != NULL);
        if (f) {
            fprintf(f, "P6 %d %d 255\n", SIZE, SIZE);
            for (y = SIZE - 1; y >= 0; y--)
                for (i = 0; i < SIZE; i++) fwrite(picture + 4 * ((int)y * SIZE + i), 1, 3, f);
            fclose(f);
            printf("picture: %s\n", file);
        }
    }
    OSMesaDestroyContext(cx);
}

/* Formats, directions of rows and row lengths. */
static void formats(void) {
    static const struct { GLenum format, type; int bytes, r, g; } rows[] = {
        {OSMESA_RGBA, GL_UNSIGNED_BYTE, 4, 0, 1}, {OSMESA_BGRA, GL_UNSIGNED_BYTE, 4, 2, 1},
        {OSMESA_ARGB, GL_UNSIGNED_BYTE, 4, 1, 2}, {OSMESA_RGB, GL_UNSIGNED_BYTE, 3, 0, 1},
        {OSMESA_BGR, GL_UNSIGNED_BYTE, 3, 2, 1},  {OSMESA_RGBA, GL_UNSIGNED_SHORT, 8, 0, 1},
        {OSMESA_RGBA, GL_FLOAT, 16, 0, 1},
    };
    size_t i;
    int up, length;
    for (i = 0; i < sizeof rows / sizeof rows[0]; i++)
        for (up = 0; up < 2; up++)
            for (length = 0; length <= W + 5; length += W + 5) {
                int stride = (length ? length : W) * rows[i].bytes, one = rows[i].type == GL_UNSIGNED_BYTE ? 255 : 0;
                GLubyte *memory = calloc((size_t)stride, H), *red, *green;
                OSMesaContext cx = OSMesaCreateContextExt(rows[i].format, 16, 0, 0, NULL);
                GLint got = 0;
                CHECK(cx && OSMesaMakeCurrent(cx, memory, rows[i].type, W, H));
                OSMesaPixelStore(OSMESA_Y_UP, up);
                OSMesaPixelStore(OSMESA_ROW_LENGTH, length);
                two_halves();
                red = memory + (up ? 0 : (H - 1) * stride);
                green = memory + (up ? (H - 1) * stride : 0);
                if (one) {
                    CHECK(red[rows[i].r] == 255 && red[rows[i].g] == 0);
                    CHECK(green[rows[i].r] == 0 && green[rows[i].g] == 255);
                } else if (rows[i].type == GL_FLOAT) {
                    CHECK(((GLfloat *)red)[0] == 1 && ((GLfloat *)green)[1] == 1 && ((GLfloat *)green)[0] == 0);
                } else {
                    CHECK(((GLushort *)red)[0] == 65535 && ((GLushort *)green)[1] == 65535);
                }
                if (length) CHECK(memory[W * rows[i].bytes] == 0);
                OSMesaGetIntegerv(OSMESA_FORMAT, &got);
                CHECK(got == (GLint)rows[i].format);
                OSMesaGetIntegerv(OSMESA_Y_UP, &got);
                CHECK(got == up);
                OSMesaDestroyContext(cx);
                CHECK(OSMesaGetCurrentContext() == NULL);
                free(memory);
            }
}

int main(int argc, char **argv) {
    static GLubyte picture[W * H * 4];
    GLint w, h, bytes, format;
    void *buffer;
    OSMesaContext cx;
    glEnable(GL_BLEND); /* no context: nothing happens */
    CHECK(glGetError() == GL_NO_ERROR && glGetString(GL_VERSION) == NULL);
    CHECK(OSMesaCreateContext(0x9999, NULL) == NULL);
    cx = OSMesaCreateContext(OSMESA_RGBA, NULL);
    CHECK(cx && OSMesaMakeCurrent(cx, picture, GL_UNSIGNED_BYTE, W, H));
    CHECK(OSMesaGetCurrentContext() == cx);
    CHECK(!OSMesaMakeCurrent(cx, picture, GL_UNSIGNED_BYTE, 0, H) && !OSMesaMakeCurrent(cx, picture, GL_INT, W, H));
    CHECK(OSMesaGetProcAddress("glActiveTextureARB") == (OSMESAproc)glActiveTextureARB);
    CHECK(OSMesaGetProcAddress("glNoSuchThing") == NULL);
    CHECK(OSMesaGetProcAddress("OSMesaMakeCurrent") == (OSMESAproc)(void *)OSMesaMakeCurrent);
    state();
    errors();
    lists();
    two_halves();
    CHECK(picture[0] == 255 && picture[3] == 51 && picture[4 * W * (H - 1) + 1] == 255);
    CHECK(OSMesaGetDepthBuffer(cx, &w, &h, &bytes, &buffer) && w == W && h == H && bytes == 4);
    CHECK(((GLuint *)buffer)[0] == 0xFFFFFF);
    CHECK(OSMesaGetColorBuffer(cx, &w, &h, &format, &buffer) && buffer == picture && format == OSMESA_RGBA);
    textures(picture);
    arrays(picture);
    OSMesaDestroyContext(cx);
    formats();
    tessellator();
    sphere(argc > 1 ? argv[1] : NULL);
    if (failed) fprintf(stderr, "%d checks failed\n", failed);
    else puts("C door: all checks hold");
    return failed;
}
