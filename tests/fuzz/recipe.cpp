#include "tests/fuzz/recipe.hpp"

#include "solver/byhand.hpp"

namespace byhand::fuzz {

template <class M>
InverseMass<M> mass_of(const typename Recipe<M>::Part& part) {
  if (part.mass == 0) return fixed<M>();
  if (const auto* round = std::get_if<Ball<M>>(&part.shape)) return ball<M>(part.mass, round->radius);
  return box<M>(part.mass, std::get<Box<M>>(part.shape).sides);
}

namespace {

/// Of a rod between two centres.
template <class M>
double length_of(const Recipe<M>& recipe, int first, int second) {
  return (recipe.parts[first].pose.position - recipe.parts[second].pose.position).norm();
}

}  // namespace

template <class M>
Scene<M> scene_of(const Recipe<M>& recipe) {
  Scene<M> scene;
  scene.gravity = recipe.gravity;
  scene.set_margin(recipe.margin, recipe.lookahead);
  scene.set_contact_rows(recipe.rows);
  for (const auto& part : recipe.parts) {
    const int body = scene.add_body(part.pose, mass_of<M>(part), part.velocity);
    scene.set_shape(body, part.shape, {part.friction, 0});
  }
  for (const auto& [joint, first, second, at] : recipe.links) {
    const auto& bodies = scene.bodies();
    switch (joint) {
      case Recipe<M>::Joint::pin: scene.add(pin<M>(bodies, first, second, at)); break;
      case Recipe<M>::Joint::weld: scene.add(weld<M>(bodies, first, second, at)); break;
      case Recipe<M>::Joint::rod: scene.add(Distance<M>{{first, second}, length_of(recipe, first, second)}); break;
    }
  }
  return scene;
}

namespace {

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}
std::string list(const auto& numbers) {
  std::string text;
  for (const double x : numbers) text += (text.empty() ? "" : ", ") + number(x);
  return '{' + text + '}';
}

template <class M>
const std::string model = M::linear == 2 ? "PlaneBody" : "SpaceBody";

template <class M>
std::string code_of_shape(const Shape<M>& shape) {
  if (const auto* ball = std::get_if<Ball<M>>(&shape))
    return "Ball<" + model<M> + ">{" + number(ball->radius) + '}';
  if (const auto* box = std::get_if<Box<M>>(&shape)) return "Box<" + model<M> + ">{" + list(box->sides) + '}';
  return "HalfSpace<" + model<M> + ">{" + list(std::get<HalfSpace<M>>(shape).normal) + '}';
}

template <class M>
std::string code_of_mass(const typename Recipe<M>::Part& part) {
  if (part.mass == 0) return "fixed<" + model<M> + ">()";
  if (const auto* round = std::get_if<Ball<M>>(&part.shape))
    return "ball<" + model<M> + ">(" + number(part.mass) + ", " + number(round->radius) + ')';
  return "box<" + model<M> + ">(" + number(part.mass) + ", " + list(std::get<Box<M>>(part.shape).sides) + ')';
}

template <class M>
std::string code_of_rotation(const Pose<M>& pose) {
  if constexpr (M::linear == 2)
    return '{' + number(pose.rotation.cos) + ", " + number(pose.rotation.sin) + '}';
  else
    return "Eigen::Quaterniond(" + number(pose.rotation.w()) + ", " + number(pose.rotation.x()) + ", " +
           number(pose.rotation.y()) + ", " + number(pose.rotation.z()) + ')';
}

}  // namespace

template <class M>
std::string code_of(const Recipe<M>& recipe) {
  std::string code = "Scene<" + model<M> + "> scene;\nscene.gravity = " + list(recipe.gravity) + ";\n";
  if constexpr (M::linear == 2)
    if (recipe.rows == ContactRows::points) code += "scene.set_contact_rows(ContactRows::points);\n";
  int body = 0;
  for (const auto& part : recipe.parts) {
    code += "scene.add_body(Pose<" + model<M> + ">{" + list(part.pose.position) + ", " +
            code_of_rotation<M>(part.pose) + "}, " + code_of_mass<M>(part) + ", Velocity<" + model<M> + '>' +
            list(part.velocity) + ");\n";
    code += "scene.set_shape(" + std::to_string(body++) + ", " + code_of_shape<M>(part.shape) + ", {" +
            number(part.friction) + ", 0});\n";
  }
  for (const auto& [joint, first, second, at] : recipe.links) {
    const std::string two = std::to_string(first) + ", " + std::to_string(second);
    code += "scene.add(";
    if (joint == Recipe<M>::Joint::rod)
      code += "Distance<" + model<M> + ">{{" + two + "}, " + number(length_of(recipe, first, second)) + "});\n";
    else
      code += (joint == Recipe<M>::Joint::pin ? "pin<" : "weld<") + model<M> + ">(scene.bodies(), " + two + ", " +
              list(at) + "));\n";
  }
  return code;
}

#define BYHAND_INSTANTIATE(M)                                 \
  template InverseMass<M> mass_of<M>(const Recipe<M>::Part&); \
  template Scene<M> scene_of(const Recipe<M>&);               \
  template std::string code_of(const Recipe<M>&)
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand::fuzz
