#include <nlohmann/json.hpp>

#include "lessons/scene_file/members.hpp"

namespace byhand {
namespace scene_file {
namespace {

using Json = nlohmann::ordered_json;

const Json point = {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 3}};
const Json angle = {{"type", Json::array({"number", "string"})}};

Json described(Json type, const std::string& meaning, const std::string& unit = "") {
  type["description"] = meaning + (unit.empty() ? "" : " [" + unit + "]");
  return type;
}
std::string both(const std::string& meaning, const std::string& other) {
  return meaning.find(other) == std::string::npos ? meaning + "; or " + other : meaning;
}
Json list_of(const Json& each, int count) {
  return {{"type", "array"}, {"items", each}, {"minItems", count}, {"maxItems", count}};
}

/// Describes the members of one object.
class Schema {
 public:
  Json properties = Json::object(), required = Json::array();

  void put(const std::string& name, const std::string& meaning, Json type, const std::string& unit = "") {
    Json one = described(std::move(type), meaning, unit);
    // Choices of one object share names: what each means by them is listed.
    if (const auto known = properties.find(name); known != properties.end())
      one["description"] = both(known->at("description"), one["description"]);
    properties[name] = std::move(one);
  }
  Json object() const {
    Json all = {{"type", "object"}, {"properties", properties}};
    if (!required.empty()) all["required"] = required;
    all["additionalProperties"] = false;
    return all;
  }

  void number(const Number& member, double) {
    Json type = {{"type", "number"}};
    if (member.angle || member.may_be_infinite) type["type"] = Json::array({"number", "string"});
    if (std::isfinite(member.low)) type[member.above_low ? "exclusiveMinimum" : "minimum"] = member.low;
    if (member.high < 1e300) type["maximum"] = member.high;
    if (member.otherwise)
      type["default"] = *member.otherwise;
    else
      required.push_back(member.name);
    put(member.name, member.meaning, type, member.unit);
  }
  void whole(const Number& member, int) {
    number(member, 0);
    properties[member.name]["type"] = "integer";
  }
  void flag(const std::string& name, const std::string& meaning, bool, bool otherwise) {
    put(name, meaning, {{"type", "boolean"}, {"default", otherwise}});
  }
  template <class Enum>
  void name(const std::string& name, const std::string& meaning, Enum, const std::vector<std::string>& names) {
    put(name, meaning, {{"enum", names}, {"default", names.front()}});
  }
  template <class... Choices>
  void one_of(const std::string& name, const std::string& meaning, std::variant<Choices...>&,
              const std::array<const char*, sizeof...(Choices)>& names, int otherwise) {
    put(name, meaning, {{"enum", names}, {"default", names[static_cast<std::size_t>(otherwise)]}});
    const auto each = [&](auto choice) { members(*this, choice); };
    (each(Choices()), ...);
  }

  void bodies(int, int) {
    put("bodies", "the first and the second body, each by its name or its number from 0",
        list_of({{"type", Json::array({"integer", "string"})}}, 2));
    required.push_back("bodies");
  }
  template <class M>
  void anchors(const Anchors<M>&) {
    bodies(0, 0);
    put("point", "where it acts on both, in the world; without it at the centres", point, "m");
    put("points", "where it acts on each, in the world", list_of(point, 2), "m");
    arms("arms", "the same in the bodies' frames", Arms<SpaceBody>());
  }
  template <class M>
  void arms(const std::string& name, const std::string& meaning, const Arms<M>&) {
    put(name, meaning, list_of(point, 2), "m");
  }
  template <class M>
  void length(double, const Anchors<M>&) {
    put("length", "without it the present distance", {{"type", "number"}, {"exclusiveMinimum", 0}}, "m");
  }
  template <class R>
  void rest(const R&, int, int) {
    put("rest",
        "orientation of the first body in the second's frame at zero, [cos, sin] or [w, x, y, z]; without it "
        "the present one",
        {{"type", "array"}, {"items", {{"type", "number"}}}});
  }
  template <class V>
  void direction(const std::string& name, const V&, int body) {
    put("axis", "in the world, of any length", point);
    put(name,
        std::string("unit vector in the frame of the ") + (name == "axis1" ? "first" : "second") +
            " body, instead of axis",
        point);
    (void)body;
  }
  template <class V>
  void across(const V& across, int) {
    put("axis", "in the world, of any length", point);
    columns("across", "unit vectors across the axis, in the frame of the first body, instead of axis", across);
  }
  template <class V>
  void columns(const std::string& name, const std::string& meaning, const V&) {
    put(name, meaning, {{"type", "array"}, {"items", point}});
  }
  template <class V>
  void vector(const std::string& name, const std::string& meaning, const V&) {
    put(name, meaning, point);
  }
  void stop(double, Stop) {
    put("at_least", "a lower stop; or", angle, "rad or m");
    put("at_most", "an upper one", angle, "rad or m");
  }
  void contact(int) {
    put("contact", "number of the constraint, before this one, that presses",
        {{"type", "integer"}, {"minimum", 0}});
    required.push_back("contact");
  }
};

Json bodies_schema() {
  Schema body;
  const Json positive = {{"type", "number"}, {"exclusiveMinimum", 0}},
             moments = {{"type", "array"}, {"items", positive}};
  body.put("name", "by which constraints and findings call it", {{"type", "string"}});
  body.put("fixed", "whether no force moves it; it keeps its velocity", {{"type", "boolean"}, {"default", false}});
  body.put("mass", "of a body that is not fixed", positive, "kg");
  body.put("inertia", "principal moments: one in the plane, three in space; without it those of the shape",
           moments, "kg m²");
  body.put("inverse_mass", "instead of mass, where no mass has it to the bit", positive, "1/kg");
  body.put("inverse_inertia", "instead of inertia", moments, "1/(kg m²)");
  body.put("position", "of the centre of mass", point, "m");
  body.put("angle", "orientation: an angle in the plane, a rotation vector in space; \"30°\" is allowed",
           Json::object(), "rad");
  body.put("rotation", "instead of angle: [cos, sin], or [w, x, y, z]",
           {{"type", "array"}, {"items", {{"type", "number"}}}});
  body.put("velocity", "of the centre of mass", point, "m/s");
  body.put("spin", "one number in the plane, three in space", {{"type", "array"}, {"items", angle}}, "rad/s");
  Schema shape;
  shape.put("ball", "radius", positive, "m");
  shape.put("box", "side lengths", point, "m");
  shape.put("half_space", "unit normal out of the solid, in the body's frame", point);
  Json one = shape.object();
  one["minProperties"] = one["maxProperties"] = 1;
  body.put("shape", "with which it touches others", one);
  body.number(friction, 0);
  body.number(restitution, 0);
  body.put("layers_in", "bits of the layers that it is in", {{"type", "integer"}, {"default", 1}});
  body.put("layers_met", "bits of the layers that it touches", {{"type", "integer"}, {"default", 4294967295}});
  body.put("damping", "v' = −c v", {{"type", "number"}, {"minimum", 0}, {"default", 0}}, "1/s");
  body.put("spin_damping", "ω' = −d ω", {{"type", "number"}, {"minimum", 0}, {"default", 0}}, "1/s");
  body.put("gravity_scale", "gravity on it, times this", {{"type", "number"}, {"default", 1}});
  return body.object();
}

/// A schema for each kind and freedom, from the model that has most of them.
template <class M>
void add_kinds(Json& all, std::vector<std::string>& seen) {
  for_each_kind<M>([&]<class Kind>(const char* name, const char* on) {
    const std::string called = std::string(name) + (*on ? std::string(" on ") + on : "");
    if (std::find(seen.begin(), seen.end(), called) != seen.end()) return;
    seen.push_back(called);
    Schema schema;
    schema.put("kind", called, {{"const", name}});
    schema.required.push_back("kind");
    if (*on) {
      schema.put("on", "the freedom that it acts on", {{"const", on}});
      schema.required.push_back("on");
    }
    Kind kind;
    members(schema, kind);
    all.push_back(schema.object());
  });
}

}  // namespace
}  // namespace scene_file

std::string scene_schema() {
  using namespace scene_file;
  Schema scene;
  scene.put("$schema", "this schema", {{"type", "string"}});
  scene.put("title", "what it is called", {{"type", "string"}});
  scene.put("about", "what it shows", {{"type", "string"}});
  scene.put("model", "how many numbers a body moves with",
            {{"enum", {"plane", "space", "plane particles", "space particles"}}});
  scene.put("gravity", "without it 9.81 downwards; y is up", point, "m/s²");
  scene.put("step", "h", {{"type", "number"}, {"minimum", 1e-6}, {"maximum", 1}, {"default", 1.0 / 60}}, "s");
  scene.put("duration", "how long it is watched",
            {{"type", "number"}, {"exclusiveMinimum", 0}, {"maximum", 3600}, {"default", 5}}, "s");
  Schema method;
  VelocityStepping any;
  members(method, any);
  scene.put("method", "how it is stepped", method.object());
  Schema accuracy;
  for (const auto& [name, about] : accuracy_names())
    accuracy.put(name, about.meaning, {{"type", "number"}, {"exclusiveMinimum", 0}}, about.unit);
  scene.put("accuracy", "what shall be accurate", accuracy.object());
  scene.number(contact_margin, 0);
  scene.number(contact_lookahead, 0);
  scene.put("contact_rows", "in the plane: one manifold for both points of a face, or a contact for each",
            {{"enum", {"manifold", "points"}}, {"default", "manifold"}});
  scene.put("bodies", "all bodies, numbered from 0",
            {{"type", "array"}, {"items", bodies_schema()}, {"minItems", 1}});
  Json kinds = Json::array();
  std::vector<std::string> seen;
  add_kinds<SpaceBody>(kinds, seen);
  add_kinds<PlaneBody>(kinds, seen);
  scene.put("constraints", "all constraints, numbered from 0", {{"type", "array"}, {"items", {{"oneOf", kinds}}}});
  scene.required = {"model", "bodies"};
  Json all = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "A scene of Constraints by Hand"},
              {"description", "SI units; y is up. Comments, // and /* */, are allowed."}};
  const Json described_scene = scene.object();
  for (const auto& [name, value] : described_scene.items()) all[name] = value;
  return all.dump(2) + "\n";
}

}  // namespace byhand
