#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lessons/page/lesson.hpp"
#include "lessons/page/recording.hpp"
#include "renderer/image.hpp"

namespace byhand::site {

/// Whether one picture shows something that the other does not show near the same place: a shape that moved
/// farther than the numbers at an axis can push it, appeared, vanished or changed its colour. Letters are not to
/// be in them.
bool look_different(const renderer::Image& a, const renderer::Image& b);

/// A step with one parameter at a time at the other end of its range, to see which pictures that changes. Maps are
/// drawn as coarsely as they can be.
class TurnedStep {
 public:
  TurnedStep(course::Lesson& lesson, const course::Step& step);
  ~TurnedStep();
  TurnedStep(TurnedStep&&) noexcept;

  /// Whether the picture looks different at an end of the parameter's range, letters aside. True without a look
  /// for a chart that a clock measures, and for a parameter that only this step reads (Lesson::answers): those ask
  /// for long runs.
  bool changes(const std::string& picture, const std::string& parameter);

 private:
  using Setting = std::pair<std::string, std::string>;  // name and value; both empty: as it is
  using Images = std::vector<renderer::Image>;          // of a film several
  class Canvas;

  const Images& images(const std::string& picture, const Setting& setting);
  Images drawn(const std::string& picture, const course::RecordedStep& recorded);

  course::Lesson& lesson_;
  const course::Step& step_;
  std::map<Setting, course::RecordedStep> recorded_;
  std::map<std::pair<std::string, Setting>, Images> images_;
  std::unique_ptr<Canvas> canvas_;
};

}  // namespace byhand::site
