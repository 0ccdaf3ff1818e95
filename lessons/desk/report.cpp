#include "lessons/desk/report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "lessons/desk/print.hpp"

namespace byhand::desk {
namespace {

using Is = Symbol::Is;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// The constraints of the course, in the desk's own words; u stands for any unit vector on body 1.
struct Ours {
  const char *name, *file, *C, *J;
};
constexpr Ours of_the_course[] = {
    {"rod", "solver/constraints/distance.hpp", "(d . d - L^2)/2", "[−d, −r1 × d, d, r2 × d] (14)"},
    {"normalised rod", "solver/constraints/normalised_distance.hpp", "|d| - L",
     "[−n, −r1 × n, n, r2 × n] with n = d/|d|"},
    {"pin", "solver/constraints/pin.hpp", "d",
     "[−E, [r1]×, E, −[r2]×], and in the plane [−E, −perp(r1), E, perp(r2)]"},
    {"contact, frozen normal", "solver/constraints/contact.hpp", "d . n", "[−n, −r1 × n, n, r2 × n] (15)"},
    {"slide along an axis of body 1", "solver/constraints/freedom.hpp", "u . d", "[−u, −(r1 + d) × u, u, r2 × u]"},
    {"turn", "solver/constraints/freedom.hpp", "θ2 - θ1", "[0, −1, 0, 1]"},
};

/// A formula with every use of a name replaced.
std::string with_name(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string ours(const Vocabulary& words, const Expression& C) {
  if (!C) return "";
  const Judge judge(words);
  const Samples mine = judge.samples(C);
  for (const Ours& one : of_the_course) {
    std::vector<std::string> names = {"u"};
    if (std::string(one.C).find("u .") != std::string::npos)
      for (const Symbol& s : words.all())
        if (s.is == Is::turning && s.unit_length && s.body == 0) names.push_back(s.name);
    for (const std::string& name : names) try {
        const Expression theirs = parse_expression(with_name(one.C, "u", name), words);
        if (!(theirs->shape == C->shape)) continue;
        const auto factor = judge.factor(mine, judge.samples(theirs));
        if (!factor || *factor == 0) continue;
        const bool same_scale = std::fabs(*factor - 1) < 1e-12;
        return std::string("The course has it as the ") + one.name + " (" + one.file + ")" +
               (same_scale ? "" : ", with another factor") + ": C = " + characters(theirs) + ", J = " + one.J +
               ".";
      } catch (const Complaint&) {  // a name that this world has not
      }
  }
  return "";
}

/// Parts of an expression, definitions entered.
void visit_open(const Expression& e, const std::function<void(const Expression&)>& visitor) {
  visit(e, [&](const Expression& part) {
    visitor(part);
    if (part->symbol && part->symbol->definition) visit_open(part->symbol->definition, visitor);
  });
}

/// Moves the centres until a vector of positions vanishes; false if that does not lead there.
bool move_to_zero(const Vocabulary& words, State<double>& state, const Expression& e) {
  const std::size_t n = static_cast<std::size_t>(words.world().dimension),
                    dof = static_cast<std::size_t>(words.world().dof());
  for (int step = 0; step < 30; ++step) {
    const auto value = evaluate(*e, environment<Tracked>(words, state));
    double size = 0;
    for (int i = 0; i < e->shape.size(); ++i) size = std::max(size, std::fabs(value[i].at));
    if (!std::isfinite(size)) return false;
    if (size < 1e-13) return true;
    // A step along the gradient of each number in turn (Kaczmarz).
    const auto J = jacobian_by_duals(words, state, e);
    for (std::size_t row = 0; row < J.size(); ++row) {
      double norm2 = 0;
      for (std::size_t k = 0; k < n; ++k) norm2 += J[row][k] * J[row][k] + J[row][dof + k] * J[row][dof + k];
      if (!(norm2 > 1e-12)) return false;
      const double now = evaluate(*e, environment<Tracked>(words, state))[static_cast<int>(row)].at;
      for (std::size_t k = 0; k < n; ++k)
        for (const char* x : {"x1", "x2"})
          state[static_cast<std::size_t>(words.at(x).id)][static_cast<int>(k)] -=
              now / norm2 * J[row][(x[1] == '1' ? 0 : dof) + k];
    }
  }
  return false;
}

/// Turns both bodies until the J of a C vanishes; false if that does not lead there.
bool turn_to_zero(const Vocabulary& words, State<double>& state, const Expression& C) {
  constexpr double by = 1e-6;
  const auto J_at = [&](const State<double>& at) {
    std::vector<double> all;
    for (const auto& row : jacobian_by_duals(words, at, C)) all.insert(all.end(), row.begin(), row.end());
    return all;
  };
  const int axes = words.world().dimension == 2 ? 1 : 3;
  double before_ten = infinite;
  for (int step = 0; step < 60; ++step) {
    std::vector<double> J = J_at(state);
    double size = 0;
    for (const double x : J) size = std::isfinite(x) ? std::max(size, std::fabs(x)) : infinite;
    if (size < 1e-10) return true;
    if (size == infinite || (step % 10 == 5 && size > 0.1 * before_ten)) return false;
    if (step % 10 == 5 || step == 0) before_ten = size;
    // A step along the gradient of each number of J in turn (Kaczmarz), by central differences.
    for (std::size_t k = 0; k < J.size(); ++k) {
      if (std::fabs(J[k]) < 1e-12) continue;
      double norm2 = 0;
      std::vector<double> gradient;
      for (int i = 0; i < 2 * axes; ++i) {
        State<double> before = state, after = state;
        turn(words, before, 1 + i / axes, i % axes, -by);
        turn(words, after, 1 + i / axes, i % axes, by);
        gradient.push_back((J_at(after)[k] - J_at(before)[k]) / (2 * by));
        norm2 += gradient.back() * gradient.back();
      }
      if (!(norm2 > 1e-12)) continue;
      const double now = J_at(state)[k];
      for (int i = 0; i < 2 * axes; ++i)
        turn(words, state, 1 + i / axes, i % axes, -now / norm2 * gradient[static_cast<std::size_t>(i)]);
    }
  }
  return false;
}

/// Whether J vanishes at some angles, and whether C does there too, which leaves nothing to push with.
std::string singular_angles(const Vocabulary& words, const Expression& C) {
  Random random(7);
  int found = 0;
  for (int i = 0; i < 5; ++i) {
    State<double> state = random_state(words, random);
    if (!turn_to_zero(words, state, C)) continue;
    ++found;
    const auto value = evaluate(*C, environment<Tracked>(words, state));
    double size = 0;
    for (int k = 0; k < C->shape.size(); ++k) size = std::max(size, std::fabs(value[k].at));
    if (size < 1e-9) return "J vanishes at angles at which C = 0: no impulse can act there, so choose another C.";
  }
  return found ? "J vanishes at some angles; there C is not 0." : "";
}

std::string join(const std::vector<std::string>& all, const char* between) {
  std::string text;
  for (const std::string& one : all) text += (text.empty() ? "" : between) + one;
  return text;
}

}  // namespace

std::vector<std::string> singularities(const Vocabulary& words, const Expression& C) {
  std::vector<std::string> sentences, nowhere;
  std::set<std::string> seen;
  std::vector<Expression> vectors;
  const auto moves = [&](const Expression& e) { return !is_number(derivative(e, words), 0); };
  visit_open(C, [&](const Expression& e) {
    const auto say = [&](const std::string& where) {
      if (seen.insert(where).second) nowhere.push_back(where);
    };
    if (e->op == Op::length && moves(e->of[0])) say(characters(e->of[0]) + " = 0");
    if (e->op == Op::root && moves(e->of[0])) say(characters(e->of[0]) + " = 0");
    if (e->op == Op::divide && moves(e->of[1]) && e->of[1]->op != Op::length) say(characters(e->of[1]) + " = 0");
    if (e->op == Op::arctangent) say(characters(e->of[0]) + " = " + characters(e->of[1]) + " = 0");
    if (e->op == Op::arctangent && seen.insert("atan2").second)
      sentences.push_back(
          "atan2 jumps by 2π where its second argument is negative and the first changes its sign: keep the angle "
          "within (−π, π).");
    if (e->shape.vector() && e->unit.m == 1 && moves(e)) vectors.push_back(e);
  });
  // |a|² is differentiable everywhere.
  visit_open(C, [&](const Expression& e) {
    if (e->op == Op::power && e->of[0]->op == Op::length && e->number == 2)
      std::erase(nowhere, characters(e->of[0]->of[0]) + " = 0");
  });
  if (!nowhere.empty()) sentences.push_back("C is not differentiable where " + join(nowhere, " or ") + ".");
  std::set<std::string> vanishing;
  for (const Expression& e : vectors) {
    Random random(5);
    bool all = true;
    double left = 0;
    for (int i = 0; i < 3 && all; ++i) {
      State<double> state = random_state(words, random);
      all = move_to_zero(words, state, e);
      if (!all) break;
      double largest = 0;
      for (const auto& row : jacobian_by_duals(words, state, C))
        for (const double x : row) largest = std::isfinite(x) ? std::max(largest, std::fabs(x)) : 1;
      all = largest < 1e-9;
      const auto value = evaluate(*C, environment<Tracked>(words, state));
      for (int k = 0; k < C->shape.size(); ++k) left = std::max(left, std::fabs(value[k].at));
    }
    const std::string name = characters(e);
    if (all && vanishing.empty() && vanishing.insert(name).second)
      sentences.push_back("J vanishes where " + name + " = 0" +
                          (left > 1e-9
                               ? "; there C is not 0."
                               : ", which is C = 0 itself: no impulse can act there, so choose another C."));
  }
  if (vanishing.empty() && words.world().turning)
    if (const std::string angles = singular_angles(words, C); !angles.empty()) sentences.push_back(angles);
  return sentences;
}

Report report(const Sheet& sheet) {
  const Vocabulary& words = sheet.words();
  Report result;
  Random random(17);
  const State<double> state = random_state(words, random);
  std::vector<std::vector<double>> all;
  for (const auto& [name, row] : sheet.rows()) {
    if (row.J.empty()) continue;
    Report::OfRow of{name, {}, ours(words, row.C), {}};
    const Shape shape = row.C ? row.C->shape : row.rate->shape;
    const Unit rate_unit = row.C ? row.C->unit * per_second : row.rate->unit;
    const auto J = coefficients(words, state, rate_by(words, row.J, shape, {}));
    std::size_t column = 0;
    const auto which = velocities(words);
    for (std::size_t i = 0; i < which.size(); ++i) {
      const std::size_t wide = static_cast<std::size_t>(which[i]->shape.size());
      std::vector<std::vector<double>> part;
      for (const auto& line : J)
        part.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(column),
                          line.begin() + static_cast<std::ptrdiff_t>(column + wide));
      column += wide;
      of.parts.push_back({part_name(words, i), characters(row.J[i]), latex(row.J[i]),
                          text_of(rate_unit / which[i]->unit), rank(part)});
    }
    all.insert(all.end(), J.begin(), J.end());
    if (row.C) of.remarks = singularities(words, row.C);
    if (!row.C)
      of.remarks.push_back("There is no C: nothing drifts, and nothing tells where the bodies have been.");
    if (row.inequality)
      of.remarks.push_back("C ≥ 0: the accumulated λ stays ≥ 0, so that it pushes and never pulls.");
    result.rows.push_back(std::move(of));
  }
  result.count = static_cast<int>(all.size());
  result.rank = rank(all);
  return result;
}

std::string text_of(const Report& report) {
  std::string text;
  for (const auto& row : report.rows) {
    text += "J" + row.name + " has these parts:\n";
    for (const Part& part : row.parts)
      text += "  " + part.name + " = " + part.characters + "   [" + part.unit + "], rank " +
              std::to_string(part.rank) + "\n";
    if (!row.ours.empty()) text += row.ours + "\n";
    for (const std::string& remark : row.remarks) text += remark + "\n";
  }
  if (!report.rows.empty())
    text += std::to_string(report.count) + (report.count == 1 ? " row" : " rows") + " of rank " +
            std::to_string(report.rank) +
            (report.rank < report.count ? ": some row repeats what others say.\n"
                                        : ": one degree of freedom fewer for each row.\n");
  return text;
}

namespace {

std::string cpp_number(const Symbol& s) { return cpp(symbol(s)); }

/// Symbols in expressions, definitions entered, in the order of the vocabulary.
std::vector<const Symbol*> used(const Vocabulary& words, const std::vector<Expression>& all) {
  std::set<const Symbol*> found;
  for (const Expression& e : all)
    visit_open(e, [&](const Expression& part) {
      if (part->symbol) found.insert(part->symbol);
    });
  std::vector<const Symbol*> sorted;
  for (const Symbol& s : words.all())
    if (found.count(&s)) sorted.push_back(&s);
  return sorted;
}

/// The lines that give the used symbols their values at two poses.
std::string locals(const std::vector<const Symbol*>& symbols) {
  std::string text;
  for (const Symbol* s : symbols) {
    const std::string name = cpp_number(*s), pose = "pose" + std::to_string(s->body + 1);
    const auto line = [&](const std::string& type, const std::string& value) {
      text += "    const " + type + " " + name + " = " + value + ";\n";
    };
    switch (s->is) {
      case Is::centre: line("Vector<T>", pose + ".position"); break;
      case Is::angle: line("T", "principal_angle<T>(" + pose + ".rotation)"); break;
      case Is::orientation: line("Matrix<T>", "matrix_of<T>(" + pose + ".rotation)"); break;
      case Is::turning:
        line("Vector<T>",
             s->arm && s->name.size() == 2
                 ? "byhand::in_world<M, T>(" + pose + ", at.arms." + (s->body ? "second" : "first") + ")"
                 : "byhand::rotate(" + pose + ".rotation, Vector<T>(" + name + "_.template cast<T>()))");
        break;
      case Is::fixed:
        if (s->axis >= 3)
          line("Vector<T>", "Vector<T>::Unit(" + std::to_string(s->axis - 3) + ")");
        else
          line(s->shape.scalar() ? "T" : "Vector<T>",
               s->shape.scalar() ? "T(" + name + "_)" : name + "_.template cast<T>()");
        break;
      case Is::defined:
        line(s->shape.scalar() ? "T"
                               : "Eigen::Matrix<T, " + std::to_string(s->shape.rows) + ", " +
                                     std::to_string(s->shape.cols) + ">",
             cpp(s->definition));
        break;
      case Is::velocity:
      case Is::spin: break;
    }
  }
  return text;
}

}  // namespace

std::string cpp_struct(const Sheet& sheet) {
  if (!sheet.complete()) return "";
  const Vocabulary& words = sheet.words();
  const World& world = words.world();
  std::vector<Expression> C, J;
  std::vector<int> heights;
  for (const auto& [name, row] : sheet.rows()) {
    if (row.C) C.push_back(row.C);
    heights.push_back((row.C ? row.C : row.rate)->shape.rows);
    J.insert(J.end(), row.J.begin(), row.J.end());
  }
  // Rows with a C come first in the solver; the desk does not order them.
  if (!C.empty() && C.size() < heights.size()) return "";
  const int rows = std::accumulate(heights.begin(), heights.end(), 0);
  std::vector<Expression> both = C;
  both.insert(both.end(), J.begin(), J.end());
  const bool inequality =
      std::any_of(sheet.rows().begin(), sheet.rows().end(), [](const auto& row) { return row.second.inequality; });
  const std::string model =
      std::string("byhand::") + (world.dimension == 2 ? "Plane" : "Space") + (world.turning ? "Body" : "Particle");
  std::string members, value, jacobian;
  for (const Symbol* s : used(words, both)) {
    if (s->is == Is::fixed && s->axis < 3)
      members += "  " +
                 (s->shape.scalar() ? "double " + cpp_number(*s) + "_ = 1;"
                                    : "byhand::Linear<M> " + cpp_number(*s) + "_ = byhand::Linear<M>::Unit(0);") +
                 "  // [" + text_of(s->unit) + "]" + (s->shape.vector() ? ", of the world" : "") + "\n";
    if (s->is == Is::turning && !s->arm)
      members += "  byhand::Linear<M> " + cpp_number(*s) + "_ = byhand::Linear<M>::Unit(0);  // [" +
                 text_of(s->unit) + "], in the frame of body " + std::to_string(s->body + 1) + "\n";
  }
  int at = 0;
  for (const Expression& one : C) {
    value += one->shape.scalar() ? "    C[" + std::to_string(at) + "] = " + cpp(one) + ";\n"
                                 : "    C.template segment<" + std::to_string(one->shape.rows) + ">(" +
                                       std::to_string(at) + ") = " + cpp(one) + ";\n";
    at += one->shape.rows;
  }
  at = 0;
  const auto which = velocities(words);
  for (std::size_t c = 0; c < heights.size(); ++c) {
    const int K = heights[c];
    int column = 0;
    for (std::size_t i = 0; i < which.size(); ++i) {
      const Expression& part = J[c * which.size() + i];
      const int wide = which[i]->shape.size();
      const std::string to = "    J.matrix.block<" + std::to_string(K) + ", " + std::to_string(wide) + ">(" +
                             std::to_string(at) + ", " + std::to_string(column) + ")";
      if (is_number(part, 0))
        jacobian += to + ".setZero();\n";
      else if (part->shape.scalar())
        jacobian += to + ".setConstant(" + cpp(part) + ");\n";
      else
        jacobian += to + " = " + cpp(part) + (K == 1 && wide > 1 ? ".transpose()" : "") + ";\n";
      column += wide;
    }
    at += K;
  }
  const std::string n = std::to_string(world.dimension);
  std::string text = "// Derived at the desk:\n";
  for (const auto& [name, row] : sheet.rows()) {
    text += row.C ? "//   C" + name + " = " + characters(row.C) + (row.inequality ? " ≥ 0" : "") + "   [" +
                        text_of(row.C->unit) + "]\n"
                  : "//   dC" + name + " = " + characters(row.rate) + "   [" + text_of(row.rate->unit) +
                        "], with no C\n";
    text += "//   J" + name + " = [";
    for (std::size_t i = 0; i < row.J.size(); ++i) text += (i ? ", " : "") + characters(row.J[i]);
    text += "]\n";
  }
  text += "struct Derived {\n  using M = " + model +
          ";\n  template <class T>\n  using Vector = Eigen::Matrix<T, " + n +
          ", 1>;\n  template <class T>\n  using Matrix = Eigen::Matrix<T, " + n + ", " + n +
          ">;\n  static constexpr int rows = " + std::to_string(rows) + ";\n";
  if (C.empty()) text += "  static constexpr int position_rows = 0;  // nothing drifts\n";
  if (inequality) text += "  static constexpr byhand::Bound bound = byhand::Bound::interval;  // λ >= 0\n";
  text += "\n  byhand::Anchors<M> at;\n" + members + "\n";
  const auto function = [&](const std::string& head, const std::string& pose, const std::vector<Expression>& uses,
                            const std::string& body) {
    const std::string parameter = "[[maybe_unused]] const byhand::Pose<" + pose + ">& pose";
    text += head + parameter + "1,\n" + std::string(head.size(), ' ') + parameter +
            "2) const {\n    using std::abs, std::atan2, std::cos, std::sin, std::sqrt;\n" +
            (pose == "M" ? "    using T = double;\n" : "") + locals(used(words, uses)) + body + "  }\n";
  };
  text += "  template <class T>\n";
  function("  byhand::Rows<rows, T> value(", "M, T", C,
           "    byhand::Rows<rows, T> C;\n" + (C.empty() ? "    C.setZero();\n" : value) + "    return C;\n");
  text += "\n";
  function("  byhand::Jacobian<M, rows> jacobian(", "M", J,
           "    byhand::Jacobian<M, rows> J;\n" + jacobian + "    return J;\n");
  // What the formulas call that Eigen does not have under one name.
  const auto calls = [&](const std::string& name) { return text.find(name) != std::string::npos; };
  std::string helpers;
  if (calls("turned("))
    helpers +=
        "\n  template <class V>\n  static V turned(const V& a) {\n    V result;\n    result.row(0) = -a.row(1);\n "
        "   result.row(1) = a.row(0);\n    return result;\n  }\n";
  if (calls("skew("))
    helpers +=
        "\n  template <class V>\n  static Matrix<typename V::Scalar> skew(const V& a) {\n    using S = typename "
        "V::Scalar;\n    Matrix<S> m;\n    m << S(0), -a[2], a[1], a[2], S(0), -a[0], -a[1], a[0], S(0);\n    "
        "return m;\n  }\n";
  if (calls("matrix_of<"))
    helpers += world.dimension == 2
                   ? "\n  template <class T>\n  static Matrix<T> matrix_of(const byhand::Rotation<M, T>& r) {\n   "
                     " Matrix<T> m;\n    m << r.cos, -r.sin, r.sin, r.cos;\n    return m;\n  }\n"
                   : "\n  template <class T>\n  static Matrix<T> matrix_of(const byhand::Rotation<M, T>& r) {\n   "
                     " return r.toRotationMatrix();\n  }\n";
  return with_name(text, "principal_angle", "byhand::principal_angle") + helpers + "};\n";
}

}  // namespace byhand::desk
