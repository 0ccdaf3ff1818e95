#include "lessons/tutor/json.hpp"

#include <nlohmann/json.hpp>

#include "lessons/tutor/picture_writer.hpp"

// The only source that includes nlohmann-json, which takes seconds to compile.
namespace byhand::tutor {

using Json = nlohmann::ordered_json;

std::string manifest(const Lesson& lesson, const std::vector<RecordedStep>& steps, const Options& options,
                     const std::string& gl) {
  Json parameters = Json::object();
  Json time_step = nullptr;
  for (const ParameterRecord& p : lesson.parameters()) {
    if (!p.choices.empty()) {
      parameters[p.name] = {{"value", p.typed(p.value)}};
      continue;
    }
    const Json value = p.integer ? Json(static_cast<int>(p.value)) : Json(p.value);
    parameters[p.name] = {{"value", value}, {"unit", p.unit}};
    if (p.name == "h") time_step = parameters[p.name];
  }
  Json clocked = Json::array();
  for (const RecordedStep& step : steps)
    for (const Item& item : step.page.items())
      if (const auto* figure = std::get_if<Figure>(&item);
          figure && std::holds_alternative<TimedChart>(figure->picture)) {
        clocked.push_back(figure_path(figure->name));
        clocked.push_back(data_path(figure->name));
      }
  const Json json = {
      {"lesson", lesson.about().slug},
      {"options",
       {{"quality", options.quality.name},
        {"width", options.quality.width},
        {"height", options.quality.height},
        {"frames_per_second", options.quality.rate},
        {"frames", to_string(options.frames)},
        {"parameters", parameters}}},
      {"time_step", time_step},
      {"method", lesson.about().method},
      {"gl", gl},
      {"clocked", clocked},
  };
  return json.dump(2) + "\n";
}

std::string to_json(const Bookmark& bookmark) {
  Json set = Json::object();
  for (const auto& [name, value] : bookmark.set) set[name] = value;
  return Json{{"step", bookmark.step}, {"finished", bookmark.finished}, {"set", set}}.dump() + "\n";
}

Bookmark bookmark_from_json(const std::string& text) {
  const auto json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return {};
  Bookmark bookmark;
  if (const auto step = json.find("step"); step != json.end() && step->is_string()) bookmark.step = *step;
  if (const auto finished = json.find("finished"); finished != json.end() && finished->is_boolean())
    bookmark.finished = *finished;
  if (const auto set = json.find("set"); set != json.end() && set->is_object())
    for (const auto& [name, value] : set->items())
      if (value.is_string()) bookmark.set.emplace_back(name, value);
  return bookmark;
}

}  // namespace byhand::tutor
