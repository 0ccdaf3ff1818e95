#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/desk/expression.hpp"

namespace byhand::desk {

/// What a name means: a quantity of a body, a constant, or an expression.
struct Symbol {
  enum class Is { centre, velocity, spin, angle, orientation, fixed, turning, defined };

  std::string name = {};
  Is is = Is::fixed;
  int body = -1;  // 0 or 1; -1: the world
  Shape shape = {};
  Unit unit = {};
  bool unit_length = false;
  bool arm = false;            // r of a body, from its centre to its anchor
  int axis = -1;               // of the columns of the frame that unit vectors of the article share; -1: free
  Expression definition = {};  // of Is::defined
  int id = 0;
};

/// Where bodies live and whether they turn.
struct World {
  int dimension = 2;
  bool turning = true;  // false: particles

  int angular() const { return !turning ? 0 : dimension == 2 ? 1 : 3; }
  int dof() const { return dimension + angular(); }
};

/// The article's names (x1, r1, p1, d, n, t, u, v1, ω1, R1, θ1, L …) and those that a sheet declares.
class Vocabulary {
 public:
  explicit Vocabulary(World world);
  Vocabulary(const Vocabulary&) = delete;
  Vocabulary& operator=(const Vocabulary&) = delete;

  const World& world() const { return world_; }
  /// The symbol of a name as Greek letters and digits, "ω1"; nullptr if there is none.
  const Symbol* find(std::string_view name) const;
  const Symbol& at(std::string_view name) const;
  const std::deque<Symbol>& all() const { return all_; }

  /// "k: number", "w1, w2: points of the world", "a: unit vector on body 1", "q: length", "s [m/s]". Throws
  /// Complaint.
  void declare(std::string_view line);
  /// Adds a name for an expression; d and names of one's own may be defined, and own names again.
  void define(const std::string& name, const Expression& definition, Span where);
  /// Sentence for a name that is not known, with the nearest that is.
  std::string unknown(std::string_view name) const;

 private:
  Symbol& add(Symbol symbol);

  World world_;
  std::deque<Symbol> all_;
};

/// Whether names of body 1 and 2 belong together: the name with the other digit.
const Symbol* counterpart(const Vocabulary& words, const Symbol& symbol);

}  // namespace byhand::desk
