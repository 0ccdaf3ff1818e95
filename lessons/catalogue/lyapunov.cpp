#include <algorithm>
#include <cmath>

#include "lessons/catalogue/catalogue.hpp"
#include "lessons/catalogue/limits.hpp"

// Two runs that begin a ten-millionth of a degree apart: the distance d between them grows as exp(t/T) where the
// motion is chaotic, and in proportion to t where it is not, so that T = t/ln(d/d₀) rises with the time t that is
// watched. A. M. Lyapunov, 1892; G. Benettin and others, Meccanica 15, 1980.
namespace byhand {

double lyapunov_time(const Problem& problem) {
  const double apart = 1e-7, angle = problem["angle"];
  AnyScene one = problem.start(), other = problem.with("angle", angle > 0 ? angle - apart : angle + apart).start();
  const auto places = [](const AnyScene& scene) {
    std::vector<Eigen::Vector3d> all;
    for (const Placement& body : scene.placements())
      if (body.moves) all.push_back(body.position);
    return all;
  };
  AnyStepping fine{Direct{}, Baumgarte{0.5}};
  fine.substeps = std::max(16, 4 * substeps_of_law_7(problem));
  one.use(fine), other.use(fine);
  const double before = other.farthest_from(places(one));
  double most = before;
  while (one.time() < problem.scene().duration - 0.5 * frame) {
    one.step(frame), other.step(frame);
    most = std::max(most, other.farthest_from(places(one)));
  }
  return most > before ? one.time() / std::log(most / before) : INFINITY;
}

}  // namespace byhand
