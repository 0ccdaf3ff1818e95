#include "lessons/site/alternative.hpp"

#include "lessons/tutor/chart_words.hpp"

namespace byhand::site {

std::string alternative(const tutor::Figure& figure) {
  const auto* chart = std::get_if<renderer::Chart>(&figure.picture);
  return chart ? tutor::chart_in_words(*chart) : "";
}

std::string alternative(const tutor::Sequence&) { return ""; }

}  // namespace byhand::site
