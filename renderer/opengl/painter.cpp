#include "renderer/opengl/painter.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "renderer/error.hpp"

namespace byhand::renderer {
namespace {

constexpr int shadow_side = 512, soft_level = 2, soft_side = shadow_side >> soft_level;  // pixels

// The page is drawn upside down, because glReadPixels returns the lowest row first.
constexpr const char* flat_vertex = R"(#version 330 core
layout(location = 0) in vec2 place;
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 colour;
uniform vec2 page;
out vec2 uv;
out vec4 tint;
void main() {
  gl_Position = vec4(2.0 * place / page - 1.0, 0.0, 1.0);
  uv = texel;
  tint = colour;
})";

constexpr const char* flat_fragment = R"(#version 330 core
in vec2 uv;
in vec4 tint;
uniform sampler2D atlas;
out vec4 colour;
void main() {
  float cover = uv.x < 0.0 ? 1.0 : texelFetch(atlas, ivec2(uv), 0).r;
  colour = vec4(tint.rgb, tint.a * cover);
})";

constexpr const char* solid_vertex = R"(#version 330 core
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;
uniform mat4 view;
out vec3 world, facing;
out vec3 tint;
void main() {
  gl_Position = view * vec4(place, 1.0);
  gl_Position.y = -gl_Position.y;
  world = place;
  facing = normal;
  tint = colour.rgb;
})";

constexpr const char* solid_fragment = R"(#version 330 core
in vec3 world, facing;
in vec3 tint;
uniform vec3 eye, light;
out vec4 colour;
void main() {
  vec3 n = normalize(facing), to_eye = normalize(eye - world);
  float sun = max(dot(n, light), 0.0), sky = 0.5 + 0.5 * dot(n, light);
  float shine = pow(max(dot(n, normalize(light + to_eye)), 0.0), 40.0);
  colour = vec4(tint * (0.42 + 0.24 * sky + 0.40 * sun) + 0.16 * shine, 1.0);
})";

// Planar shadows: projects the solids along the light onto the ground; white in shadow.
constexpr const char* caster_vertex = R"(#version 330 core
layout(location = 0) in vec3 place;
uniform vec3 centre, up, light, along, across;
uniform float extent;
void main() {
  vec3 r = place - centre;
  vec3 fallen = r - light * (max(dot(r, up), 0.0) / dot(light, up));
  gl_Position = vec4(dot(fallen, along) / extent, dot(fallen, across) / extent, 0.0, 1.0);
})";

constexpr const char* caster_fragment = R"(#version 330 core
out vec4 colour;
void main() { colour = vec4(1.0); })";

// Softens the edges of shadows, here rather than at each pixel of the floor: that would take most of a frame's
// time.
constexpr const char* softener_vertex = R"(#version 330 core
void main() { gl_Position = vec4(4.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0, 0.0, 1.0); })";

constexpr const char* softener_fragment = R"(#version 330 core
uniform sampler2D shadows;
uniform int level;
out vec4 colour;
void main() {
  ivec2 last = textureSize(shadows, level) - 1;
  float shadow = 0.0;
  const float weight[5] = float[](0.0625, 0.25, 0.375, 0.25, 0.0625);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      shadow += weight[i] * weight[j] *
                texelFetch(shadows, clamp(ivec2(gl_FragCoord.xy) + ivec2(i - 2, j - 2), ivec2(0), last), level).r;
  colour = vec4(shadow);
})";

constexpr const char* floor_vertex = R"(#version 330 core
uniform mat4 view;
uniform vec3 centre, along, across;
uniform float extent;
out vec2 place;
void main() {
  place = extent * (2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0);
  gl_Position = view * vec4(centre + place.x * along + place.y * across, 1.0);
  gl_Position.y = -gl_Position.y;
})";

constexpr const char* floor_fragment = R"(#version 330 core
in vec2 place;
uniform float extent, spacing, rim;
uniform vec4 frame;
uniform vec3 paper, line, dark;
uniform sampler2D shadows;
out vec4 colour;
void main() {
  vec2 cell = place / spacing, width = 1.3 * fwidth(cell);
  vec2 near = 1.0 - smoothstep(0.5 * width, 1.1 * width, abs(fract(cell - 0.5) - 0.5));
  float r = length(place) / extent, fading = 1.0 - smoothstep(0.55, 1.0, r);
  vec2 inward = min(gl_FragCoord.xy - frame.xy, frame.zw - gl_FragCoord.xy) / rim;
  fading *= smoothstep(0.0, 1.0, min(inward.x, inward.y));
  vec2 uv = 0.5 + 0.5 * place / extent;
  float shadow = textureLod(shadows, uv, 0.0).r;
  vec3 c = mix(paper, line, 0.85 * max(near.x, near.y));
  colour = vec4(mix(paper, mix(c, dark, 0.42 * shadow), fading), 1.0);
})";

GLuint compile(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint fine = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &fine);
  if (!fine) {
    std::array<char, 1024> log{};
    glGetShaderInfoLog(shader, GLsizei(log.size()), nullptr, log.data());
    throw Unavailable(fmt::format("OpenGL does not compile the renderer's program: {}", log.data()));
  }
  return shader;
}

GLuint link(const char* vertex, const char* fragment) {
  const GLuint program = glCreateProgram(), v = compile(GL_VERTEX_SHADER, vertex),
               f = compile(GL_FRAGMENT_SHADER, fragment);
  glAttachShader(program, v);
  glAttachShader(program, f);
  glLinkProgram(program);
  glDeleteShader(v);
  glDeleteShader(f);
  GLint fine = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &fine);
  if (!fine) throw Unavailable("OpenGL does not link the renderer's program.");
  return program;
}

void require_complete() {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Unavailable("OpenGL does not offer the framebuffer that the renderer draws into.");
}

void attribute(GLuint index, GLint size, GLenum type, bool normalised, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  const void* place = reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr): so OpenGL asks
  glVertexAttribPointer(index, size, type, normalised, GLsizei(stride), place);
}

void set(GLuint program, const char* name, double value) {
  glUniform1f(glGetUniformLocation(program, name), float(value));
}

void set(GLuint program, const char* name, const Point3& v) {
  glUniform3f(glGetUniformLocation(program, name), float(v.x()), float(v.y()), float(v.z()));
}

void set(GLuint program, const char* name, Colour c) { set(program, name, Point3(c.r, c.g, c.b) / 255); }

void set(GLuint program, const char* name, const std::array<std::array<double, 4>, 4>& columns) {
  std::array<float, 16> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(columns[i / 4][i % 4]);
  glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, values.data());
}

void clear(Colour c) { glClearColor(c.r / 255.0f, c.g / 255.0f, c.b / 255.0f, 1); }

}  // namespace

Painter::Painter(int width, int height)
    : width_(width), height_(height), context_(Context::make()), description_(renderer::describe(*context_)) {
  glGenTextures(1, &page_colour_);
  glBindTexture(GL_TEXTURE_2D, page_colour_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glGenFramebuffers(1, &page_);
  glBindFramebuffer(GL_FRAMEBUFFER, page_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, page_colour_, 0);
  require_complete();

  glGenTextures(1, &atlas_);
  glBindTexture(GL_TEXTURE_2D, atlas_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);

  flat_ = link(flat_vertex, flat_fragment);
  glGenVertexArrays(1, &flat_array_);
  glBindVertexArray(flat_array_);
  glGenBuffers(1, &flat_buffer_);
  glBindBuffer(GL_ARRAY_BUFFER, flat_buffer_);
  attribute(0, 2, GL_FLOAT, false, sizeof(Vertex), offsetof(Vertex, x));
  attribute(1, 2, GL_FLOAT, false, sizeof(Vertex), offsetof(Vertex, u));
  attribute(2, 4, GL_UNSIGNED_BYTE, true, sizeof(Vertex), offsetof(Vertex, colour));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

// The OpenGL objects are destroyed with the context.
Painter::~Painter() = default;

void Painter::make_space() {
  glGenRenderbuffers(1, &samples_colour_);
  glBindRenderbuffer(GL_RENDERBUFFER, samples_colour_);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, width_, height_);
  glGenRenderbuffers(1, &samples_depth_);
  glBindRenderbuffer(GL_RENDERBUFFER, samples_depth_);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_DEPTH_COMPONENT24, width_, height_);
  glGenFramebuffers(1, &samples_);
  glBindFramebuffer(GL_FRAMEBUFFER, samples_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples_colour_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, samples_depth_);
  require_complete();

  glGenTextures(1, &shadow_map_);
  glBindTexture(GL_TEXTURE_2D, shadow_map_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, shadow_side, shadow_side, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glGenFramebuffers(1, &shadow_);
  glBindFramebuffer(GL_FRAMEBUFFER, shadow_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shadow_map_, 0);
  require_complete();

  glGenTextures(1, &soft_map_);
  glBindTexture(GL_TEXTURE_2D, soft_map_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R16, soft_side, soft_side, 0, GL_RED, GL_UNSIGNED_SHORT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glGenFramebuffers(1, &soft_);
  glBindFramebuffer(GL_FRAMEBUFFER, soft_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, soft_map_, 0);
  require_complete();

  solid_ = link(solid_vertex, solid_fragment);
  caster_ = link(caster_vertex, caster_fragment);
  softener_ = link(softener_vertex, softener_fragment);
  floor_ = link(floor_vertex, floor_fragment);
  glGenVertexArrays(1, &no_array_);
  glGenVertexArrays(1, &solid_array_);
  glBindVertexArray(solid_array_);
  glGenBuffers(1, &solid_buffer_);
  glBindBuffer(GL_ARRAY_BUFFER, solid_buffer_);
  attribute(0, 3, GL_FLOAT, false, sizeof(Space::Vertex), offsetof(Space::Vertex, position));
  attribute(1, 3, GL_FLOAT, false, sizeof(Space::Vertex), offsetof(Space::Vertex, normal));
  attribute(2, 4, GL_UNSIGNED_BYTE, true, sizeof(Space::Vertex), offsetof(Space::Vertex, colour));
}

Image Painter::paint(Colour paper, std::span<const Vertex> vertices, std::span<const Batch> batches,
                     const Font& font) {
  context_->make_current();
  if (!font.atlas().empty()) {
    glBindTexture(GL_TEXTURE_2D, atlas_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, Font::atlas_width, font.atlas_height(), 0, GL_RED, GL_UNSIGNED_BYTE,
                 font.atlas().data());
  }
  glBindBuffer(GL_ARRAY_BUFFER, flat_buffer_);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size_bytes()), vertices.data(), GL_STREAM_DRAW);

  glBindFramebuffer(GL_FRAMEBUFFER, page_);
  glViewport(0, 0, width_, height_);
  glDisable(GL_SCISSOR_TEST);
  clear(paper);
  glClear(GL_COLOR_BUFFER_BIT);
  for (const Batch& batch : batches) {
    if (batch.clip.width <= 0 || batch.clip.height <= 0) continue;
    if (batch.space)
      paint_space(*batch.space, batch.clip, paper);
    else
      paint_flat(batch);
  }

  Image image{width_, height_, std::vector<std::uint8_t>(3 * std::size_t(width_) * height_)};
  glBindFramebuffer(GL_FRAMEBUFFER, page_);
  glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  if (glGetError() != GL_NO_ERROR) throw Unavailable("OpenGL failed to draw a frame (out of memory?).");
  return image;
}

void Painter::paint_flat(const Batch& batch) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(batch.clip.x, batch.clip.y, batch.clip.width, batch.clip.height);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(flat_);
  glUniform2f(glGetUniformLocation(flat_, "page"), float(width_), float(height_));
  glBindTexture(GL_TEXTURE_2D, atlas_);
  glBindVertexArray(flat_array_);
  glDrawArrays(GL_TRIANGLES, GLint(batch.first), GLsizei(batch.count));
}

void Painter::paint_space(const Space& space, const PixelBox& frame, Colour paper) {
  if (!samples_) make_space();
  const SpaceCamera& camera = space.camera();
  const Point3 up = camera.up.normalized(), ahead = (camera.target - camera.eye).normalized();
  const Point3 right = ahead.cross(up).normalized();
  // The light comes from the upper left, behind the viewer.
  const Point3 light = (1.2 * up - 0.6 * right - 0.4 * ahead).normalized();
  glBindBuffer(GL_ARRAY_BUFFER, solid_buffer_);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(space.triangles_.size() * sizeof(Space::Vertex)),
               space.triangles_.data(), GL_STREAM_DRAW);
  const auto draw_solids = [&] {
    glBindVertexArray(solid_array_);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(space.triangles_.size()));
  };
  const auto place_ground = [&](GLuint program) {
    const Point3 along = (right - up * up.dot(right)).normalized();
    glUseProgram(program);
    set(program, "centre", space.ground_->centre);
    set(program, "along", along);
    set(program, "across", up.cross(along));
    set(program, "extent", space.ground_->extent);
  };

  glDisable(GL_BLEND);
  if (space.ground_) {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, shadow_);
    glViewport(0, 0, shadow_side, shadow_side);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    place_ground(caster_);
    set(caster_, "up", up);
    set(caster_, "light", light);
    draw_solids();
    glBindTexture(GL_TEXTURE_2D, shadow_map_);
    glGenerateMipmap(GL_TEXTURE_2D);

    glBindFramebuffer(GL_FRAMEBUFFER, soft_);
    glViewport(0, 0, soft_side, soft_side);
    glUseProgram(softener_);
    glUniform1i(glGetUniformLocation(softener_, "level"), soft_level);
    glBindVertexArray(no_array_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D, soft_map_);
  }

  glBindFramebuffer(GL_FRAMEBUFFER, samples_);
  glViewport(frame.x, frame.y, frame.width, frame.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(frame.x, frame.y, frame.width, frame.height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  clear(paper);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (space.ground_) {
    place_ground(floor_);
    set(floor_, "view", space.matrix_);
    set(floor_, "spacing", space.ground_->spacing);
    set(floor_, "rim", 0.12 * std::min(frame.width, frame.height));
    glUniform4f(glGetUniformLocation(floor_, "frame"), float(frame.x), float(frame.y),
                float(frame.x + frame.width), float(frame.y + frame.height));
    set(floor_, "paper", paper);
    set(floor_, "line", palette::grid);
    set(floor_, "dark", palette::muted);
    glBindVertexArray(no_array_);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  glUseProgram(solid_);
  set(solid_, "view", space.matrix_);
  set(solid_, "eye", camera.eye);
  set(solid_, "light", light);
  draw_solids();
  glDisable(GL_DEPTH_TEST);

  glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, page_);
  const int right_edge = frame.x + frame.width, lower_edge = frame.y + frame.height;
  glBlitFramebuffer(frame.x, frame.y, right_edge, lower_edge, frame.x, frame.y, right_edge, lower_edge,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, page_);
  glViewport(0, 0, width_, height_);
}

}  // namespace byhand::renderer
