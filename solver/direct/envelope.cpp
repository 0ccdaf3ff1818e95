#include "solver/direct/envelope.hpp"

#include <algorithm>

#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

/// Inverts by Gauss and Jordan in the order of the rows: a search for pivots would compare speeds with turning
/// rates, and so depend on the units.
template <class Square>
void invert_in_place(Square& A) {
  constexpr int n = Square::RowsAtCompileTime;
  for (int p = 0; p < n; ++p) {
    const double inverse = 1 / A(p, p);
    A(p, p) = 1;
    for (int j = 0; j < n; ++j) A(p, j) *= inverse;
    for (int i = 0; i < n; ++i) {
      if (i == p) continue;
      const double share = A(i, p);
      A(i, p) = 0;
      for (int j = 0; j < n; ++j) A(i, j) -= share * A(p, j);
    }
  }
}

}  // namespace

template <class M>
void Envelope<M>::plan(const System<M>& system, int bodies) {
  layout_ = system.layout;
  std::vector<std::vector<int>> near(bodies);  // by body, those that share rows with it, and itself
  for_each_block(system, [&](const BlockHeader& block, const Run&) {
    if (block.moves1) near[block.body1].push_back(block.body1);
    if (block.moves2) near[block.body2].push_back(block.body2);
    if (!block.moves1 || !block.moves2) return;
    near[block.body1].push_back(block.body2);
    near[block.body2].push_back(block.body1);
  });
  for (auto& bodies_near : near) {
    std::sort(bodies_near.begin(), bodies_near.end());
    bodies_near.erase(std::unique(bodies_near.begin(), bodies_near.end()), bodies_near.end());
  }
  order(near);
  const int places = static_cast<int>(body_.size());
  first_.assign(places, 0);
  start_.assign(places + 1, 0);
  multiplications_ = 0;
  for (int i = 0; i < places; ++i) {
    first_[i] = i;
    for (const int body : near[body_[i]]) first_[i] = std::min(first_[i], place_[body]);
    start_[i + 1] = start_[i] + i - first_[i];
    for (int j = first_[i]; j <= i; ++j) multiplications_ += 2 * (j - std::max(first_[i], first_[j]) + 1);
  }
  multiplications_ *= M::dof * M::dof * M::dof;
  lower_.resize(start_[places]);
  upper_.resize(start_[places]);
  diagonal_.resize(places);
  unknowns_.resize(places);
}

/// Cuthill and McKee: a breadth-first search over each island, from a body far from all others, where bodies with
/// few neighbours come first. Reversed, this has the smaller envelope.
template <class M>
void Envelope<M>::order(const std::vector<std::vector<int>>& near) {
  body_.clear();
  std::vector<int> island, visited(near.size(), 0);
  int searches = 0;
  const auto search = [&](int from) {
    visited[from] = ++searches;
    island = {from};
    for (std::size_t i = 0; i < island.size(); ++i) {
      const auto known = static_cast<std::ptrdiff_t>(island.size());
      for (const int body : near[island[i]])
        if (visited[body] != searches) visited[body] = searches, island.push_back(body);
      std::stable_sort(island.begin() + known, island.end(),
                       [&](int a, int b) { return near[a].size() < near[b].size(); });
    }
    return island.back();
  };
  place_.assign(near.size(), -1);
  for (std::size_t body = 0; body < near.size(); ++body) {
    if (near[body].empty() || place_[body] >= 0) continue;
    search(search(search(static_cast<int>(body))));
    for (auto next = island.rbegin(); next != island.rend(); ++next) {
      place_[*next] = static_cast<int>(body_.size());
      body_.push_back(*next);
    }
  }
}

template <class M>
void Envelope<M>::reset() {
  std::fill(lower_.begin(), lower_.end(), Square::Zero());
  std::fill(upper_.begin(), upper_.end(), Square::Zero());
  std::fill(diagonal_.begin(), diagonal_.end(), Square::Identity());
  std::fill(unknowns_.begin(), unknowns_.end(), Velocity<M>::Zero());
}

template <class M>
auto Envelope<M>::block(int body1, int body2) -> Square& {
  const int i = place_[body1], j = place_[body2];
  return i == j ? diagonal_[i] : i > j ? lower(i, j) : upper(i, j);
}

template <class M>
void Envelope<M>::factor() {
  for (int i = 0; i < static_cast<int>(body_.size()); ++i) {
    for (int j = first_[i]; j < i; ++j) {
      for (int k = std::max(first_[i], first_[j]); k < j; ++k) {
        upper(j, i) -= lower(j, k).lazyProduct(upper(k, i));
        lower(i, j) -= lower(i, k).lazyProduct(upper(k, j));
      }
      lower(i, j) = (lower(i, j).lazyProduct(diagonal_[j])).eval();
    }
    for (int k = first_[i]; k < i; ++k) diagonal_[i] -= lower(i, k).lazyProduct(upper(k, i));
    invert_in_place(diagonal_[i]);
  }
}

template <class M>
void Envelope<M>::solve() {
  const int places = static_cast<int>(body_.size());
  for (int i = 0; i < places; ++i)
    for (int k = first_[i]; k < i; ++k) unknowns_[i] -= lower(i, k).lazyProduct(unknowns_[k]);
  for (int i = places - 1; i >= 0; --i) {
    unknowns_[i] = diagonal_[i].lazyProduct(unknowns_[i]).eval();
    for (int k = first_[i]; k < i; ++k) unknowns_[k] -= upper(k, i).lazyProduct(unknowns_[i]);
  }
}

#define BYHAND_INSTANTIATE(M) template class Envelope<M>
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
