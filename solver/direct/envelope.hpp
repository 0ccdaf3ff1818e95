#pragma once

#include <cstdint>
#include <vector>

#include "solver/system.hpp"

namespace byhand {

/// A square matrix of one dof × dof block for every two moving bodies that share rows, factored as LU. The bodies
/// are ordered so that those that share rows are near each other (reverse Cuthill–McKee), and the factor fills
/// only the envelope: from the first block of each row, and of each column, to the diagonal. A stack of n bodies
/// takes O(n). There is no search for pivots.
template <class M>
class Envelope {
 public:
  using Square = Packed<double, M::dof, M::dof>;

  /// Plans for the bodies of a system.
  void plan(const System<M>& system, int bodies);
  /// The layout of the system that was planned for.
  std::uint64_t layout() const { return layout_; }
  /// Of one factorisation.
  long long multiplications() const { return multiplications_; }

  /// The identity, with zero on the right-hand side.
  void reset();
  /// The block of two moving bodies that share rows, or of one.
  Square& block(int body1, int body2);
  /// The right-hand side of a moving body and, after `solve`, its unknown.
  Velocity<M>& unknown(int body) { return unknowns_[place_[body]]; }
  void factor();
  void solve();

 private:
  void order(const std::vector<std::vector<int>>& near);
  Square& lower(int i, int j) { return lower_[start_[i] + j - first_[i]]; }
  Square& upper(int j, int i) { return upper_[start_[i] + j - first_[i]]; }

  std::uint64_t layout_ = 0;
  long long multiplications_ = 0;
  std::vector<int> place_, body_;                 // of each body, -1 if it has no rows; the body at each place
  std::vector<int> first_, start_;                // by place: the first of its row, and where that is stored
  std::vector<Square> lower_, upper_, diagonal_;  // L, U, and the inverses of the pivots
  std::vector<Velocity<M>> unknowns_;             // by place
};

}  // namespace byhand
