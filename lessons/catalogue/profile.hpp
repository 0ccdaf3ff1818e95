#pragma once

#include <string>
#include <vector>

// Performance profiles: how often each method is how much dearer than the best. E. D. Dolan and J. J. Moré,
// "Benchmarking optimization software with performance profiles", Mathematical Programming 91, 2002.
namespace byhand {

/// What the methods cost at one task; infinite where one fails it.
struct Task {
  std::string name;
  std::vector<double> cost;  // by method
};

/// ρ(τ): the share of the tasks that a method does at no more than τ times the cost of the best method at that
/// task. Tasks that no method does count as failed by all.
class Profile {
 public:
  Profile(const std::vector<Task>& tasks, std::size_t method);
  double operator()(double tau) const;
  /// Where ρ rises, ascending.
  const std::vector<double>& ratios() const { return ratios_; }

 private:
  std::vector<double> ratios_;
  double tasks_;
};

}  // namespace byhand
