#pragma once

#include "solver/constraints/distance.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/methods/velocity_stepping.hpp"

// The scenes that most programs are made of are compiled once, in the library: a program that names one of them
// need not spend seconds on making it again.
#define BYHAND_FOR_EACH_SHARED_SCENE(F) \
  F(PlaneParticle, Distance);           \
  F(PlaneParticle, NormalisedDistance); \
  F(PlaneParticle, Pin);                \
  F(SpaceParticle, Distance);           \
  F(SpaceParticle, NormalisedDistance); \
  F(SpaceParticle, Pin);                \
  F(PlaneBody, Distance);               \
  F(PlaneBody, NormalisedDistance);     \
  F(PlaneBody, Pin);                    \
  F(PlaneBody, FaceContact);            \
  F(PlaneBody, Contact, Friction);      \
  F(SpaceBody, Distance);               \
  F(SpaceBody, NormalisedDistance);     \
  F(SpaceBody, Pin);                    \
  F(SpaceBody, Contact, Friction)

namespace byhand {

#define BYHAND_SHARED_SCENE(M, ...)                                                               \
  extern template Graph Scene<M, __VA_ARGS__>::graph() const;                                     \
  extern template void Scene<M, __VA_ARGS__>::lay_out(const std::vector<int>&, System<M>&) const; \
  extern template void Scene<M, __VA_ARGS__>::write_rows(System<M>&, double) const;               \
  extern template void advance(Scene<M, __VA_ARGS__>&, const VelocityStepping&, double, Work<M>&)
BYHAND_FOR_EACH_SHARED_SCENE(BYHAND_SHARED_SCENE);
#undef BYHAND_SHARED_SCENE

}  // namespace byhand
