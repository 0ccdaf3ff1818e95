#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lessons/scene_file/members.hpp"

namespace byhand {
namespace scene_file {
namespace {

/// A number that reads back to the bit: the parser takes "-0" for a whole number, which has no sign.
std::string exact(double number) { return number == 0 && std::signbit(number) ? "-0.0" : text_of(number); }

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}
template <class Numbers>
std::string list_of(const Numbers& numbers) {
  std::string text;
  for (const double x : numbers) text += (text.empty() ? "" : ", ") + exact(x);
  return "[" + text + "]";
}

/// Whether they are the same to the bit.
bool same(const auto& a, const auto& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double x, double y) { return x == y && std::signbit(x) == std::signbit(y); });
}
template <class M>
bool same(const Arms<M>& a, const Arms<M>& b) {
  return same(a.first, b.first) && same(a.second, b.second);
}
Packed<double, 2> numbers_of(const PlaneRotation<double>& r) { return {r.cos, r.sin}; }
Packed<double, 4> numbers_of(const Quaternion<double>& q) { return {q.w(), q.x(), q.y(), q.z()}; }

/// Writes the members of one object on one line. What a reader would put there by itself is left out.
class Writer {
 public:
  void put(const std::string& name, const std::string& json) {
    text_ += (text_.empty() ? "" : ", ") + quoted(name) + ": " + json;
  }
  std::string object() const { return "{" + text_ + "}"; }

  void number(const Number& member, double number) {
    if (member.otherwise == number) return;
    put(member.name, std::isinf(number) ? "\"infinite\"" : exact(number));
  }
  void whole(const Number& member, int number) { this->number(member, number); }
  void flag(const std::string& name, const char*, bool flag, bool otherwise) {
    if (flag != otherwise) put(name, flag ? "true" : "false");
  }
  template <class Enum>
  void name(const std::string& name, const char*, Enum value, const std::vector<std::string>& names) {
    if (static_cast<int>(value) != 0) put(name, quoted(names[static_cast<std::size_t>(value)]));
  }
  template <class... Choices>
  void one_of(const std::string& name, const char*, std::variant<Choices...>& choice,
              const std::array<const char*, sizeof...(Choices)>& names, int) {
    put(name, quoted(names[choice.index()]));
    std::visit([&](auto& one) { members(*this, one); }, choice);
  }

 private:
  std::string text_;
};

template <class M>
class ConstraintWriter : public Writer {
 public:
  ConstraintWriter(const Bodies<M>& bodies, const std::vector<int>& number_of)
      : bodies_(bodies), number_of_(number_of) {}

  void bodies(int body1, int body2) {
    put("bodies", "[" + std::to_string(number_of_[body1]) + ", " + std::to_string(number_of_[body2]) + "]");
  }
  /// The points in the world where they give these arms to the bit, else the arms.
  void anchors(const Anchors<M>& at) {
    bodies(at.body1, at.body2);
    if constexpr (M::angular > 0) {
      if (same<M>(at.arms, Arms<M>())) return;
      const auto point = [&](int body, const Arm<M>& arm) {
        return Linear<M>(anchor<M, double>(bodies_.pose[body], in_world<M, double>(bodies_.pose[body], arm)));
      };
      const Linear<M> one = point(at.body1, at.arms.first), two = point(at.body2, at.arms.second);
      const auto gives = [&](const Linear<M>& first, const Linear<M>& second) {
        return same<M>(between<M>(bodies_, at.body1, first, at.body2, second).arms, at.arms);
      };
      if (gives(one, one))
        put("point", list_of(one));
      else if (gives(two, two))
        put("point", list_of(two));
      else
        arms("arms", "", at.arms);
    }
  }
  void arms(const std::string& name, const char*, const Arms<M>& arms) {
    if (!same<M>(arms, Arms<M>())) put(name, "[" + list_of(arms.first) + ", " + list_of(arms.second) + "]");
  }
  void length(double length, const Anchors<M>&) { put("length", exact(length)); }
  void rest(const Rotation<M>& rest, int body1, int body2) {
    const auto now = numbers_of(orientation<M>(bodies_, body1, body2).rest), kept = numbers_of(rest);
    if (!same(now, kept)) put("rest", list_of(kept));
  }
  void direction(const std::string& name, const Linear<M>& axis, int) { put(name, list_of(axis)); }
  void across(const Packed<double, M::linear, M::linear - 1>& across, int) { columns("across", "", across); }
  template <class Matrix>
  void columns(const std::string& name, const char*, const Matrix& matrix) {
    std::string all;
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) all += (k ? ", " : "") + list_of(Linear<M>(matrix.col(k)));
    put(name, "[" + all + "]");
  }
  void vector(const std::string& name, const char*, const Linear<M>& v) { put(name, list_of(v)); }
  void stop(double place, Stop stop) { put(stop == Stop::lower ? "at_least" : "at_most", exact(place)); }
  void contact(int place) { put("contact", std::to_string(place)); }

 private:
  const Bodies<M>& bodies_;
  const std::vector<int>& number_of_;
};

/// The number whose inverse is this, to the bit; 0 if there is none.
double inverse_of(double inverse) {
  double number = 1 / inverse;
  for (int i = 0; i < 3; ++i) number = std::nextafter(number, 0);
  for (int i = 0; i < 7; ++i, number = std::nextafter(number, endless))
    if (1 / number == inverse) return number;
  return 0;
}

template <class M>
void write_mass(Writer& writer, const InverseMass<M>& mass, const Shape<M>& shape) {
  if (!moves(mass)) return writer.put("fixed", "true");
  const double kilograms = inverse_of(mass.linear);
  kilograms > 0 ? writer.put("mass", exact(kilograms)) : writer.put("inverse_mass", exact(mass.linear));
  if constexpr (M::angular > 0) {
    InverseMass<M> uniform;
    if (const auto* round = std::get_if<Ball<M>>(&shape); round && kilograms > 0)
      uniform = ball<M>(kilograms, round->radius);
    if (const auto* block = std::get_if<Box<M>>(&shape); block && kilograms > 0)
      uniform = box<M>(kilograms, block->sides);
    if (same(uniform.angular, mass.angular)) return;
    Angular<M> moments;
    for (int k = 0; k < M::angular; ++k) moments[k] = inverse_of(mass.angular[k]);
    bool exact = moments.minCoeff() > 0;
    if constexpr (M::angular == 3)
      exact = exact && moments.maxCoeff() <= (moments.sum() - moments.maxCoeff()) * (1 + 1e-12);
    exact ? writer.put("inertia", list_of(moments)) : writer.put("inverse_inertia", list_of(mass.angular));
  }
}

template <class M>
void write_rotation(Writer& writer, const Rotation<M>& rotation) {
  if constexpr (M::angular > 0) {
    const auto kept = numbers_of(rotation);
    if (same(kept, numbers_of(Pose<M>().rotation))) return;
    if constexpr (M::angular == 1) {
      const double angle = principal_angle<double>(rotation);
      if (same(numbers_of(plane_rotation(angle)), kept)) return writer.put("angle", exact(angle));
    }
    writer.put("rotation", list_of(kept));
  }
}

template <class M>
std::string body_text(const Scene<M>& scene, int body, const std::string& name) {
  const Bodies<M>& bodies = scene.bodies();
  Writer writer;
  if (!name.empty()) writer.put("name", quoted(name));
  Shape<M> shape;
  if constexpr (M::angular > 0)
    if (static_cast<std::size_t>(body) < scene.colliders().shapes.size()) shape = scene.colliders().shapes[body];
  write_mass<M>(writer, bodies.inverse_mass[body], shape);
  writer.put("position", list_of(bodies.pose[body].position));
  write_rotation<M>(writer, bodies.pose[body].rotation);
  const Velocity<M>& V = bodies.velocity[body];
  const Linear<M> v = V.template head<M::linear>();
  if (!same(v, Linear<M>(Linear<M>::Zero()))) writer.put("velocity", list_of(v));
  if constexpr (M::angular > 0) {
    const Angular<M> spin = V.template tail<M::angular>();
    if (!same(spin, Angular<M>(Angular<M>::Zero()))) writer.put("spin", list_of(spin));
    if (!std::holds_alternative<std::monostate>(shape)) {
      Writer inner;
      if (const auto* round = std::get_if<Ball<M>>(&shape)) inner.put("ball", exact(round->radius));
      if (const auto* block = std::get_if<Box<M>>(&shape)) inner.put("box", list_of(block->sides));
      if (const auto* half = std::get_if<HalfSpace<M>>(&shape)) inner.put("half_space", list_of(half->normal));
      writer.put("shape", inner.object());
      const Surface& surface = scene.colliders().surfaces[body];
      writer.number(friction, surface.friction);
      writer.number(restitution, surface.restitution);
      const Layers& layers = scene.colliders().layers[body];
      if (layers.in != 1) writer.put("layers_in", std::to_string(layers.in));
      if (layers.meets != Layers().meets) writer.put("layers_met", std::to_string(layers.meets));
    }
  }
  if (!bodies.forces.empty()) {
    const BodyForces& forces = bodies.forces[body];
    if (forces.linear_damping != 0) writer.put("damping", exact(forces.linear_damping));
    if (forces.angular_damping != 0) writer.put("spin_damping", exact(forces.angular_damping));
    if (forces.gravity_scale != 1) writer.put("gravity_scale", exact(forces.gravity_scale));
  }
  return writer.object();
}

/// The constraint at a place in natural order.
template <class M>
std::string constraint_text(const Scene<M>& scene, int place, const std::vector<int>& number_of) {
  ConstraintWriter<M> writer(scene.bodies(), number_of);
  bool known = false;
  for_each_kind<M>([&]<class Kind>(const char* name, const char* on) {
    const Kind* constraint = scene.template get_if<Kind>(place);
    if (!constraint) return;
    known = true;
    Kind copy = *constraint;
    // A handle is no number in a file: the place of the contact is.
    if constexpr (requires { copy.contact; }) copy.contact = scene.place(copy.contact);
    writer.put("kind", quoted(name));
    if (*on) writer.put("on", quoted(on));
    members(writer, copy);
  });
  if (!known)
    throw std::invalid_argument("constraint " + std::to_string(place) + " is of a kind that a file cannot hold");
  return writer.object();
}

template <class M>
constexpr const char* model_name() {
  return M::linear == 2 ? (M::angular ? "plane" : "plane particles") : M::angular ? "space" : "space particles";
}

/// Lines of a list, each an object.
std::string lines(const std::string& name, const std::vector<std::string>& objects) {
  std::string text = "  " + quoted(name) + ": [";
  for (std::size_t i = 0; i < objects.size(); ++i) text += (i ? ",\n    " : "\n    ") + objects[i];
  return text + (objects.empty() ? "]" : "\n  ]");
}

template <class M>
std::string text_of_scene(const SceneFile& file, const Scene<M>& scene) {
  const Bodies<M>& bodies = scene.bodies();
  if (!bodies.applied.empty())
    throw std::invalid_argument("a file cannot hold forces that act in the next step alone");
  std::vector<std::string> parts;
  const auto put = [&](const char* name, const std::string& json) {
    parts.push_back("  " + quoted(name) + ": " + json);
  };
  if (!file.title.empty()) put("title", quoted(file.title));
  if (!file.about.empty()) put("about", quoted(file.about));
  put("model", quoted(model_name<M>()));
  put("gravity", list_of(scene.gravity));
  put("step", exact(file.step));
  put("duration", exact(file.duration));
  Writer method;
  VelocityStepping copy = file.method;
  members(method, copy);
  put("method", method.object());
  if (!file.accuracy.empty()) {
    Writer accuracy;
    for (const auto& [name, limit] : file.accuracy) accuracy.put(name, exact(limit));
    put("accuracy", accuracy.object());
  }
  if constexpr (M::angular > 0) {
    const Colliders<M>& colliders = scene.colliders();
    if (colliders.margin != *contact_margin.otherwise) put(contact_margin.name, exact(colliders.margin));
    if (colliders.lookahead != *contact_lookahead.otherwise)
      put(contact_lookahead.name, exact(colliders.lookahead));
    if (M::linear == 2 && colliders.rows == ContactRows::points) put("contact_rows", quoted("points"));
  }
  std::vector<int> number_of(static_cast<std::size_t>(bodies.size()), -1);
  std::vector<std::string> all;
  for (int body = 0; body < bodies.size(); ++body) {
    if (!bodies.has(body)) continue;
    number_of[body] = static_cast<int>(all.size());
    const auto named = static_cast<std::size_t>(body);
    all.push_back(body_text(scene, body, named < file.names.size() ? file.names[named] : ""));
  }
  parts.push_back(lines("bodies", all));
  all.clear();
  for (int place = 0; place < scene.count(); ++place) all.push_back(constraint_text(scene, place, number_of));
  if (!all.empty()) parts.push_back(lines("constraints", all));
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ",\n") + part;
  return "{\n" + text + "\n}\n";
}

}  // namespace
}  // namespace scene_file

std::string write_scene(const SceneFile& file) {
  return std::visit([&](const auto& scene) { return scene_file::text_of_scene(file, scene); }, file.scene);
}

}  // namespace byhand
