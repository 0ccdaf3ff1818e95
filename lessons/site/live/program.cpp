#include "lessons/site/live/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lessons/page/grading.hpp"
#include "lessons/page/html/drawn.hpp"
#include "lessons/page/html/step_html.hpp"

namespace byhand::site {
namespace {

using namespace course;
using Json = nlohmann::ordered_json;

constexpr std::size_t kept = 2;  // told pages of a step: a reader may look at two settings side by side

struct Refused : std::invalid_argument {
  Refused(std::string name, const char* sentence) : std::invalid_argument(sentence), parameter(std::move(name)) {}
  std::string parameter;
};

Json described(const ParameterRecord& p) {
  return {{"name", p.name},        {"unit", p.unit},       {"meaning", p.meaning},
          {"low", p.range.low},    {"high", p.range.high}, {"initial", p.initial},
          {"whole", p.integer},    {"choices", p.choices}, {"typed", p.typed(p.initial)},
          {"allowed", p.allowed()}};
}

Json described(const Lesson& lesson) {
  Json parameters = Json::array(), steps = Json::array();
  for (const ParameterRecord& p : lesson.parameters()) parameters.push_back(described(p));
  for (const Step& s : lesson.steps()) steps.push_back({{"label", s.label}, {"title", s.title}});
  return {{"parameters", parameters}, {"steps", steps}};
}

/// Question `number`, from 1, of the page.
const Item& question(const Page& page, int number) {
  for (const Item& item : page.items())
    if ((std::holds_alternative<Prediction>(item) || std::holds_alternative<Choice>(item)) && --number == 0)
      return item;
  throw std::invalid_argument("There is no such question.");
}

Json graded(const Lesson& lesson, const Item& item, const std::string& typed) {
  const auto* prediction = std::get_if<Prediction>(&item);
  const Grade given =
      prediction ? grade(*prediction, typed, forgettable_factors(lesson)) : grade(std::get<Choice>(item), typed);
  return {{"right", given.right}, {"understood", given.understood}, {"reply", given.reply}};
}

/// A picture of that width; one whose letters would be too small on a narrow page is wide there too.
template <class Draw>
Shown fitted(int width, const Draw& draw) {
  std::string svg = draw(width);
  if (width == wide || is_legible(svg)) return {std::move(svg)};
  return {.markup = draw(wide), .sideways = true};
}

void act(course::Held& scene, const Json& act) {
  const std::string what = act.at(0);
  const auto point = [&] { return renderer::Point(act.at(1), Held::page.top() - act.at(2).get<double>()); };
  if (what == "grab") {
    scene.grab(point());
  } else if (what == "move") {
    scene.move(point());
  } else if (what == "release") {
    scene.release();
  } else if (what == "step") {
    for (int i = 0; i < act.at(1); ++i) scene.step();
  } else if (what == "reset") {
    scene.reset();
  } else {
    throw std::invalid_argument(fmt::format("\"{}\" is nothing to do with a scene.", what));
  }
}

Json described(const course::Held& scene, std::optional<double> part) {
  Json bodies = Json::array();
  for (const Held::Body& body : scene.bodies())
    bodies.push_back(
        {{"name", body.name}, {"x", body.at.x()}, {"y", Held::page.top() - body.at.y()}, {"reach", body.reach}});
  return {{"bodies", bodies},     {"held", scene.held()},       {"h", scene.h()},
          {"parts", Held::parts}, {"words", scene.words(part)}, {"stopped", scene.stopped()}};
}

}  // namespace

void Program::apply(const std::map<std::string, std::string>& settings) {
  for (const ParameterRecord& p : lesson_.parameters()) lesson_.set(p.name, p.typed(p.initial));
  for (const auto& [name, value] : settings) try {
      lesson_.set(name, value);
    } catch (const std::invalid_argument& refused) {
      throw Refused(name, refused.what());
    }
}

std::string Program::settings() const {
  std::string all;
  for (const ParameterRecord& p : lesson_.parameters()) all += fmt::format("{}={} ", p.name, p.typed(p.value));
  return all;
}

const Step& Program::step(const std::string& label) const {
  for (const Step& step : lesson_.steps())
    if (step.label == label) return step;
  throw std::invalid_argument(fmt::format("There is no step {}.", label));
}

Program::Told& Program::told(const Step& step) {
  std::list<Told>& pages = told_[step.label];
  const std::string now = settings();
  const auto found =
      std::find_if(pages.begin(), pages.end(), [&](const Told& told) { return told.settings == now; });
  if (found != pages.end()) {
    pages.splice(pages.begin(), pages, found);
    return pages.front();
  }
  forget_reads(lesson_);
  pages.push_front({now, record_step(lesson_, step, true)});
  pages.front().recorded.reads = reads(lesson_);
  for (const Item& item : pages.front().recorded.page.items())
    if (const auto* film = std::get_if<Sequence>(&item)) pages.front().films.try_emplace(film->name, *film);
  if (pages.size() > kept) pages.pop_back();
  return pages.front();
}

void Program::draw(Told& told, int width, bool small) const {
  if (told.width == width && (small || !told.small)) return;
  const renderer::SvgCanvas::DrawWindow& in_space = draw_window(small);
  const auto figure = [&](const Figure& it) {
    return fitted(width, [&](int points) { return drawn(it, in_space, points); });
  };
  const auto film = [&](const Sequence& it) {
    SeekableFilm& frames = told.films.at(it.name);
    const auto first = [&](renderer::Canvas& canvas) { frames.draw(canvas, 0); };
    Shown picture = fitted(width, [&](int points) { return drawn(it.name, first, in_space, points); });
    picture.markup = frames.screen(picture.markup);
    return picture;
  };
  told.html = step_html(told.recorded, {figure, film});
  told.width = width;
  told.small = small;
}

Held& Program::in_hand(const Step& step) {
  if (!step.hold) throw std::invalid_argument(fmt::format("Step {} has nothing to hold.", step.label));
  InHand& now = in_hand_[step.label];
  if (!now.scene || now.settings != settings()) {
    auto scene = step.hold->scene();
    if (now.scene) scene->go_on_from(*now.scene);
    now = {settings(), std::move(scene)};
  }
  return *now.scene;
}

std::string Program::answer(const std::string& request) {
  Json reply;
  try {
    const Json asked = Json::parse(request);
    apply(asked.value("settings", std::map<std::string, std::string>{}));
    const std::string what = asked.at("ask");
    const bool small = asked.value("small", false);
    const int width = asked.value("narrow", false) ? narrow : wide;
    const auto asked_step = [&]() -> const Step& { return step(asked.at("step")); };
    if (what == "describe") {
      reply = described(lesson_);
    } else if (what == "check") {
      for (const ParameterRecord& p : lesson_.parameters()) reply["typed"][p.name] = p.typed(p.value);
    } else if (what == "tell") {
      Told& page = told(asked_step());
      draw(page, width, small);
      reply = {{"html", page.html}, {"reads", page.recorded.reads}};
    } else if (what == "frame") {
      SeekableFilm& film = told(asked_step()).films.at(asked.at("film"));
      const std::string name = asked.at("film");
      const auto frame = [&](renderer::Canvas& canvas) { film.draw(canvas, asked.at("index")); };
      reply["svg"] =
          fitted(width, [&](int points) { return drawn(name, frame, draw_window(small), points); }).markup;
    } else if (what == "hold") {
      const Step& step = asked_step();
      Held& scene = in_hand(step);
      for (const Json& one : asked.value("acts", Json::array())) act(scene, one);
      std::optional<double> part;
      if (asked.contains("part")) part = asked["part"];
      reply = described(scene, part);
      const auto draw = [&](renderer::Canvas& canvas) { scene.draw(canvas, part); };
      reply["svg"] = drawn(step.hold->name, draw, {}, Held::width);
    } else if (what == "grade") {
      reply = graded(lesson_, question(told(asked_step()).recorded.page, asked.at("question")), asked.at("typed"));
    } else {
      throw std::invalid_argument(fmt::format("\"{}\" is no request.", what));
    }
  } catch (const Refused& refused) {
    reply = {{"refused", refused.what()}, {"parameter", refused.parameter}};
  } catch (const std::exception& error) {
    reply = {{"error", error.what()}};
  }
  return reply.dump();
}

}  // namespace byhand::site
