// MuJoCo, in double precision.

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "lessons/engines/in_space.hpp"
#include "lessons/engines/mujoco_model.hpp"

namespace byhand::engines {
namespace {

/// It would print what goes wrong and end the program.
void take_errors() {
  mju_user_warning = [](const char*) {};
  mju_user_error = [](const char* what) { throw std::runtime_error(std::string("MuJoCo: ") + what); };
}

template <class M>
class Mujoco : public World<M> {
 public:
  Mujoco(const Scene<M>& scene, const Knobs& knobs) {
    take_errors();
    const std::string text = mujoco_model(scene, knobs);
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(text.size()));
    std::memcpy(files->filedata[0], text.data(), text.size());
    char error[500] = "";
    model_.reset(mj_loadXML("scene.xml", files.get(), error, sizeof error));
    mj_deleteVFS(files.get());
    if (!model_) throw std::runtime_error(std::string("MuJoCo: ") + error);
    data_.reset(mj_makeData(model_.get()));
    for (int i = 0; i < scene.bodies().size(); ++i)
      bodies_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, std::to_string(i).c_str()));
    set_velocities(scene.bodies());
  }

  void step(double h) override {
    model_->opt.timestep = h;
    mj_step(model_.get(), data_.get());
  }

  void read(Bodies<M>& bodies) const override {
    if (began_anew()) {
      for (Pose<M>& pose : bodies.pose) pose.position.setConstant(std::numeric_limits<double>::quiet_NaN());
      return;
    }
    // After a step positions are new, but what follows from them is that of its beginning.
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    mj_comVel(model_.get(), data_.get());
    for (int i = 0; i < bodies.size(); ++i) {
      const mjtNum *x = data_->xpos + 3 * bodies_[i], *q = data_->xquat + 4 * bodies_[i];
      mjtNum v[6];  // of rotation, of the centre
      mj_objectVelocity(model_.get(), data_.get(), mjOBJ_BODY, bodies_[i], v, 0);
      put(bodies, i, {x[0], x[1], x[2]}, {q[0], q[1], q[2], q[3]}, {v[3], v[4], v[5]}, {v[0], v[1], v[2]});
    }
  }
  void set_velocities(const Bodies<M>& bodies) override {
    for (int i = 0; i < bodies.size(); ++i) {
      const int first = model_->body_jntadr[bodies_[i]];
      const bool free =
          first >= 0 && model_->jnt_type[first] != mjJNT_HINGE && model_->jnt_type[first] != mjJNT_BALL;
      if (!free) {
        if (!bodies.velocity[i].isZero()) throw std::invalid_argument("MuJoCo is given trees at rest only");
        continue;
      }
      mjtNum* rate = data_->qvel + model_->jnt_dofadr[first];
      Eigen::Map<Velocity<M>> written(rate);
      written = bodies.velocity[i];
      // A free joint counts spin along the axes of the body.
      if constexpr (M::linear == 3)
        written.template tail<3>() = bodies.pose[i].rotation.conjugate() * spin_in_space<M>(bodies.velocity[i]);
    }
  }

 private:
  /// As it does where numbers overflow.
  bool began_anew() const {
    return std::ranges::any_of(std::array{mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC},
                               [&](int what) { return data_->warning[what].number > 0; });
  }

  struct Free {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
  std::vector<int> bodies_;
};

template <class M>
std::unique_ptr<World<M>> build(const Scene<M>& scene, const Knobs& knobs) {
  return std::make_unique<Mujoco<M>>(scene, knobs);
}

}  // namespace

void add_mujoco(std::vector<Engine>& all) {
  all.push_back({.name = "MuJoCo",
                 .version = mj_versionString(),
                 .method = mujoco_method,
                 .file = "lessons/engines/settings/mujoco.cpp",
                 .home = Home::both,
                 .settings = mujoco_settings(),
                 .refusal = [](const Asked& asked) -> std::string {
                   constexpr int most_boxes = 1;  // later versions take a fourteenth of the time for contacts
                   return asked.boxes > most_boxes
                              ? "piles: not compared; pyramids of a later version are, in WebAssembly"
                              : mujoco_refusal(asked);
                 },
                 .in_plane = build<PlaneBody>,
                 .in_space = build<SpaceBody>});
}

}  // namespace byhand::engines
