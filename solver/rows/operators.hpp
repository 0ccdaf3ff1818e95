#pragma once

#include "solver/system.hpp"

// Operations on all rows of a system, with one number a row: what row solvers are written with.
namespace byhand {

/// (20) for a Block or PreparedBlock: V += M⁻¹Jᵀ `change` on the bodies that move.
template <class M, int K, class AnyBlock>
inline void apply(const AnyBlock& block, const Rows<K>& change, double* V) {
  constexpr int dof = M::dof;
  const double* W = block.W.matrix.data();
  const auto add = [&](double* v, int side) {
    double gain[dof];
    for (int i = 0; i < dof; ++i) {
      gain[i] = W[side + i] * change[0];
      for (int k = 1; k < K; ++k) gain[i] += W[2 * dof * k + side + i] * change[k];
    }
    for (int i = 0; i < dof; ++i) v[i] += gain[i];
  };
  if (block.moves1) add(V + dof * block.body1, 0);
  if (block.moves2) add(V + dof * block.body2, dof);
}

/// The velocities of all bodies as plain numbers, dof a body.
template <class M>
double* numbers(std::vector<Velocity<M>>& velocities) {
  static_assert(sizeof(Velocity<M>) == M::dof * sizeof(double));
  return velocities.empty() ? nullptr : velocities.front().data();
}

/// Calls f(block, its element in a PerBlock storage) for each block in solve order. The storage is resized to fit.
template <class M, class Storage, class F>
void for_each_block_with(const System<M>& system, Storage& storage, F&& f) {
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      std::get<type>(storage).resize(std::get<type>(system.blocks).size());
      const auto blocks = part<type>(system.blocks, run);
      const auto elements = part<type>(storage, run);
      for (int i = 0; i < run.count; ++i) f(blocks[i], elements[i]);
    });
}

/// V += M⁻¹Jᵀλ, or with -1 as the sign V -= M⁻¹Jᵀλ.
template <class M>
void apply_all(const System<M>& system, const std::vector<double>& lambda, std::vector<Velocity<M>>& velocities,
               double sign = 1);

/// `rates` = JV.
template <class M>
void rates_of(const System<M>& system, const std::vector<Velocity<M>>& velocities, std::vector<double>& rates);

/// `product` = (JM⁻¹Jᵀ + γ)x, by way of V = M⁻¹Jᵀx.
template <class M>
void multiply(const System<M>& system, const std::vector<double>& x, std::vector<Velocity<M>>& V,
              std::vector<double>& product);

/// `error` = JV + b + γλ.
template <class M>
void errors_of(const System<M>& system, const std::vector<Velocity<M>>& velocities,
               const std::vector<double>& lambda, std::vector<double>& error);

/// Clamps λ to its bounds, block by block in solve order.
template <class M>
void hold_within_bounds(const System<M>& system, std::vector<double>& lambda);

/// The largest |x|, NaN if any is.
inline double largest_of(const std::vector<double>& x) {
  double largest = 0;
  for (const double number : x) largest = larger(largest, std::abs(number));
  return largest;
}

}  // namespace byhand
