#include "solver/constraints/distance.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/rope.hpp"
#include "solver/constraints/spring.hpp"

namespace byhand {

#define BYHAND_STORE(M, Kind) template std::unique_ptr<ConstraintStore<M>> make_store<M, Kind<M>>()
#define BYHAND_INSTANTIATE(M)          \
  BYHAND_STORE(M, Distance);           \
  BYHAND_STORE(M, NormalisedDistance); \
  BYHAND_STORE(M, Rope);               \
  BYHAND_STORE(M, Spring)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);

}  // namespace byhand
