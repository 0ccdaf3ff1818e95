#pragma once

#include "lessons/06_joints/setting.hpp"

// Parts of the lesson's machines, in the world of the canvas's camera.
namespace byhand::joints {

/// The two ends of a bar of `length` [m] that lies along its body's x axis.
struct Bar {
  renderer::Point from, to;
};
Bar bar_of(const Pose<PlaneBody>& pose, double length);

void draw_bar(renderer::Canvas& canvas, const Bar& bar, double thickness = 16,
              const renderer::Look& look = renderer::body_look);

/// Where two bodies are welded.
void draw_weld(renderer::Canvas& canvas, const renderer::Point& at);

/// What holds a body to an axis of that angle [rad].
void draw_sleeve(renderer::Canvas& canvas, const renderer::Point& at, double angle);

/// A straight guide through a point, `reach` [m] to both sides.
void draw_rail(renderer::Canvas& canvas, const renderer::Point& at, double angle, double reach);

/// A stop below a bar that points in that direction [rad] from its hinge, `length` [m] long.
void draw_stop(renderer::Canvas& canvas, const renderer::Point& hinge, double angle, double length);

/// An arrow round a hinge from one angle to another [rad], of `radius` [m].
void draw_turn(renderer::Canvas& canvas, const renderer::Point& hinge, double from, double to, double radius,
               const renderer::Stroke& stroke);

}  // namespace byhand::joints
