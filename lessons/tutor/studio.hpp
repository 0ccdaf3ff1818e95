#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "lessons/tutor/items.hpp"
#include "lessons/tutor/options.hpp"
#include "renderer/canvas.hpp"
#include "renderer/image.hpp"

namespace byhand::tutor {

/// Where the pictures of a lesson go, from the lesson's folder.
std::string figure_path(const std::string& name);    // figures/<name>.png
std::string data_path(const std::string& name);      // data/<name>.csv
std::string frames_folder(const std::string& name);  // frames/<name>
std::string strip_path(const std::string& name);     // frames/<name>.png

/// Draws what a lesson shows and writes it into the lesson's folder. OpenGL is asked for with the first
/// picture, so a run without pictures needs none. Every function throws renderer::EnvironmentError for what
/// the machine refuses.
class Studio {
 public:
  Studio(std::filesystem::path folder, Quality quality, FramesWanted frames, bool quiet);

  /// The picture, and a chart's data.
  void write(const Figure& figure);
  /// The frames that are wanted and the strip; frames of an older run are removed.
  void write(const Sequence& sequence);

  /// The same pictures for a terminal, where a few hundred pixels are more than it can show.
  renderer::Image small(const Figure& figure);
  renderer::Image small(const FrameDrawing& draw, double time);

  /// How many frames a sequence has, and the time that frame `index` is given.
  int count(const Sequence& sequence) const;
  double time(const Sequence& sequence, int index) const;

  /// Where the picture, or the strip, is written; empty when no frames are wanted.
  std::string path(const Figure& figure) const;
  std::string path(const Sequence& sequence) const;

  const std::filesystem::path& folder() const { return folder_; }
  /// OpenGL's renderer and version, once something was drawn.
  std::string gl() const;

 private:
  renderer::Canvas& canvas();
  renderer::Canvas& small_canvas();

  std::filesystem::path folder_;
  Quality quality_;
  FramesWanted frames_;
  bool quiet_;
  std::optional<renderer::Canvas> canvas_, small_canvas_;
};

}  // namespace byhand::tutor
