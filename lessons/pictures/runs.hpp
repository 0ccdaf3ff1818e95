#pragma once

#include "renderer/canvas.hpp"

namespace byhand::pictures {

/// How the bodies of run `i` look where several runs are shown beside a chart: in the colour of the run's curve.
inline renderer::Look look_of_run(int i) {
  namespace palette = renderer::palette;
  return {renderer::mix(palette::paper, palette::series(i), 0.45), {palette::ink, 1.8}};
}

}  // namespace byhand::pictures
