// This course's solver as one more engine under node: compiled to WebAssembly, called by this_course.mjs.

#include "lessons/engines/in_space.hpp"
#include "lessons/scene_file/scene_file.hpp"
#include "lessons/scene_file/value.hpp"

namespace {

using namespace byhand;
using namespace byhand::engines;

template <class M>
struct Running {
  std::unique_ptr<World<M>> world;
  Bodies<M> bodies;
};

std::string request_text;
std::variant<std::monostate, Running<PlaneBody>, Running<SpaceBody>> running;
std::vector<double> numbers;  // that are passed, some for each body

template <class M>
std::unique_ptr<World<M>> build(const Scene<M>& scene, const Knobs& knobs) {
  if constexpr (M::linear == 2)
    return this_course().in_plane(scene, knobs);
  else
    return this_course().in_space(scene, knobs);
}

/// Calls act(Running<M>&).
template <class F>
void on_run(F&& act) {
  if (auto* plane = std::get_if<Running<PlaneBody>>(&running)) act(*plane);
  if (auto* space = std::get_if<Running<SpaceBody>>(&running)) act(*space);
}

/// Of a vector, to the numbers.
void put(const Eigen::Vector3d& v) { numbers.insert(numbers.end(), v.begin(), v.end()); }

}  // namespace

double byhand::engines::processor_seconds() { return 0; }  // the host has the clock

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

/// Where a request of so many bytes is written.
EXPORT(request) char* request(int size) {
  request_text.assign(static_cast<std::size_t>(size), '\0');
  return request_text.data();
}

/// Makes the world that the request asks for: {"knobs": {…}, "scene": the text of a scene's file}.
EXPORT(make) void make() {
  const json::Value asked = json::parse(request_text);
  std::vector<std::pair<std::string, double>> turned;
  for (const auto& [name, value] : asked.find("knobs")->members) turned.emplace_back(name, value.number);
  std::visit(
      [&]<class M>(const Scene<M>& scene) {
        if constexpr (M::angular > 0) running = Running<M>{build<M>(scene, Knobs(turned)), scene.bodies()};
      },
      read_scene(asked.find("scene")->text).scene);
}

EXPORT(step) void step(double h) {
  on_run([&](auto& run) { run.world->step(h); });
}

EXPORT(bodies) int bodies() {
  int count = 0;
  on_run([&](const auto& run) { count = run.bodies.size(); });
  return count;
}

/// Position, quaternion from w on, velocity and spin of each body.
EXPORT(read) const double* read() {
  numbers.clear();
  on_run([]<class M>(Running<M>& run) {
    run.world->read(run.bodies);
    for (int i = 0; i < run.bodies.size(); ++i) {
      put(in_space(run.bodies.pose[i].position));
      const Eigen::Quaterniond q = rotation_in_space<M>(run.bodies.pose[i]);
      numbers.push_back(q.w());
      put(q.vec());
      put(velocity_in_space<M>(run.bodies.velocity[i]));
      put(spin_in_space<M>(run.bodies.velocity[i]));
    }
  });
  return numbers.data();
}

/// Where velocity and spin of each body are written, before they are taken.
EXPORT(velocities) double* velocities() {
  numbers.resize(6 * static_cast<std::size_t>(bodies()));
  return numbers.data();
}
EXPORT(take_velocities) void take_velocities() {
  on_run([]<class M>(Running<M>& run) {
    for (int i = 0; i < run.bodies.size(); ++i) {
      const double* v = &numbers[6 * static_cast<std::size_t>(i)];
      if constexpr (M::linear == 2)
        run.bodies.velocity[i] << v[0], v[1], v[5];
      else
        run.bodies.velocity[i] = Eigen::Map<const Velocity<M>>(v);
    }
    run.world->set_velocities(run.bodies);
  });
}
