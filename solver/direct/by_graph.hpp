#pragma once

#include "solver/direct/direct.hpp"
#include "solver/rows/conjugate_sweeps.hpp"

namespace byhand {

template <class M>
struct ByGraphWork;

/// Chooses by the scene's graph: without loops (chains, trees, columns) a direct solve, else conjugate sweeps
/// until they converge. Loops of rows without bounds (linkages, meshes) are solved directly too if that costs no
/// more than the sweeps; where they repeat or nearly do, with a regularisation of 1e-7.
struct ByGraph {
  Direct loopless = {};
  ConjugateSweeps loops = {};

  template <class M>
  using Work = ByGraphWork<M>;
  template <class M>
  Layout layout(const ByGraphWork<M>& work) const;
  template <class M>
  std::vector<int> order(const Graph& graph, ByGraphWork<M>& work) const;
  template <class M>
  Solution solve(System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work, Begin begin = Begin::step) const;
};

inline void require_valid(const ByGraph& choice) {
  require_valid(choice.loopless);
  require_valid(choice.loops);
}

}  // namespace byhand
