#include "solver/shared_scenes.hpp"

#include "solver/measure.hpp"

namespace byhand {

#define BYHAND_SHARED_SCENE(M, ...)                                                         \
  template Graph Scene<M, __VA_ARGS__>::graph() const;                                      \
  template void Scene<M, __VA_ARGS__>::lay_out(const std::vector<int>&, System<M>&) const;  \
  template void Scene<M, __VA_ARGS__>::write_rows(System<M>&, double) const;                \
  template void advance(Scene<M, __VA_ARGS__>&, const VelocityStepping&, double, Work<M>&); \
  template PositionError position_error(const Scene<M, __VA_ARGS__>&);                      \
  template double potential_energy(const Scene<M, __VA_ARGS__>&);                           \
  template double energy(const Scene<M, __VA_ARGS__>&)
BYHAND_FOR_EACH_SHARED_SCENE(BYHAND_SHARED_SCENE);
#undef BYHAND_SHARED_SCENE

}  // namespace byhand
