#include "lessons/site/turned_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <variant>

#include "lessons/page/held.hpp"
#include "renderer/chart.hpp"
#include "renderer/opengl/pixel_canvas.hpp"

namespace byhand::site {
namespace {

using namespace course;
using renderer::Image;

constexpr int page_width = 640, page_height = 360;  // pixels

bool same_colour(const std::uint8_t* a, const std::uint8_t* b) {
  constexpr int noticeable = 80;  // of red, green and blue together; a grid line on paper is 71
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) <= noticeable;
}

/// Whether `image` has the colour at most `near` pixels from (x, y).
bool has_near(const Image& image, int x, int y, const std::uint8_t* colour) {
  constexpr int near = 9;
  for (int v = std::max(0, y - near); v <= std::min(image.height - 1, y + near); ++v)
    for (int u = std::max(0, x - near); u <= std::min(image.width - 1, x + near); ++u)
      if (same_colour(image.pixel(u, v), colour)) return true;
  return false;
}

/// The values at the two ends of a range or, of a choice, all of them.
std::vector<std::string> ends(const ParameterRecord& parameter) {
  return parameter.choices.empty()
             ? std::vector{parameter.typed(parameter.range.low), parameter.typed(parameter.range.high)}
             : parameter.choices;
}

}  // namespace

bool look_different(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return true;
  int only_in_one = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const std::uint8_t *in_a = a.pixel(x, y), *in_b = b.pixel(x, y);
      only_in_one += !same_colour(in_a, in_b) && (!has_near(b, x, y, in_a) || !has_near(a, x, y, in_b));
    }
  constexpr double noticed = 5e-4;
  return only_in_one > noticed * a.width * a.height;
}

/// A small page without letters.
class TurnedStep::Canvas {
 public:
  template <class Draw>
  Image drawn(const Draw& draw) {
    canvas_.clear();
    canvas_.list_labels();
    draw(canvas_);
    return canvas_.image();
  }

 private:
  renderer::PixelCanvas canvas_{page_width, page_height};
};

TurnedStep::TurnedStep(Lesson& lesson, const Step& step)
    : lesson_(lesson), step_(step), canvas_(std::make_unique<Canvas>()) {}
TurnedStep::~TurnedStep() = default;
TurnedStep::TurnedStep(TurnedStep&&) noexcept = default;

bool TurnedStep::changes(const std::string& picture, const std::string& parameter) {
  const auto& all = lesson_.parameters();
  const auto record =
      std::find_if(all.begin(), all.end(), [&](const ParameterRecord& p) { return p.name == parameter; });
  if (!record->step.empty()) return true;
  const Images& now = images(picture, {});
  if (now.empty()) return true;
  for (const std::string& end : ends(*record)) {
    const Images& there = images(picture, {parameter, end});
    if (!std::equal(now.begin(), now.end(), there.begin(), there.end(),
                    [](const Image& a, const Image& b) { return !look_different(a, b); }))
      return true;
  }
  return false;
}

const TurnedStep::Images& TurnedStep::images(const std::string& picture, const Setting& setting) {
  const auto known = images_.find({picture, setting});
  if (known != images_.end()) return known->second;

  std::vector<Setting> before;
  for (const ParameterRecord& p : lesson_.parameters()) before.emplace_back(p.name, p.typed(p.value));
  if (lesson_.is_parameter("resolution")) {
    const auto& all = lesson_.parameters();
    const auto coarse =
        std::find_if(all.begin(), all.end(), [](const ParameterRecord& p) { return p.name == "resolution"; });
    lesson_.set("resolution", coarse->typed(coarse->range.low));
  }
  if (!setting.first.empty()) lesson_.set(setting.first, setting.second);
  auto recorded = recorded_.find(setting);
  if (recorded == recorded_.end()) recorded = recorded_.emplace(setting, record_step(lesson_, step_, true)).first;
  // Pictures may look at parameters when they are drawn.
  Images images = drawn(picture, recorded->second);
  for (const auto& [name, value] : before) lesson_.set(name, value);
  return images_[{picture, setting}] = std::move(images);
}

TurnedStep::Images TurnedStep::drawn(const std::string& picture, const RecordedStep& recorded) {
  constexpr int looks = 2;  // at a film, after its beginning
  for (const Item& item : recorded.page.items()) {
    if (const auto* figure = std::get_if<Figure>(&item); figure && figure->name == picture) {
      if (std::holds_alternative<TimedChart>(figure->picture)) return {};
      return {canvas_->drawn([&](renderer::Canvas& canvas) {
        if (const auto* chart = std::get_if<renderer::Chart>(&figure->picture))
          renderer::draw(canvas, *chart, canvas.page().inset(12));
        else
          std::get<Drawing>(figure->picture)(canvas);
      })};
    }
    if (const auto* film = std::get_if<Sequence>(&item); film && film->name == picture) {
      const FrameDrawing draw = film->draw;
      const auto* frames = std::get_if<Frames>(&film->length);
      const double length = frames ? frames->value - 1 : std::get<Seconds>(film->length).value;
      Images images;
      for (int i = 0; i <= looks; ++i) {
        const double time = length * i / looks;
        images.push_back(
            canvas_->drawn([&](renderer::Canvas& canvas) { draw(canvas, frames ? std::floor(time) : time); }));
      }
      return images;
    }
  }
  if (!step_.hold || step_.hold->name != picture) return {};
  // In a hand that pulls it for half a second, and let go for another.
  const std::unique_ptr<Held> scene = step_.hold->scene();
  const auto bodies = scene->bodies();
  Images images;
  for (const double until : {0.0, 0.5, 1.0}) {
    while (scene->time() < until && scene->stopped().empty()) scene->step();
    images.push_back(canvas_->drawn([&](renderer::Canvas& canvas) { scene->draw(canvas); }));
    if (until == 0 && !bodies.empty()) {
      scene->grab(bodies.back().at);
      scene->move(bodies.back().at + renderer::Point(-120, 60));
    } else {
      scene->release();
    }
  }
  return images;
}

}  // namespace byhand::site
