#pragma once

#include "lessons/engines/engine.hpp"
#include "solver/integrate/rotation.hpp"

// What the adapters share.
namespace byhand::engines {

/// Each adds an engine, or several modes of it. Defined where the engine was found.
void add_box2d_3(std::vector<Engine>& all);
void add_box2d_2(std::vector<Engine>& all);
void add_box3d(std::vector<Engine>& all);
void add_chipmunk(std::vector<Engine>& all);
void add_bullet(std::vector<Engine>& all);
void add_bullet_multibody(std::vector<Engine>& all);
void add_ode(std::vector<Engine>& all);
void add_mujoco(std::vector<Engine>& all);

inline std::string version_text(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

/// Of an engine that limits how fast bodies move [m/s].
inline constexpr float no_limit_of_speed = 1e5f;

inline double angle_of(const PlaneRotation<double>& rotation) { return std::atan2(rotation.sin, rotation.cos); }
inline PlaneRotation<double> rotation_of(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// The friction √μ of a surface for an engine that multiplies those of two bodies.
inline double friction_factor(const Surface& surface) { return std::sqrt(surface.friction); }

}  // namespace byhand::engines
