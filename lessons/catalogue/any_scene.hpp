#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lessons/methods/method.hpp"

namespace byhand {

/// Where a body of any model is: in the plane z is zero and it turns about z.
struct Placement {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      // of its centre [m]
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // from the body's axes to the world's
  bool moves = true;
};

/// What a method has done, in counts that are the same on every machine.
struct Effort {
  long long row_solves = 0;  // uses of (17) and (20); a direct solve counts as those of as many multiplications
  Executed executed;
  long long planned = 0;         // operations of a direct solver's plans, whenever its rows are laid out anew
  long long written_rows = 0;    // once in each substep
  long long bodies = 0;          // moved: once in each substep
  long long contacts = 0;        // rows of contacts, found once in each step
  long long computed_pairs = 0;  // whose contact was computed, as their bodies had moved
  long long substeps = 0, steps = 0;
};

/// A scene of any model with any method, for programs that choose both as they run. A value: a copy is a way back.
class AnyScene {
 public:
  /// The scene as it is, stepped by velocities with Gauss–Seidel.
  template <class M>
  AnyScene(Scene<M> scene);
  AnyScene(const AnyScene& other);
  AnyScene(AnyScene&& other) noexcept;
  AnyScene& operator=(AnyScene other) noexcept;
  ~AnyScene();

  /// Goes on from here with that method and nothing kept. Throws std::invalid_argument for a choice outside its
  /// range and, with the refusal, for a method that cannot run this scene.
  void use(const Method& method);
  /// Why the method cannot run this scene, in one sentence; empty where it can.
  std::string refusal(const Method& method) const;

  /// One time step h [s]. Errors as `advance` of the method.
  void step(double h);
  /// What has been stepped so far [s].
  double time() const { return time_; }
  /// What the method has spent since it was chosen.
  long long row_solves() const { return effort().row_solves + effort().executed.projected_rows; }
  Effort effort() const;

  /// How far the two points of any joint are apart, or a rod from its length, or two bodies in each other, at most
  /// [m].
  double separation() const;
  /// Kinetic and potential [J].
  double energy() const;
  /// What the weight of all bodies would do over their distances from the first fixed body, or from the origin if
  /// none is fixed; or the kinetic energy where there is no weight: what a change of energy is measured by [J].
  double energy_scale() const;
  /// Σ m v [N s]
  Eigen::Vector3d momentum() const;
  /// Σ x × m v + Iω about the origin [kg m²/s]; in the plane along z.
  Eigen::Vector3d angular_momentum() const;
  /// Σ m g [N]
  Eigen::Vector3d weight() const;
  /// The largest difference of any velocity from that of the direct solve of the same first substep of a step of h
  /// [s] [m/s, rad/s]; NaN for a method that does not solve rows, and where rows repeat each other.
  double algebraic_error(double h) const;
  /// The largest residual of the rows of the last substep, see gauss_seidel.hpp [m/s]: for contacts, how far they
  /// are from complementarity and from the friction cone. NaN for a method that does not solve rows for
  /// velocities.
  double residual() const;
  /// The largest distance of the centre of a body that moves from its place, of as many places [m].
  double farthest_from(const std::vector<Eigen::Vector3d>& places) const;
  /// Whether all poses and velocities are finite.
  bool finite() const;

  /// Where each body is, in the order of the scene.
  std::vector<Placement> placements() const;

  /// Numbers that all moving bodies move with, without regard to what holds them.
  int degrees_of_freedom() const;
  /// What its rows act on, for their prices: "free bobs" or "free bodies" are held by nothing, "ropes" hold bobs
  /// with bounds, "machines" have a motor, a servo or a limit among their joints, shapes touch as "boxes", "balls
  /// that touch" or "joined shapes"; else "bobs", "balls" or "links". All of these also "… in space", and there
  /// "hinges in space".
  std::string row_kind() const;
  /// Rows of all constraints.
  int rows() const;
  /// Bytes of all poses, velocities, masses, shapes and constraints: what describes the scene.
  std::size_t scene_bytes() const;
  /// Bytes of all rows: J, M⁻¹Jᵀ and the numbers of each.
  std::size_t row_bytes() const;

 private:
  struct Running;
  template <class F>
  auto read(F&& f) const;
  template <class F>
  auto read_with_contacts(F&& f) const;

  std::unique_ptr<Running> running_;
  double time_ = 0;  // [s]
  Effort effort_;    // without row-solves, which the method counts
};

}  // namespace byhand
