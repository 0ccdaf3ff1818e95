#pragma once

#include "lessons/04_baumgarte/runs.hpp"
#include "lessons/exact/simple_pendulum.hpp"

namespace byhand::baumgarte {

inline constexpr double film_seconds = 6;

/// No cure, the reader's β (0.2 where that is no cure either) and 1.
inline std::array<double, 3> film_betas(const Setting& setting) {
  const double beta = setting.beta();
  return {0, beta < 2 && beta != 1 ? beta : 0.2, 1};
}

/// Three pendulums that differ in β, each before the exact one, over a chart of their drift.
class PendulumFilm {
 public:
  explicit PendulumFilm(const Setting& setting);
  void draw(renderer::Canvas& canvas, double time) const;

 private:
  std::array<double, 3> betas_;
  std::array<Track, 3> runs_;
  SimplePendulum exact_;
  double length_;
  renderer::Chart below_;
};

}  // namespace byhand::baumgarte
