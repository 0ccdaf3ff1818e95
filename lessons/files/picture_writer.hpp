#pragma once

#include <string>

#include "lessons/files/options.hpp"
#include "lessons/files/output_folder.hpp"
#include "lessons/files/picture_drawer.hpp"
#include "lessons/page/items.hpp"

namespace byhand::course {

class Lesson;

/// Paths of the files of a lesson, relative to the lesson's folder.
std::string figure_path(const std::string& name);                           // figures/<name>.png
std::string data_path(const std::string& name);                             // data/<name>.csv
std::string frames_folder(const std::string& name);                         // frames/<name>
std::string strip_path(const std::string& name);                            // frames/<name>.png
std::string film_path(const std::string& name, const std::string& format);  // frames/<name>.webm

/// Draws the figures and sequences of a lesson and writes them into its folder. Opens OpenGL at the first picture,
/// so a run without pictures needs none. Every function, the constructor too, may throw
/// EnvironmentError.
class PictureWriter {
 public:
  /// Makes the lesson's output folder and claims it.
  PictureWriter(const Lesson& lesson, const Options& options);

  /// Writes the picture and, for a chart, its data.
  void write(const Figure& figure);
  /// Writes the chosen frames, the key frames and the film, after removing those of an earlier run.
  void write(const Sequence& sequence);

  /// File of the picture or of the key frames, to be printed; empty if no frames are written.
  std::string path(const Figure& figure) const;
  std::string path(const Sequence& sequence) const;

  OutputFolder& output() { return output_; }
  /// OpenGL's renderer and version; empty before the first picture.
  std::string gl() const { return drawer_.gl(); }

 private:
  OutputFolder output_;
  PictureDrawer drawer_;
  FramesWanted frames_;
  std::string film_;
  bool quiet_;
};

}  // namespace byhand::course
