// Engines that exist in WebAssembly only, through one host under node (under_node/host.mjs).

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "lessons/engines/in_space.hpp"
#include "lessons/engines/mujoco_model.hpp"
#include "lessons/scene_file/scene_file.hpp"

namespace byhand::engines {
namespace {

using nlohmann::json;

const std::string host_program = BYHAND_HOST, modules = BYHAND_NODE_MODULES;

/// The host, which answers a line of JSON with another.
class Host {
 public:
  Host() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::string words[] = {"node", "--no-warnings", host_program, modules};
    char* argv[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    if (posix_spawnp(&process_, "node", &actions, nullptr, argv, environ) != 0) process_ = 0;
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    socket_ = ends[0];
    answers_ = fdopen(socket_, "r");
  }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
  /// Without its input the host ends.
  ~Host() {
    if (answers_) std::fclose(answers_);
    if (process_ > 0) waitpid(process_, nullptr, 0);
  }

  /// The answer; null once the host has ended, as it does where an engine fails.
  json ask(const json& request) {
    const std::string line = request.dump() + '\n';
    std::string answer;
    for (std::size_t sent = 0; sent < line.size();) {
      const ssize_t taken = send(socket_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL);
      if (taken < 0) return ended();
      sent += static_cast<std::size_t>(taken);
    }
    for (int letter = 0; (letter = std::getc(answers_)) != '\n'; answer += static_cast<char>(letter))
      if (letter == EOF) return ended();
    return json::parse(answer);
  }
  bool has_ended() const { return ended_; }

 private:
  json ended() {
    ended_ = true;
    return nullptr;
  }

  pid_t process_ = 0;
  int socket_ = -1;
  std::FILE* answers_ = nullptr;
  bool ended_ = false;
};

/// One for all worlds, which run one after the other: an engine that has run for long is compiled best.
std::shared_ptr<Host> the_host() {
  static std::shared_ptr<Host> host;
  if (!host || host->has_ended()) host = std::make_shared<Host>();
  return host;
}

json numbers(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// A scene as engines of space need it: in the plane it is flat, at z = 0.
template <class M>
json scene_in_space(const Scene<M>& scene) {
  json all = {{"flat", M::linear == 2},
              {"gravity", numbers(in_space(scene.gravity))},
              {"bodies", json::array()},
              {"pins", json::array()}};
  const Bodies<M>& bodies = scene.bodies();
  for (int i = 0; i < bodies.size(); ++i) {
    const Eigen::Quaterniond q = rotation_in_space<M>(bodies.pose[i]);
    const bool fixed = !moves(bodies.inverse_mass[i]);
    json body = {{"fixed", fixed},
                 {"position", numbers(in_space(bodies.pose[i].position))},
                 {"rotation", {q.w(), q.x(), q.y(), q.z()}},
                 {"velocity", numbers(velocity_in_space<M>(bodies.velocity[i]))},
                 {"spin", numbers(spin_in_space<M>(bodies.velocity[i]))}};
    if (!fixed) {
      body["mass"] = 1 / bodies.inverse_mass[i].linear;
      body["inertia"] = numbers(inertia_in_space(bodies.inverse_mass[i]));
    }
    all["bodies"].push_back(body);
  }
  const auto put = [&](int i, const char* shape, const Eigen::Vector3d& v, const Surface& surface) {
    all["bodies"][i].update(
        {{shape, numbers(v)}, {"friction", surface.friction}, {"restitution", surface.restitution}});
  };
  for_each_shape(
      scene,
      [&](int i, const Box<M>& box, const Surface& surface) { put(i, "box", sides_in_space(box), surface); },
      [&](int i, const HalfSpace<M>& half_space, const Surface& surface) {
        put(i, "ground", in_space(half_space.normal), surface);
      });
  for_each_joint(
      scene,
      [&](const Pin<M>& pin) {
        all["pins"].push_back(
            {{"bodies", {pin.at.body1, pin.at.body2}},
             {"arms", {numbers(in_space(pin.at.arms.first)), numbers(in_space(pin.at.arms.second))}}});
      },
      [](const Distance<M>&) { throw std::invalid_argument("engines under node are given pins only"); });
  return all;
}

template <class M>
class UnderNode : public World<M> {
 public:
  UnderNode(json asked, const Knobs& knobs) : host_(the_host()) {
    asked["knobs"] = json::object();
    for (const auto& [name, value] : knobs.turned()) asked["knobs"][name] = value;
    host_->ask(asked);
  }

  /// Steps are taken when something is asked of them, all at once.
  void step(double h) override {
    if (h != h_) take_steps();
    h_ = h;
    ++steps_;
  }
  void read(Bodies<M>& bodies) const override {
    const json answer = take_steps();
    const auto number = [&](int i, int k) {
      const json& body = answer.is_null() ? answer : answer["bodies"][i];
      const bool finite = !body.is_null() && body[k].is_number();  // JSON has no other numbers
      return finite ? body[k].template get<double>() : std::numeric_limits<double>::quiet_NaN();
    };
    for (int i = 0; i < bodies.size(); ++i) {
      double x[13];
      for (int k = 0; k < 13; ++k) x[k] = number(i, k);
      put(bodies, i, {x[0], x[1], x[2]}, {x[3], x[4], x[5], x[6]}, {x[7], x[8], x[9]}, {x[10], x[11], x[12]});
    }
  }
  void set_velocities(const Bodies<M>& bodies) override {
    take_steps();
    json all = json::array();
    for (const Velocity<M>& V : bodies.velocity) {
      const Eigen::Vector3d v = velocity_in_space<M>(V), spin = spin_in_space<M>(V);
      all.push_back({v.x(), v.y(), v.z(), spin.x(), spin.y(), spin.z()});
    }
    host_->ask({{"velocities", all}});
  }
  double seconds() const override {
    const json answer = take_steps();
    return answer.is_null() ? std::numeric_limits<double>::infinity() : answer["seconds"].template get<double>();
  }

 private:
  json take_steps() const { return host_->ask({{"steps", std::exchange(steps_, 0)}, {"h", h_}}); }

  std::shared_ptr<Host> host_;
  double h_ = 0;
  mutable int steps_ = 0;  // that are still to be taken
};

/// Builds worlds of an engine of the host's, in one of its modes.
template <class M>
Build<M> in_host(const std::string& engine, const std::string& mode = "") {
  return [=](const Scene<M>& scene, const Knobs& knobs) {
    const json asked = {{"engine", engine}, {"mode", mode}, {"scene", scene_in_space(scene)}};
    return std::make_unique<UnderNode<M>>(asked, knobs);
  };
}
template <class M>
Build<M> mujoco() {
  return [](const Scene<M>& scene, const Knobs& knobs) {
    json own = scene_in_space(scene);
    own["model"] = mujoco_model(scene, knobs);
    return std::make_unique<UnderNode<M>>(json{{"engine", "mujoco"}, {"scene", own}}, knobs);
  };
}
template <class M>
Build<M> ours() {
  return [](const Scene<M>& scene, const Knobs& knobs) {
    SceneFile file;
    file.scene = scene;
    const json asked = {{"engine", "this_course"}, {"scene", write_scene(file)}};
    return std::make_unique<UnderNode<M>>(asked, knobs);
  };
}

std::string no_rods(const Asked& asked) { return asked.rods > 0 ? "compared on pins, not on rods" : ""; }
std::string no_rods_or_boxes(const Asked& asked) {
  return asked.boxes > 0 ? "compared on joints only: free boxes are those of PhysX PGS and TGS" : no_rods(asked);
}

/// Those that are installed, and the names of the others.
struct Found {
  std::vector<Engine> engines;
  std::vector<std::string> missing;

  Found() {
    const bool runs =
        std::ifstream(modules + "/this_course.wasm").good() && !the_host()->ask(json::object()).is_null();
    Engine own = this_course();
    own.name += " in WebAssembly";
    own.version = runs ? "this build" : "";
    own.refusal = no_rods;
    own.in_plane = ours<PlaneBody>();
    own.in_space = ours<SpaceBody>();
    add(own);
    const auto add_physx = [&](const std::string& mode, const std::string& method, const Settings& settings,
                               std::string (*refused)(const Asked&)) {
      add({.name = "PhysX " + mode,
           .version = version_of("physx-js-webidl"),
           .method = method,
           .file = "lessons/engines/settings/physx.cpp",
           .single = true,
           .build = "with SIMD",
           .settings = settings,
           .refusal = refused,
           .in_plane = in_host<PlaneBody>("physx", mode),
           .in_space = in_host<SpaceBody>("physx", mode)});
    };
    add_physx("TGS", "sweeps, each over a part of the step", physx_settings(), no_rods);
    add_physx("PGS", "sweeps", physx_settings(), no_rods);
    add_physx("articulation", "one coordinate a hinge: Featherstone's articulated bodies",
              physx_articulation_settings(), no_rods_or_boxes);
    add({.name = "Jolt",
         .version = version_of("jolt-physics"),
         .method = "sweeps, then sweeps over positions",
         .file = "lessons/engines/settings/jolt.cpp",
         .single = true,
         .build = "without SIMD",
         .settings = jolt_settings(),
         .refusal = no_rods,
         .in_plane = in_host<PlaneBody>("jolt"),
         .in_space = in_host<SpaceBody>("jolt")});
    add({.name = "Rapier",
         .version = version_of("@dimforge/rapier2d-deterministic-compat"),
         .method = "one sweep a substep, soft joints and contacts, then a relaxing sweep",
         .file = "lessons/engines/settings/rapier.cpp",
         .home = Home::plane,
         .single = true,
         .build = "without SIMD",
         .settings = rapier_settings(),
         .refusal = no_rods,
         .in_plane = in_host<PlaneBody>("rapier")});
    add({.name = "MuJoCo 3",
         .version = version_of("@mujoco/mujoco"),
         .earlier = "MuJoCo",
         .method = mujoco_method,
         .file = "lessons/engines/settings/mujoco.cpp",
         .home = Home::both,
         .settings = mujoco_settings(),
         .refusal = mujoco_refusal,
         .in_plane = mujoco<PlaneBody>(),
         .in_space = mujoco<SpaceBody>()});
    if (!runs) {
      for (const Engine& engine : engines) missing.push_back(engine.name);
      engines.clear();
    }
  }

 private:
  void add(Engine engine) {
    engine.build = engine.build.empty() ? "WebAssembly" : "WebAssembly " + engine.build;
    engine.version.empty() ? missing.push_back(engine.name) : engines.push_back(engine);
  }
  /// Of a package that npm has fetched; empty if it has not.
  static std::string version_of(const std::string& package) {
    std::ifstream file(modules + "/node_modules/" + package + "/package.json");
    return file ? "npm " + json::parse(file)["version"].get<std::string>() : std::string();
  }
};

const Found& found() {
  static const Found all;
  return all;
}

}  // namespace

const std::vector<Engine>& engines_in_webassembly() { return found().engines; }
const std::vector<std::string>& missing_in_webassembly() { return found().missing; }

}  // namespace byhand::engines
