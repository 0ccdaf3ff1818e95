#pragma once

#include <Eigen/Core>

#include "lessons/06_joints/setting.hpp"

namespace byhand::joints {

/// What stands beside the numbers of a matrix.
struct GridLabels {
  std::vector<std::string> columns = {}, rows = {};
};

/// Draws a matrix as cells with their numbers in them, blue below zero and vermilion above; cells are of
/// `cell` points and the grid's upper left corner is at `at` (points on the page).
void draw_grid(renderer::Canvas& canvas, const Eigen::MatrixXd& matrix, const renderer::Point& at,
               const renderer::Point& cell, const GridLabels& labels = {});

}  // namespace byhand::joints
