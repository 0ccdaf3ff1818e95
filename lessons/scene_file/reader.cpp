#include <algorithm>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "lessons/scene_file/members.hpp"
#include "lessons/scene_file/value.hpp"

namespace byhand {

std::string SceneFile::name_of(int body) const {
  const auto place = static_cast<std::size_t>(body);
  return place < names.size() && !names[place].empty() ? "\"" + names[place] + "\""
                                                       : "body " + std::to_string(body);
}

const std::map<std::string, std::string>& accuracy_names() {
  static const std::map<std::string, std::string> all{{"drift", "m"},    {"trajectory", "m"}, {"energy", "1"},
                                                      {"momentum", "1"}, {"reaction", "1"},   {"contact", "m/s"}};
  return all;
}

namespace scene_file {
namespace {

using json::Value;
using Kind = Value::Kind;

/// An error whose place in the file is told.
struct Located : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Reads the members of one object, and refuses those that nothing has asked for.
class Reader {
 public:
  Reader(const Value& object, std::string path) : object_(object), path_(std::move(path)) {
    if (object.kind != Kind::object) refuse(object, path_.empty() ? "the file" : path_, "an object { … }");
  }
  std::string path(const std::string& member) const { return path_.empty() ? member : path_ + "." + member; }

  [[noreturn]] static void refuse(const Value& value, const std::string& path, const std::string& allowed) {
    fail(value.line, path + " is " + value.shown() + ", but it must be " + allowed);
  }
  [[noreturn]] static void fail(int line, const std::string& sentence) {
    throw Located("line " + std::to_string(line) + ": " + sentence);
  }
  [[noreturn]] void lacks(const std::string& name, const std::string& allowed) const {
    fail(object_.line,
         (path_.empty() ? "the file" : path_) + " has no member \"" + name + "\", which must be " + allowed);
  }

  const Value* find(const std::string& name) {
    known_.push_back(name);
    return object_.find(name);
  }
  void done() const {
    for (const auto& [name, value] : object_.members) {
      if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
      std::string all;
      for (const std::string& known : known_) all += (all.empty() ? "" : ", ") + known;
      fail(value.line, (path_.empty() ? "the file" : path_) + " has a member \"" + name.substr(0, 40) +
                           "\", but its members are " + all);
    }
  }

  std::string text(const std::string& name) {
    const Value* value = find(name);
    if (!value) return {};
    if (value->kind != Kind::text) refuse(*value, path(name), "a text");
    return value->text;
  }
  void flag(const std::string& name, const char*, bool& flag, bool otherwise) {
    const Value* value = find(name);
    if (value && value->kind != Kind::truth) refuse(*value, path(name), "true or false");
    flag = value ? value->truth : otherwise;
  }
  void number(const Number& member, double& number) {
    const Value* value = find(member.name);
    if (value)
      number = number_in(*value, path(member.name), member);
    else if (member.otherwise)
      number = *member.otherwise;
    else
      lacks(member.name, allowed(member));
  }
  void whole(const Number& member, int& number) {
    double read = 0;
    this->number(member, read);
    if (read != static_cast<int>(read)) refuse(*object_.find(member.name), path(member.name), "a whole number");
    number = static_cast<int>(read);
  }
  /// The index of a name in a list.
  int index(const std::string& name, const std::vector<std::string>& names, int otherwise) {
    const Value* value = find(name);
    if (!value) return otherwise;
    const auto found = std::find(names.begin(), names.end(), value->text);
    if (value->kind != Kind::text || found == names.end()) {
      std::string all;
      for (const std::string& one : names) all += (all.empty() ? "\"" : ", \"") + one + "\"";
      refuse(*value, path(name), "one of " + all);
    }
    return static_cast<int>(found - names.begin());
  }
  template <class Enum>
  void name(const std::string& name, const char*, Enum& value, const std::vector<std::string>& names) {
    value = static_cast<Enum>(index(name, names, 0));
  }
  template <class... Choices>
  void one_of(const std::string& name, const char*, std::variant<Choices...>& choice,
              const std::vector<std::string>& names, int otherwise) {
    const int chosen = index(name, names, otherwise);
    int i = 0;
    ((chosen == i++ ? void(choice.template emplace<Choices>()) : void()), ...);
    std::visit([&](auto& one) { members(*this, one); }, choice);
  }
  /// Fills `numbers` from a list of as many. Returns whether it is there.
  template <class Numbers>
  bool list(const std::string& name, Numbers&& numbers, const Number& each = {"", "", ""}) {
    const Value* value = find(name);
    if (value) fill(*value, path(name), numbers, each);
    return value != nullptr;
  }
  template <class Numbers>
  static void fill(const Value& value, const std::string& path, Numbers&& numbers,
                   const Number& each = {"", "", ""}) {
    const auto count = static_cast<std::size_t>(numbers.size());
    if (value.kind != Kind::list || value.list.size() != count)
      refuse(value, path, "a list of " + std::to_string(count) + " numbers");
    for (std::size_t i = 0; i < count; ++i)
      numbers[static_cast<Eigen::Index>(i)] = number_in(value.list[i], path + "[" + std::to_string(i) + "]", each);
  }

  int line() const { return object_.line; }

 protected:
  static std::string allowed(const Number& member) {
    std::string words = "a finite number";
    if (std::isfinite(member.low))
      words += std::string(member.above_low ? " above " : " of at least ") + text_of(member.low);
    if (member.high < 1e300)
      words += (std::isfinite(member.low) ? " and at most " : " of at most ") + text_of(member.high);
    if (member.may_be_infinite) words += ", or \"infinite\"";
    if (member.angle) words += ", or an angle like \"30°\"";
    if (*member.unit) words += std::string(" [") + member.unit + "]";
    return words;
  }
  /// 30 of "30°"; what stands before the sign is a number as JSON has it.
  static std::optional<double> degrees_in(std::string_view text) {
    constexpr std::string_view sign = "°";
    if (!text.ends_with(sign)) return std::nullopt;
    try {
      const Value number = json::parse(text.substr(0, text.size() - sign.size()));
      return number.kind == Kind::number ? std::optional(number.number) : std::nullopt;
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  }
  static double number_in(const Value& value, const std::string& path, const Number& member) {
    double number = value.number;
    if (value.kind == Kind::text && member.may_be_infinite && value.text == "infinite") return endless;
    if (value.kind == Kind::text && member.angle) {
      const std::optional<double> degrees = degrees_in(value.text);
      if (!degrees) refuse(value, path, allowed(member));
      number = *degrees / 180 * std::numbers::pi;
    } else if (value.kind != Kind::number) {
      refuse(value, path, allowed(member));
    }
    const bool fits = std::isfinite(number) && number <= member.high &&
                      (member.above_low ? number > member.low : number >= member.low);
    if (!fits) refuse(value, path, allowed(member));
    return number;
  }

  const Value& object_;
  std::string path_;
  std::vector<std::string> known_;
};

/// Calls the library, whose refusals get the place in the file.
template <class F>
auto at(int line, const std::string& path, F&& call) {
  try {
    return call();
  } catch (const Located&) {
    throw;
  } catch (const std::invalid_argument& bad) {
    Reader::fail(line, path + ": " + bad.what());
  }
}

inline constexpr Number angle_member{.name = "angle", .unit = "rad", .meaning = "", .angle = true};

/// A rotation: "rotation" as it is kept, or "angle".
template <class M>
void read_rotation(Reader& reader, Rotation<M>& rotation) {
  if constexpr (M::angular == 1) {
    Packed<double, 2> r;
    if (reader.list("rotation", r)) rotation = {r[0], r[1]};
    double angle = 0;
    Number member = angle_member;
    member.otherwise = 0;
    reader.number(member, angle);
    if (angle != 0) rotation = plane_rotation(angle);
  } else if constexpr (M::angular == 3) {
    Packed<double, 4> q;
    if (reader.list("rotation", q)) rotation = Quaternion<double>(q[0], q[1], q[2], q[3]);
    Packed<double, 3> turn;
    if (reader.list("angle", turn, angle_member)) rotation = space_rotation(turn);
  }
}

/// What a constraint refers to.
template <class M>
struct Around {
  const Scene<M>& scene;
  const std::map<std::string, int>& names;  // of bodies
  const std::vector<int>& ids;              // of the constraints before it
};

template <class M>
class ConstraintReader : public Reader {
 public:
  ConstraintReader(const Value& object, std::string path, Around<M> around)
      : Reader(object, std::move(path)), around_(around) {}

  void bodies(int& body1, int& body2) {
    const Value* pair = find("bodies");
    const std::string allowed = "a list of two bodies, each by its name or its number from 0";
    if (!pair) lacks("bodies", allowed);
    if (pair->kind != Kind::list || pair->list.size() != 2) refuse(*pair, path("bodies"), allowed);
    body1 = body(pair->list[0], path("bodies[0]"));
    body2 = body(pair->list[1], path("bodies[1]"));
    at(line(), path_, [&] { Anchors<M>{body1, body2}.require_valid(around_.scene.bodies()); });
  }
  void anchors(Anchors<M>& anchors) {
    bodies(anchors.body1, anchors.body2);
    const Bodies<M>& all = around_.scene.bodies();
    if constexpr (M::angular > 0) {
      arms("arms", "", anchors.arms);
      Linear<M> point1, point2;
      if (list("point", point1)) anchors = between<M>(all, anchors.body1, point1, anchors.body2, point1);
      if (const Value* points = find("points")) {
        if (points->kind != Kind::list || points->list.size() != 2)
          refuse(*points, path("points"), "a list of two points");
        fill(points->list[0], path("points[0]"), point1);
        fill(points->list[1], path("points[1]"), point2);
        anchors = between<M>(all, anchors.body1, point1, anchors.body2, point2);
      }
    }
  }
  void arms(const std::string& name, const char*, Arms<M>& arms) {
    const Value* both = find(name);
    if (!both) return;
    if (both->kind != Kind::list || both->list.size() != 2) refuse(*both, path(name), "a list of two arms");
    fill(both->list[0], path(name + "[0]"), arms.first);
    fill(both->list[1], path(name + "[1]"), arms.second);
  }
  void length(double& length, const Anchors<M>& anchors) {
    const Bodies<M>& all = around_.scene.bodies();
    const double now = anchors.separation(all.pose[anchors.body1], all.pose[anchors.body2]).norm();
    number({.name = "length",
            .unit = "m",
            .meaning = "",
            .low = 0,
            .high = 1e300,
            .otherwise = now,
            .above_low = true},
           length);
  }
  void rest(Rotation<M>& rest, int body1, int body2) {
    rest = orientation<M>(around_.scene.bodies(), body1, body2).rest;
    const auto read = [&](auto numbers, auto rotation) {
      if (list("rest", numbers)) rest = rotation(numbers);
    };
    if constexpr (M::angular == 1)
      read(Packed<double, 2>(), [](const auto& r) { return Rotation<M>{r[0], r[1]}; });
    else
      read(Packed<double, 4>(), [](const auto& q) { return Quaternion<double>(q[0], q[1], q[2], q[3]); });
  }
  void direction(const std::string& name, Linear<M>& axis, int body) {
    if (const auto world = world_axis())
      axis = at(line(), path_, [&] { return axis_in<M>(around_.scene.bodies(), body, *world); });
    list(name, axis);
  }
  void across(Packed<double, M::linear, M::linear - 1>& across, int body) {
    if (const auto world = world_axis())
      across = at(line(), path_, [&] { return tangents_of<M>(axis_in<M>(around_.scene.bodies(), body, *world)); });
    columns("across", "", across);
  }
  template <class Matrix>
  void columns(const std::string& name, const char*, Matrix& matrix) {
    const Value* value = find(name);
    if (!value) return;
    const auto count = static_cast<std::size_t>(matrix.cols());
    if (value->kind != Kind::list || value->list.size() != count)
      refuse(*value, path(name), "a list of " + std::to_string(count) + " directions");
    for (std::size_t k = 0; k < count; ++k) {
      Linear<M> column;
      fill(value->list[k], path(name) + "[" + std::to_string(k) + "]", column);
      matrix.col(static_cast<Eigen::Index>(k)) = column;
    }
  }
  void vector(const std::string& name, const char*, Linear<M>& v) { list(name, v); }
  void stop(double& place, Stop& stop) {
    const bool least = object_.find("at_least"), most = object_.find("at_most");
    if (least == most) fail(line(), path_ + " must have one of \"at_least\" and \"at_most\"");
    stop = least ? Stop::lower : Stop::upper;
    number({.name = least ? "at_least" : "at_most", .unit = "rad or m", .meaning = "", .angle = true}, place);
  }
  void contact(int& id) {
    double place = 0;
    number({.name = "contact", .unit = "", .meaning = "", .low = 0, .high = 1e9}, place);
    const Value& value = *object_.find("contact");
    if (place != std::floor(place) || place >= static_cast<double>(around_.ids.size()))
      refuse(value, path("contact"), "the number of a constraint before this one");
    id = around_.ids[static_cast<std::size_t>(place)];
  }

 private:
  int body(const Value& value, const std::string& path) {
    const int count = around_.scene.bodies().size();
    if (value.kind == Kind::text) {
      const auto found = around_.names.find(value.text);
      if (found == around_.names.end()) refuse(value, path, "the name of a body");
      return found->second;
    }
    if (value.kind != Kind::number || value.number != std::floor(value.number) || value.number < 0 ||
        value.number >= count)
      refuse(value, path, "a body's name, or a whole number from 0 to " + std::to_string(count - 1));
    return static_cast<int>(value.number);
  }
  std::optional<Linear<M>> world_axis() {
    Linear<M> axis;
    return list("axis", axis) ? std::optional(axis) : std::nullopt;
  }

  Around<M> around_;
};

template <class M>
InverseMass<M> read_mass(Reader& reader, const Shape<M>& shape) {
  bool held = false;
  reader.flag("fixed", "", held, false);
  const Number positive{
      .name = "mass", .unit = "kg", .meaning = "", .low = 0, .high = 1e300, .otherwise = 0, .above_low = true};
  double mass = 0, inverse = 0;
  reader.number(positive, mass);
  Number exact = positive;
  exact.name = "inverse_mass", exact.unit = "1/kg";
  reader.number(exact, inverse);
  if (held + (mass > 0) + (inverse > 0) != 1)
    Reader::fail(reader.line(),
                 reader.path("mass") + " must be above zero [kg], or \"fixed\" must be true, and not both");
  if (held) return fixed<M>();
  if constexpr (M::angular == 0) {
    return inverse > 0 ? InverseMass<M>{inverse} : with_mass<M>(mass);
  } else {
    Angular<M> moments;
    const bool has_moments = reader.list("inertia", moments),
               has_inverse = reader.list("inverse_inertia", moments);
    InverseMass<M> result;
    if (has_inverse) {
      result.angular = moments;
    } else if (has_moments) {
      result = with_mass<M>(mass > 0 ? mass : 1, moments);
    } else if (const auto* round = std::get_if<Ball<M>>(&shape)) {
      result = ball<M>(mass, round->radius);
    } else if (const auto* block = std::get_if<Box<M>>(&shape)) {
      result = box<M>(mass, block->sides);
    } else {
      reader.lacks("inertia",
                   M::angular == 1
                       ? "a list of one moment [kg m²], where the shape is neither a ball nor a box"
                       : "a list of three moments [kg m²], where the shape is neither a ball nor a box");
    }
    result.linear = inverse > 0 ? inverse : 1 / mass;
    return result;
  }
}

template <class M>
Shape<M> read_shape(Reader& body) {
  Shape<M> shape;
  const Value* value = body.find("shape");
  if (!value) return shape;
  Reader reader(*value, body.path("shape"));
  Linear<M> numbers;
  if (reader.find("ball")) {
    double radius = 0;
    reader.number({.name = "ball", .unit = "m", .meaning = "", .low = 0, .high = 1e300, .above_low = true},
                  radius);
    shape = Ball<M>{radius};
  } else if (reader.list("half_space", numbers)) {
    shape = HalfSpace<M>{numbers};
  } else if constexpr (M::angular > 0) {
    if (reader.list("box", numbers,
                    {.name = "", .unit = "m", .meaning = "", .low = 0, .high = 1e300, .above_low = true}))
      shape = Box<M>{numbers};
  }
  reader.done();
  if (std::holds_alternative<std::monostate>(shape))
    Reader::fail(value->line, body.path("shape") + " must have one of \"ball\", \"box\" and \"half_space\"");
  return shape;
}

template <class M>
void read_body(Reader& reader, Scene<M>& scene) {
  Pose<M> pose;
  reader.list("position", pose.position);
  if constexpr (M::angular > 0) read_rotation<M>(reader, pose.rotation);
  Velocity<M> V = Velocity<M>::Zero();
  reader.list("velocity", V.template head<M::linear>());
  if constexpr (M::angular > 0)
    reader.list("spin", V.template tail<M::angular>(),
                {.name = "", .unit = "rad/s", .meaning = "", .angle = true});
  Shape<M> shape;
  if constexpr (M::angular > 0) shape = read_shape<M>(reader);
  const int body = scene.add_body(pose, read_mass<M>(reader, shape), V);
  if constexpr (M::angular > 0) {
    Surface surface;
    reader.number(friction, surface.friction);
    reader.number(restitution, surface.restitution);
    Layers layers;
    const auto bits = [&](const char* name, std::uint32_t& mask) {
      double number = mask;
      reader.number({.name = name, .unit = "", .meaning = "", .low = 0, .high = 4294967295.0, .otherwise = number},
                    number);
      mask = static_cast<std::uint32_t>(number);
    };
    bits("layers_in", layers.in);
    bits("layers_met", layers.meets);
    if (!std::holds_alternative<std::monostate>(shape)) scene.set_shape(body, shape, surface, layers);
  }
  double damping = 0, spin_damping = 0, gravity_scale = 1;
  reader.number({.name = "damping", .unit = "1/s", .meaning = "", .low = 0, .high = 1e300, .otherwise = 0},
                damping);
  reader.number({.name = "spin_damping", .unit = "1/s", .meaning = "", .low = 0, .high = 1e300, .otherwise = 0},
                spin_damping);
  reader.number({.name = "gravity_scale", .unit = "1", .meaning = "", .otherwise = 1}, gravity_scale);
  if (damping > 0 || spin_damping > 0) scene.set_damping(body, damping, spin_damping);
  if (gravity_scale != 1) scene.set_gravity_scale(body, gravity_scale);
}

/// Adds the constraint whose kind and freedom the object names.
template <class M>
int read_constraint(const Value& value, const std::string& path, Scene<M>& scene, const Around<M>& around) {
  ConstraintReader<M> reader(value, path, around);
  const std::string kind = reader.text("kind");
  std::string freedom;
  std::vector<std::string> kinds, freedoms;
  for_each_kind<M>([&]<class Kind>(const char* name, const char* on) {
    if (std::find(kinds.begin(), kinds.end(), name) == kinds.end()) kinds.emplace_back(name);
    if (kind == name && *on) freedoms.emplace_back(on);
  });
  const int known = reader.index("kind", kinds, -1);
  if (known < 0) reader.lacks("kind", "the name of a kind of constraint");
  if (!freedoms.empty()) {
    const int on = reader.index("on", freedoms, -1);
    if (on < 0) reader.lacks("on", "a freedom of this kind: " + freedoms.front() + " …");
    freedom = freedoms[static_cast<std::size_t>(on)];
  }
  int id = -1;
  for_each_kind<M>([&]<class Kind>(const char* name, const char* on) {
    if (kind != name || freedom != on) return;
    Kind constraint;
    members(reader, constraint);
    reader.done();
    id = at(value.line, path, [&] { return static_cast<int>(scene.add(constraint)); });
  });
  return id;
}

template <class M>
Scene<M> read_model(Reader& reader, SceneFile& file) {
  Scene<M> scene;
  reader.list("gravity", scene.gravity);
  double margin = 0.02, lookahead = 1;
  reader.number({.name = "contact_margin",
                 .unit = "m",
                 .meaning = "",
                 .low = 0,
                 .high = 1e300,
                 .otherwise = 0.02,
                 .above_low = true},
                margin);
  reader.number({.name = "contact_lookahead", .unit = "1", .meaning = "", .low = 0, .high = 1e300, .otherwise = 1},
                lookahead);
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
    for (const auto& [name, unit] : accuracy_names()) {
      double limit = 0;
      accuracy.number({.name = name.c_str(),
                       .unit = unit.c_str(),
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
