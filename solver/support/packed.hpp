#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace byhand {

/// R × C numbers that lie in memory alike whatever Eigen's settings are, so that a program that is compiled with
/// others, for other processors, can be linked. What the library and a program both touch is made of these. Eigen
/// aligns an even count of numbers, each with its own settings, unless it is told not to; an odd count is the same
/// type as its own.
template <class T, int R, int C = 1, int storage = (R == 1 && C > 1 ? Eigen::RowMajor : Eigen::ColMajor)>
using Packed = Eigen::Matrix<T, R, C, R * C % 2 == 0 ? storage | Eigen::DontAlign : storage>;

/// The same of a rotation in space.
template <class T>
using Quaternion = Eigen::Quaternion<T, Eigen::DontAlign>;

}  // namespace byhand
