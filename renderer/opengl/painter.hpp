#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "renderer/drawing_surface.hpp"
#include "renderer/font.hpp"
#include "renderer/image.hpp"
#include "renderer/opengl/gl.hpp"
#include "renderer/opengl/offscreen.hpp"
#include "renderer/outline.hpp"
#include "renderer/space.hpp"

namespace byhand::renderer {

/// A draw call: triangles of the page clipped to `clip`, or a scene in space with `clip` as its viewport.
struct Batch {
  PixelBox clip;
  std::size_t first = 0, count = 0;
  std::optional<Space> space;
};

/// The OpenGL part of a canvas: its framebuffers and shader programs.
class Painter {
 public:
  Painter(int width, int height);
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;
  ~Painter();

  const std::string& describe() const { return description_; }
  Image paint(Colour paper, std::span<const Vertex> vertices, std::span<const Batch> batches, const Font& font);

 private:
  void paint_flat(const Batch& batch);
  void paint_space(const Space& space, const PixelBox& frame, Colour paper);
  void make_space();

  int width_, height_;
  std::unique_ptr<Context> context_;
  std::string description_;
  GLuint page_ = 0, page_colour_ = 0, atlas_ = 0, flat_ = 0, flat_array_ = 0, flat_buffer_ = 0;
  // For scenes in space, created with the first: a multisampled framebuffer with depth, the shadow map, and the
  // same with soft edges.
  GLuint samples_ = 0, samples_colour_ = 0, samples_depth_ = 0, shadow_ = 0, shadow_map_ = 0, soft_ = 0,
         soft_map_ = 0;
  GLuint solid_ = 0, caster_ = 0, softener_ = 0, floor_ = 0, solid_array_ = 0, solid_buffer_ = 0, no_array_ = 0;
};

}  // namespace byhand::renderer
