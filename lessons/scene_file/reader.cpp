#include "lessons/scene_file/body_reader.hpp"
#include "lessons/scene_file/constraint_reader.hpp"

namespace byhand {

std::string SceneFile::name_of(int body) const {
  const auto place = static_cast<std::size_t>(body);
  return place < names.size() && !names[place].empty() ? "\"" + names[place] + "\""
                                                       : "body " + std::to_string(body);
}

const std::map<std::string, AccuracyName>& accuracy_names() {
  static const std::map<std::string, AccuracyName> all{
      {"drift", {"m", "largest gap of a joint, or overlap, at the start and after any frame of the run"}},
      {"trajectory",
       {"m",
        "largest distance of a body's centre from the true motion, at the end as far as that is known, else after "
        "1 s"}},
      {"energy",
       {"1",
        "largest change of energy after any frame since the run began, as a share of the weight "
        "of all bodies "
        "times their distances from the first fixed body (from the origin if none is fixed), or without weight of "
        "the first kinetic energy"}},
      {"momentum",
       {"1",
        "largest change of the angular momentum about the vertical after any frame of the run, as a share of it"}},
      {"reaction",
       {"1",
        "error of the force that holds the scene, when a trajectory is compared, as a share of it or of the "
        "weight"}},
      {"contact",
       {"m/s",
        "what is left of the laws of contact and friction when a trajectory is compared; after 1 s if none is"}}};
  return all;
}

namespace scene_file {
namespace {

template <class M>
Scene<M> read_model(Reader& reader, SceneFile& file) {
  Scene<M> scene;
  reader.list("gravity", scene.gravity);
  double margin = 0, lookahead = 0;
  reader.number(contact_margin, margin);
  reader.number(contact_lookahead, lookahead);
  scene.set_margin(margin, lookahead);
  const bool points = M::linear == 3 || reader.index("contact_rows", {"manifold", "points"}, 0) == 1;
  scene.set_contact_rows(points ? ContactRows::points : ContactRows::manifold);

  const auto all = [&](const char* name) -> const std::vector<Value>& {
    static const std::vector<Value> none;
    const Value* list = reader.find(name);
    if (list && list->kind != Kind::list) Reader::refuse(*list, name, "a list [ … ]");
    return list ? list->list : none;
  };
  std::map<std::string, int> names;
  int number = 0;
  for (const Value& value : all("bodies")) {
    const std::string path = "bodies[" + std::to_string(number) + "]";
    Reader body(value, path);
    const std::string name = body.text("name");
    if (!name.empty() && !names.emplace(name, number).second)
      Reader::fail(value.line, path + ".name is \"" + name + "\", which another body has already");
    at(value.line, path, [&] { read_body<M>(body, scene); });
    body.done();
    file.names.push_back(name);
    ++number;
  }
  if (number == 0) reader.lacks("bodies", "a list of at least one body");
  std::vector<int> ids;
  for (const Value& value : all("constraints"))
    ids.push_back(read_constraint<M>(value, "constraints[" + std::to_string(ids.size()) + "]", scene,
                                     Around<M>{scene, names, ids}));
  return scene;
}

}  // namespace
}  // namespace scene_file

SceneFile read_scene(std::string_view text) {
  using namespace scene_file;
  const json::Value root = json::parse(text);
  Reader reader(root, "");
  SceneFile file;
  reader.text("$schema");
  file.title = reader.text("title");
  file.about = reader.text("about");
  const std::vector<std::string> models{"plane particles", "plane", "space particles", "space"};
  const int model = reader.index("model", models, -1);
  if (model < 0) reader.lacks("model", "one of \"plane\", \"space\", \"plane particles\" and \"space particles\"");
  int i = 0;
  const auto read = [&]<class M>(Scene<M>*) {
    if (model == i++) file.scene = read_model<M>(reader, file);
  };
  read(static_cast<Scene<PlaneParticle>*>(nullptr));
  read(static_cast<Scene<PlaneBody>*>(nullptr));
  read(static_cast<Scene<SpaceParticle>*>(nullptr));
  read(static_cast<Scene<SpaceBody>*>(nullptr));

  reader.number({.name = "step", .unit = "s", .meaning = "", .low = 1e-6, .high = 1, .otherwise = file.step},
                file.step);
  reader.number(
      {.name = "duration", .unit = "s", .meaning = "", .low = 0, .high = 3600, .otherwise = 5, .above_low = true},
      file.duration);
  if (file.duration / file.step > 1e6)
    Reader::fail(root.line, "the file asks for " + text_of(file.duration / file.step) +
                                " steps, duration/step, but at most 1000000 are allowed");
  if (const json::Value* value = reader.find("method")) {
    Reader method(*value, "method");
    members(method, file.method);
    method.done();
    at(value->line, "method", [&] { require_valid(file.method); });
  }
  if (const json::Value* value = reader.find("accuracy")) {
    Reader accuracy(*value, "accuracy");
    for (const auto& [name, about] : accuracy_names()) {
      double limit = 0;
      accuracy.number({.name = name.c_str(),
                       .unit = about.unit.c_str(),
                       .meaning = "",
                       .low = 0,
                       .high = 1e300,
                       .otherwise = 0,
                       .above_low = true},
                      limit);
      if (limit > 0) file.accuracy[name] = limit;
    }
    accuracy.done();
  }
  reader.done();
  return file;
}

}  // namespace byhand
