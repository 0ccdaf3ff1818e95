#pragma once

// What sources instantiate for each model: `instantiate` is a macro of the model's name. The build compiles each
// source once a model, into an archive of the model's own, with BYHAND_ONE_MODEL and the macro of that model
// defined.

#ifndef BYHAND_ONE_MODEL
#define BYHAND_PLANE_PARTICLE
#define BYHAND_PLANE_BODY
#define BYHAND_SPACE_PARTICLE
#define BYHAND_SPACE_BODY
#endif

#ifdef BYHAND_PLANE_PARTICLE
#define BYHAND_FOR_PLANE_PARTICLE(instantiate) instantiate(PlaneParticle);
#else
#define BYHAND_FOR_PLANE_PARTICLE(instantiate)
#endif
#ifdef BYHAND_PLANE_BODY
#define BYHAND_FOR_PLANE_BODY(instantiate) instantiate(PlaneBody);
#else
#define BYHAND_FOR_PLANE_BODY(instantiate)
#endif
#ifdef BYHAND_SPACE_PARTICLE
#define BYHAND_FOR_SPACE_PARTICLE(instantiate) instantiate(SpaceParticle);
#else
#define BYHAND_FOR_SPACE_PARTICLE(instantiate)
#endif
#ifdef BYHAND_SPACE_BODY
#define BYHAND_FOR_SPACE_BODY(instantiate) instantiate(SpaceBody);
#else
#define BYHAND_FOR_SPACE_BODY(instantiate)
#endif

#define BYHAND_FOR_EACH_TURNING_MODEL(instantiate) \
  BYHAND_FOR_PLANE_BODY(instantiate) BYHAND_FOR_SPACE_BODY(instantiate) static_assert(true)
#define BYHAND_FOR_EACH_MODEL(instantiate) \
  BYHAND_FOR_PLANE_PARTICLE(instantiate)   \
  BYHAND_FOR_SPACE_PARTICLE(instantiate) BYHAND_FOR_EACH_TURNING_MODEL(instantiate)

/// Defines what BYHAND_DECLARE_COPIES declares.
#define BYHAND_DEFINE_COPIES(T)                  \
  template <class M>                             \
  T<M>::T() = default;                           \
  template <class M>                             \
  T<M>::T(const T&) = default;                   \
  template <class M>                             \
  T<M>::T(T&&) noexcept = default;               \
  template <class M>                             \
  T<M>& T<M>::operator=(const T&) = default;     \
  template <class M>                             \
  T<M>& T<M>::operator=(T&&) noexcept = default; \
  template <class M>                             \
  T<M>::~T() = default;
