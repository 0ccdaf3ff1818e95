#pragma once

#include "lessons/scene_file/object_reader.hpp"

// Bodies from a file: pose, velocity, mass and inertia, shape and surface.
namespace byhand::scene_file {

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
  double slowing = 0, spin_slowing = 0, gravity_scale = 1;
  reader.number({.name = "damping", .unit = "1/s", .meaning = "", .low = 0, .high = 1e300, .otherwise = 0},
                slowing);
  reader.number({.name = "spin_damping", .unit = "1/s", .meaning = "", .low = 0, .high = 1e300, .otherwise = 0},
                spin_slowing);
  reader.number({.name = "gravity_scale", .unit = "1", .meaning = "", .otherwise = 1}, gravity_scale);
  if (slowing > 0 || spin_slowing > 0) scene.set_damping(body, slowing, spin_slowing);
  if (gravity_scale != 1) scene.set_gravity_scale(body, gravity_scale);
}

}  // namespace byhand::scene_file
