#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "solver/measure.hpp"
#include "solver/methods/method.hpp"

namespace byhand {

/// Where a body of any model is: in the plane z is zero and it turns about z.
struct Placement {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      // of its centre [m]
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // from the body's axes to the world's
  bool moves = true;
};

/// A scene of some type with some method, behind one interface.
struct RunningScene {
  virtual ~RunningScene() = default;
  virtual std::unique_ptr<RunningScene> clone() const = 0;

  /// Goes on from here with that method and nothing kept. Throws std::invalid_argument for a choice outside its
  /// range and, with the refusal, for a method that cannot run this scene.
  virtual void use(const Method& method) = 0;
  /// Why the method cannot run this scene, in one sentence; empty where it can.
  virtual std::string refusal(const Method& method) const = 0;

  /// One time step h [s]. Errors as `advance` of the method.
  virtual void step(double h) = 0;
  /// What has been stepped so far [s].
  virtual double time() const = 0;
  /// What the method has spent since it was chosen.
  virtual long long row_solves() const = 0;

  /// The error of the position constraints, in the units of C.
  virtual PositionError position_error() const = 0;
  /// How far the two points of any joint are apart, or a rod from its length, or two bodies in each other, at most
  /// [m].
  virtual double separation() const = 0;
  /// Kinetic and potential [J].
  virtual double energy() const = 0;
  /// What the weight of all bodies would do over their distances from the origin, or the kinetic energy where
  /// there is no weight: what a change of energy is measured by [J].
  virtual double energy_scale() const = 0;
  /// Σ m v [N s]
  virtual Eigen::Vector3d momentum() const = 0;
  /// Σ x × m v + Iω about the origin [kg m²/s]; in the plane along z.
  virtual Eigen::Vector3d angular_momentum() const = 0;
  /// Σ m g [N]
  virtual Eigen::Vector3d weight() const = 0;
  /// The largest difference of any velocity from that of the direct solve of the same first substep of a step
  /// of h [s] [m/s, rad/s]; NaN for a method that does not solve rows, and where rows repeat each other.
  virtual double algebraic_error(double h) const = 0;
  /// Whether all poses and velocities are finite.
  virtual bool finite() const = 0;

  /// Where each body is, in the order of the scene.
  virtual std::vector<Placement> placements() const = 0;
  /// v and ω of each body [m/s, rad/s].
  virtual std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> velocities() const = 0;
  /// The two points that each constraint joins [m].
  virtual std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> joints() const = 0;

  /// "particles in the plane", "bodies in space", …
  virtual std::string model() const = 0;
  /// Numbers that all moving bodies move with, without regard to what holds them.
  virtual int degrees_of_freedom() const = 0;
  /// Rows of all constraints.
  virtual int rows() const = 0;
  virtual int bodies() const = 0;
  /// Bytes of all poses, velocities, masses, shapes and constraints: what describes the scene.
  virtual std::size_t scene_bytes() const = 0;
  /// Bytes of all rows: J, M⁻¹Jᵀ and the numbers of each.
  virtual std::size_t row_bytes() const = 0;
};

/// A scene of any type with any method, for programs that choose both as they run. A value: a copy is a way back.
class AnyScene {
 public:
  explicit AnyScene(std::unique_ptr<RunningScene> running) : running_(std::move(running)) {}
  AnyScene(const AnyScene& other) : running_(other.running_->clone()) {}
  AnyScene(AnyScene&&) noexcept = default;
  AnyScene& operator=(AnyScene other) noexcept {
    running_ = std::move(other.running_);
    return *this;
  }
  RunningScene* operator->() { return running_.get(); }
  const RunningScene* operator->() const { return running_.get(); }

 private:
  std::unique_ptr<RunningScene> running_;
};

/// Hides the type of a scene, which then runs those families of methods. Compiled for each type in a file of its
/// own: lessons/09_what_accuracy_costs/catalogue/scenes.
template <class S, class Families = Method>
AnyScene any_scene(S scene);

}  // namespace byhand
