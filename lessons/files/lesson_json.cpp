#include "lessons/files/lesson_json.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "lessons/files/commit.hpp"

// The only source that includes nlohmann-json, which takes seconds to compile.
namespace byhand::course {

using Json = nlohmann::ordered_json;

namespace {

/// The JSON of a text that anybody may have edited; nothing if it is none or nests more deeply than ours, because
/// what copies and prints it recurses. Members of these names are left out.
template <class AnyJson>
AnyJson shallow(const std::string& text, const std::set<std::string>& without = {}) {
  constexpr int deepest = 12;  // ours have six
  bool deep = false;
  const auto keep = [&](int depth, typename AnyJson::parse_event_t event, AnyJson& parsed) {
    deep = deep || depth > deepest;
    const bool name = event == AnyJson::parse_event_t::key;
    return !deep && !(name && without.contains(parsed.template get_ref<const std::string&>()));
  };
  AnyJson json = AnyJson::parse(text, keep, false);
  return deep ? AnyJson() : json;
}

std::map<std::string, std::string> strings(const nlohmann::json& object) {
  std::map<std::string, std::string> all;
  if (object.is_object())
    for (const auto& [name, value] : object.items())
      if (value.is_string()) all[name] = value;
  return all;
}

/// "Intel(R) Xeon(R) …": what measured times belong to.
std::string processor() {
  std::ifstream about("/proc/cpuinfo");
  for (std::string line; std::getline(about, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.find(':') + 2, line.size()));
  return "unknown";
}

}  // namespace

std::string made_by(const Lesson& lesson, const Options& options, const std::string& step, const std::string& gl) {
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
  return Json{
      {"step", step.empty() ? Json() : Json(step)},
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
      {"commit", commit()},
      {"compiler", BYHAND_COMPILER},
      {"processor", processor()},
  }
      .dump();
}

std::string to_json(const Manifest& manifest) {
  Json runs = Json::array();
  for (const WrittenRun& run : manifest.runs) {
    Json json = Json::parse(run.made_by);
    json["files"] = run.files;
    json["clocked"] = run.clocked;
    runs.push_back(std::move(json));
  }
  return Json{{"lesson", manifest.lesson}, {"runs", runs}}.dump(2) + "\n";
}

Manifest manifest_from_json(const std::string& text) {
  // This finds a name among a hundred thousand at once, which ordered_json does not; ordered_json keeps the order
  // of what made a run.
  const auto named = shallow<nlohmann::json>(text);
  if (!named.is_object()) return {};
  if (named.contains("site") && named.contains("files"))
    return {.of = Manifest::Of::site, .runs = {{.made_by = "", .files = strings(named["files"])}}};
  if (!named.contains("lesson") || !named["lesson"].is_string() || !named.contains("runs") ||
      !named["runs"].is_array())
    return {};
  Manifest manifest{.of = Manifest::Of::lesson, .lesson = named["lesson"]};
  const auto ordered = shallow<Json>(text, {"files", "clocked"});
  for (const auto& run : ordered["runs"]) {
    if (!run.is_object()) return {};
    const nlohmann::json& same = named["runs"][manifest.runs.size()];
    manifest.runs.push_back({.made_by = run.dump(),
                             .files = strings(same.value("files", nlohmann::json())),
                             .clocked = strings(same.value("clocked", nlohmann::json()))});
  }
  return manifest;
}

std::string questions(const Lesson& lesson, const std::vector<RecordedStep>& steps) {
  Json all = Json::array();
  for (const RecordedStep& step : steps)
    for (const Item& item : step.page.items())
      if (const auto* asked = std::get_if<Prediction>(&item)) {
        Json wrong = Json::array();
        for (const WrongAnswer& answer : asked->wrong)
          wrong.push_back({{"value", answer.value}, {"reply", answer.reply}});
        all.push_back({{"lesson", lesson.about().slug},
                       {"step", step.step->label},
                       {"ask", asked->ask},
                       {"answer", asked->answer},
                       {"unit", asked->unit},
                       {"tolerance", asked->tolerance},
                       {"wrong", wrong},
                       {"hints", asked->hints},
                       {"right", asked->right}});
      }
  return all.dump(2) + "\n";
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

}  // namespace byhand::course
