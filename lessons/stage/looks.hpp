#pragma once

#include <vector>

#include "lessons/catalogue/any_scene.hpp"
#include "lessons/scene_file/scene_file.hpp"
#include "renderer/canvas.hpp"

// Pictures of any scene, in the plane and in space.
namespace byhand::stage {

/// How a body looks, in its own frame; in the plane z is zero.
struct BodyLook {
  enum class As { nothing, disc, box, half_space, link, bob };
  As as = As::nothing;
  Eigen::Vector3d sides =
      Eigen::Vector3d::Zero();  // of a box; the radius of a disc in x; the normal of a half-space
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();  // of a link
  double mass = 0;                                                               // of a bob [kg]
};

/// What holds two bodies, between points in their frames.
struct TieLook {
  enum class As { rod, spring, joint, surface };
  As as = As::joint;
  int body1 = 0, body2 = 0;
  Eigen::Vector3d arm1 = Eigen::Vector3d::Zero(), arm2 = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal =
      Eigen::Vector3d::Zero();  // of the surface on which a listed contact rests, in the world
};

struct SceneLook {
  bool in_space = false;
  std::vector<BodyLook> bodies = {};
  std::vector<TieLook> ties = {};
};
SceneLook look_of(const SceneOfAnyModel& scene);

using Instant = std::vector<Placement>;

/// The smallest box around all that moves over these instants [m].
struct View {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();
};
View view_of(const SceneLook& look, const std::vector<Instant>& instants);

/// Draws an instant into a frame of the page; `marked` bodies in the colour of errors.
void draw(renderer::Canvas& canvas, const SceneLook& look, const Instant& instant, const View& view,
          const renderer::Rectangle& frame, const std::vector<int>& marked = {});

}  // namespace byhand::stage
