#pragma once

#include "lessons/scene_file/object_reader.hpp"

// Constraints from a file: between which bodies, at which points of the world or arms, along which axes.
namespace byhand::scene_file {

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

}  // namespace byhand::scene_file
