#pragma once

#include <map>
#include <string>
#include <vector>

#include "lessons/catalogue/chooser.hpp"
#include "lessons/scene_file/scene_file.hpp"

namespace byhand::stage {

/// A file's scene and request in the chooser's terms.
struct Request {
  Problem problem;
  std::map<Error, double> limits;    // in the unit of each error
  double seconds = 0;                // that runs are watched: the file's duration, or less of a large scene [s]
  bool broke = false;                // whether a fine step has no answer then
  double taken = 0;                  // of the energy's scale by the first step, where first velocities do not fit
  double last_motion = INFINITY;     // of any body in the last tenth of the time before it is compared [m]
  std::vector<std::string> notes{};  // what the file asks for and the chooser cannot tell, a sentence each
};

/// The scene is run once with short steps, to find out whether its true motion rests, keeps its energy and keeps
/// its angular momentum about the vertical. A file without "accuracy" asks for gaps below a hundredth of its
/// smallest body. Throws std::invalid_argument where no method can run the scene.
Request request_of(const SceneFile& file);

}  // namespace byhand::stage
