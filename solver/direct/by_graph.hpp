#pragma once

#include "solver/direct/direct.hpp"
#include "solver/direct/semismooth_newton.hpp"
#include "solver/rows/conjugate_sweeps.hpp"

namespace byhand {

template <class M>
struct ByGraphWork;

/// Chooses by the scene's graph: without loops (chains, trees, columns) a direct solve, else conjugate sweeps
/// until they converge. Loops of rows without bounds (linkages, meshes) are solved directly too if that costs no
/// more than the sweeps; where they repeat or nearly do, with a regularisation of 1e-7.
///
/// Where the sweeps stall, semismooth Newton goes on, and stays until the rows are laid out anew, if a
/// factorisation costs no more than an eighth of all the sweeps, as in stacks. Where masses that touch differ by
/// more than `unlike`, a small residual of the sweeps is a large speed of the light body: there it begins at once,
/// with five times as many rounds, if a factorisation costs no more than half of the sweeps, and else there are
/// ten times as many sweeps.
struct ByGraph {
  Direct loopless = {};
  ConjugateSweeps loops = {};
  SemismoothNewton stalled = {};
  double unlike = 50;  // ratio of masses >= 1

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
  require_valid(choice.stalled);
  require(choice.unlike >= 1, "ratio of unlike masses", choice.unlike, "at least 1");
}

}  // namespace byhand
