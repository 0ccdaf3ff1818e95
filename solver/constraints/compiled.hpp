#pragma once

#include "solver/constraints/hinge.hpp"
#include "solver/constraints/slider.hpp"

// Functions with sums that make masses, rotations and built-in kinds are compiled once, in the library. A program
// that includes byhand.hpp calls them there, and so begins with the same bits whatever it is compiled with.
namespace byhand {

#define BYHAND_COMPILED_OF_MODEL(prefix, M) \
  prefix template Anchors<M> between(const Bodies<M>&, int, const Linear<M>&, int, const Linear<M>&)
#define BYHAND_COMPILED_OF_BODIES(prefix, M)                                                 \
  BYHAND_COMPILED_OF_MODEL(prefix, M);                                                       \
  prefix template InverseMass<M> box(double, const Linear<M>&);                              \
  prefix template Packed<double, M::linear, M::linear - 1> tangents_of<M>(const Linear<M>&); \
  prefix template Linear<M> axis_in(const Bodies<M>&, int, const Linear<M>&);                \
  prefix template Orientation<M> orientation(const Bodies<M>&, int, int)
#define BYHAND_COMPILED(prefix)                                                                   \
  BYHAND_COMPILED_OF_MODEL(prefix, PlaneParticle);                                                \
  BYHAND_COMPILED_OF_MODEL(prefix, SpaceParticle);                                                \
  BYHAND_COMPILED_OF_BODIES(prefix, PlaneBody);                                                   \
  BYHAND_COMPILED_OF_BODIES(prefix, SpaceBody);                                                   \
  prefix template PlaneRotation<double> plane_rotation(const double&);                            \
  prefix template PlaneRotation<double> rotated_by(const PlaneRotation<double>&, const double&);  \
  prefix template Quaternion<double> space_rotation(const Packed<double, 3>&);                    \
  prefix template Quaternion<double> rotated_by(const Eigen::QuaternionBase<Quaternion<double>>&, \
                                                const Packed<double, 3>&)

BYHAND_COMPILED(extern);

}  // namespace byhand
