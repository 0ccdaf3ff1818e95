// The playground in a browser. Frames, 60 of them a second, come by `advance` as numbers; what else a page asks:
//
//     {"ask": "open", "text": "{…}"}       {"file": the same as it was understood, "look", "names", "step"}
//     {"ask": "use", "text": "{…}"}        goes on by the method and with the step of this file
//     {"ask": "now"}                       {"file": of this moment}
//     {"ask": "grab", "body": 3, "at": [x, y, z], "seen": [[1, 0, 0], [0, 1, 0]]},
//     {"ask": "move", "at": [x, y, z]}, {"ask": "release"}
//     {"ask": "part", "part": 2.5, "width": 960, "camera": [x, y, scale], "longest": 0.5, "seen": …}
//                                          {"svg", "formula", "words", "moved"}: of the next step
//     {"ask": "doctor", "text": "{…}"}     {"findings": […]}
//     {"ask": "turn", "text": "{…}", "name": "substeps", "value": 4}     {"file": with this knob turned}
//     {"ask": "stopped"}                   {"stopped": why `advance` made fewer steps than it was asked for}
//
// z and "seen", what lies to the right and up in the picture, may be left out in the plane. What cannot be
// answered is answered by {"failure": a sentence}.

#include <nlohmann/json.hpp>

#include "lessons/doctor/doctor.hpp"
#include "lessons/page/answered.hpp"
#include "lessons/playground/playground.hpp"
#include "renderer/svg_canvas.hpp"

namespace {

using namespace byhand;
using nlohmann::json;

std::unique_ptr<playground::Playground> now;
std::string stopped;
std::vector<double> moment;

json list_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d vector_in(const json& list) {
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.size() > 2 ? list.at(2).get<double>() : 0.0};
}
playground::Seen seen_in(const json& asked) {
  playground::Seen seen = playground::Seen::Identity();
  if (asked.contains("seen"))
    for (int row = 0; row < 2; ++row) seen.row(row) = vector_in(asked.at("seen").at(row));
  return seen;
}

json look_json(const stage::SceneLook& look) {
  static const char* const bodies_as[] = {"nothing", "disc", "box", "half_space", "link", "bob"};
  static const char* const ties_as[] = {"rod", "spring", "joint", "surface"};
  json bodies = json::array(), ties = json::array();
  for (const stage::BodyLook& body : look.bodies)
    bodies.push_back({{"as", bodies_as[static_cast<int>(body.as)]},
                      {"sides", list_of(body.sides)},
                      {"from", list_of(body.from)},
                      {"to", list_of(body.to)},
                      {"mass", body.mass}});
  for (const stage::TieLook& tie : look.ties)
    ties.push_back({{"as", ties_as[static_cast<int>(tie.as)]},
                    {"bodies", {tie.body1, tie.body2}},
                    {"arms", {list_of(tie.arm1), list_of(tie.arm2)}},
                    {"normal", list_of(tie.normal)}});
  return {{"in_space", look.in_space}, {"bodies", bodies}, {"ties", ties}};
}

json opened(const std::string& text) {
  const SceneFile file = read_scene(text);
  now = playground::begin(file);
  stopped.clear();
  json names = json::array();
  for (int i = 0; i < static_cast<int>(file.names.size()); ++i) names.push_back(file.name_of(i));
  return {{"file", write_scene(file)}, {"look", look_json(now->look())}, {"names", names}, {"step", file.step}};
}

json drawn_part(const json& asked) {
  const int width = asked.at("width");
  renderer::SvgCanvas canvas(width, "part");
  canvas.clear(renderer::fade(renderer::palette::paper, 0));
  const json& camera = asked.at("camera");
  canvas.look(
      {canvas.page(), {camera.at(0).get<double>(), camera.at(1).get<double>()}, camera.at(2).get<double>()});
  const auto part = now->draw_part(canvas, asked.at("part"), asked.at("longest"), seen_in(asked));
  json moved = json::array();
  for (const auto& [body, numbers] : part.moved) moved.push_back({{"body", body}, {"numbers", numbers}});
  return {{"svg", canvas.svg("")}, {"formula", part.formula}, {"words", part.words}, {"moved", moved}};
}

json findings(const SceneFile& file) {
  static const char* const grades[] = {"fine", "near", "fails"};
  json all = json::array();
  for (const doctor::Finding& finding : doctor::diagnose(file).findings) {
    json knobs = json::array();
    for (const doctor::Knob& knob : finding.knobs)
      knobs.push_back({{"name", knob.name}, {"value", knob.value}, {"words", knob.words}});
    all.push_back({{"law", finding.law},
                   {"grade", grades[static_cast<int>(finding.grade)]},
                   {"quantity", finding.quantity},
                   {"number", finding.number},
                   {"limit", finding.limit},
                   {"sentence", finding.sentence},
                   {"bodies", finding.bodies},
                   {"knobs", knobs}});
  }
  return {{"findings", all}};
}

json answer_to(const json& asked) {
  const std::string what = asked.at("ask");
  if (what == "open") return opened(asked.at("text"));
  if (what == "doctor") return findings(read_scene(asked.at("text").get<std::string>()));
  if (what == "turn")
    return {{"file", write_scene(doctor::turned(read_scene(asked.at("text").get<std::string>()),
                                                {asked.at("name"), asked.at("value"), ""}))}};
  if (!now) throw std::invalid_argument("no scene is open");
  if (what == "use") now->use(read_scene(asked.at("text").get<std::string>()));
  if (what == "now") return {{"file", write_scene(now->file())}};
  if (what == "grab") now->grab(asked.at("body"), vector_in(asked.at("at")), seen_in(asked));
  if (what == "move") now->move(vector_in(asked.at("at")));
  if (what == "release") now->release();
  if (what == "part") return drawn_part(asked);
  if (what == "stopped") return {{"stopped", stopped}};
  return json::object();
}

}  // namespace

std::string byhand::course::answered(const std::string& request) {
  json said;
  try {
    said = answer_to(json::parse(request));
  } catch (const std::exception& error) {
    said = {{"failure", error.what()}};
  }
  return said.dump(-1, ' ', false, json::error_handler_t::replace);
}

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

/// Makes so many steps, fewer where one has no answer, and returns the numbers of the moment that is reached.
EXPORT(advance) const double* advance(int steps) {
  try {
    for (int i = 0; i < steps && stopped.empty(); ++i) now->step();
  } catch (const std::exception& error) {
    stopped = error.what();
  }
  now->write_moment(moment);
  return moment.data();
}

EXPORT(moment_size) int moment_size() { return static_cast<int>(moment.size()); }
EXPORT(has_stopped) int has_stopped() { return stopped.empty() ? 0 : 1; }
