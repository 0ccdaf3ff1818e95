#include "lessons/desk/scenes.hpp"

#include <algorithm>
#include <cstdio>

#include "lessons/desk/jet_functions.hpp"
#include "lessons/desk/report.hpp"
#include "lessons/terminal/braille.hpp"
#include "solver/byhand.hpp"

namespace byhand::desk {
namespace {

using Is = Symbol::Is;

/// What all constraints of a run share: the formulas, and the values of constants and of vectors in the bodies'
/// frames.
struct Formulas {
  const Vocabulary* words;
  std::vector<Expression> C;  // by row of the sheet; empty for a constraint on rates alone
  std::vector<std::vector<Expression>> J;
  State<double> constants;
};

/// The symbols' values at two poses; angles go on from `angles`.
template <class M, class T>
Environment<T> environment_at(const Formulas& formulas, const Pose<M, T>& pose1, const Pose<M, T>& pose2,
                              const std::array<double, 2>& angles) {
  const Vocabulary& words = *formulas.words;
  constexpr int n = M::linear;
  Environment<T> values(words.all().size());
  for (const Symbol& s : words.all()) {
    const auto id = static_cast<std::size_t>(s.id);
    const Pose<M, T>& pose = s.body == 1 ? pose2 : pose1;
    Value<T>& value = values[id] = Value<T>(s.shape);
    if (s.is == Is::centre) {
      for (int i = 0; i < n; ++i) value[i] = pose.position[i];
    } else if (s.is == Is::angle) {
      if constexpr (n == 2) {
        const double before = angles[static_cast<std::size_t>(s.body)];
        const T c(std::cos(before)), sine(std::sin(before));  // the turn since then is small
        using std::atan2;
        value[0] = T(before) + atan2(T(pose.rotation.sin * c - pose.rotation.cos * sine),
                                     T(pose.rotation.cos * c + pose.rotation.sin * sine));
      }
    } else if (s.is == Is::orientation || s.is == Is::turning) {
      const int columns = s.is == Is::orientation ? n : 1;
      for (int j = 0; j < columns; ++j) {
        Linear<M, T> axis =
            s.is == Is::orientation ? Linear<M, T>(Linear<M, T>::Unit(j)) : Linear<M, T>(Linear<M, T>::Zero());
        if (s.is == Is::turning)
          for (int i = 0; i < n; ++i) axis[i] = T(formulas.constants[id][i]);
        const Linear<M, T> turned = rotate(pose.rotation, axis);
        for (int i = 0; i < n; ++i) value(i, j) = turned[i];
      }
    } else if (s.is == Is::fixed) {
      for (int i = 0; i < s.shape.size(); ++i) value[i] = T(formulas.constants[id][i]);
    }
  }
  define(words, values);
  return values;
}

/// A typed constraint as a kind of the solver: K rows, with or without a C, held at 0 or kept above it.
template <class M, int K, bool Positions, Bound B>
struct Typed {
  static constexpr int rows = K, position_rows = Positions ? K : 0;
  static constexpr Bound bound = B;

  Anchors<M> at;  // the arms are among the formulas' constants
  const Formulas* formulas = nullptr;
  std::array<double, 2> angles = {};

  template <class T>
  Rows<K, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    Rows<K, T> C = Rows<K, T>::Constant(T(0));
    if (!Positions) return C;
    const auto values = environment_at<M, T>(*formulas, pose1, pose2, angles);
    int row = 0;
    for (const Expression& e : formulas->C) {
      const Value<T> value = evaluate(*e, values);
      for (int i = 0; i < e->shape.rows; ++i) C[row++] = value[i];
    }
    return C;
  }

  /// The parts as they were typed.
  Jacobian<M, K> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const auto values = environment_at<M, double>(*formulas, pose1, pose2, angles);
    Jacobian<M, K> J;
    J.matrix.setZero();
    const bool turning = formulas->words->world().turning;
    int row = 0;
    for (const auto& parts : formulas->J) {
      int high = 1;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        // Particles run as bodies that nothing turns.
        const int column = turning ? (i % 2 ? M::linear : 0) + (i / 2) * M::dof : static_cast<int>(i) * M::dof;
        const int wide = turning && i % 2 ? M::angular : M::linear;
        const Value<double> part = evaluate(*parts[i], values);
        if (is_number(parts[i], 0)) continue;
        const bool vector_row = part.shape.cols == 1 && part.shape.rows == wide && height(parts) == 1;
        high = std::max(high, vector_row ? 1 : part.shape.rows);
        for (int k = 0; k < (vector_row ? 1 : part.shape.rows); ++k)
          for (int j = 0; j < wide; ++j) J.matrix(row + k, column + j) = vector_row ? part[j] : part(k, j);
      }
      row += high;
    }
    return J;
  }

 private:
  /// Rows that these parts give: one unless C is a vector.
  int height(const std::vector<Expression>& parts) const {
    const auto i = static_cast<std::size_t>(&parts - formulas->J.data());
    return i < formulas->C.size() ? formulas->C[i]->shape.rows : 1;
  }
};

constexpr double step = 1.0 / 240, seconds = 5;

/// Whether J has parts of a body that are not nothing.
bool acts_on(const Formulas& formulas, int body) {
  for (const auto& parts : formulas.J)
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (static_cast<int>(i / (parts.size() / 2)) == body && !is_number(parts[i], 0)) return true;
  return false;
}

/// Constants of a scene a metre large.
State<double> constants_of(const Vocabulary& words) {
  State<double> all(words.all().size());
  int points = 0;
  for (const Symbol& s : words.all()) {
    Value<double>& value = all[static_cast<std::size_t>(s.id)] = Value<double>(s.shape);
    if (s.is == Is::fixed && s.shape.scalar())
      value[0] = s.name == "L" ? 2 : 1;  // L reaches from wheel to body too
    if (s.is == Is::fixed && s.shape.vector()) {
      if (s.axis >= 3)
        value[s.axis - 3] = 1;
      else if (s.name == "n")
        value[1] = 1;
      else if (s.unit_length || s.name == "t")
        value[s.axis == 2 ? 2 : 0] = 1;
      else
        value[0] = points % 2 ? 1 : -1, value[1] = 1, ++points;
    }
    if (s.is == Is::turning) {
      if (s.arm)
        value[0] = s.body == 0 ? 0.25 : -0.25;
      else
        value[s.body] = 1;  // axes of the two bodies at right angles
    }
  }
  return all;
}

template <class M, class Kind>
Ran run_kind(const Formulas& formulas, const std::string& name) {
  const bool chain = name == "chain", floating = name == "box";
  Simulation<M> simulation;
  simulation.method.drift = Baumgarte{0.2};
  Scene<M>& scene = simulation.scene;
  const auto body_at = [&](double x, double y, bool moves) {
    Linear<M> at = Linear<M>::Zero(), sides = Linear<M>::Constant(0.2);
    at[0] = x;
    at[1] = y;
    sides[0] = 0.5;
    return scene.add_body(at, moves ? box<M>(1, sides) : fixed<M>());
  };
  // Where J has no part of body 2, body 1 is the one that moves.
  const bool first_moves = !acts_on(formulas, 1);
  std::vector<int> bodies = {body_at(0, 0, floating), body_at(0.8, first_moves ? -0.6 : 0.4, true)};
  if (chain) bodies.push_back(body_at(1.6, 0.9, true));
  std::vector<Handle<Kind>> handles;
  for (std::size_t i = 0; i + 1 < bodies.size(); ++i)
    handles.push_back(scene.add(
        Kind{{first_moves ? bodies[i + 1] : bodies[i], first_moves ? bodies[i] : bodies[i + 1]}, &formulas}));
  if (floating)
    for (const int body : bodies) scene.set_gravity_scale(body, 0);

  const auto for_each = [&](auto&& visit_one) {
    for (const auto& handle : handles) {
      const Kind* kind = scene.template get_if<Kind>(scene.place(handle.id));
      visit_one(*kind, scene.bodies().pose[kind->at.body1], scene.bodies().pose[kind->at.body2]);
    }
  };
  // Newton's method to C = 0 along M⁻¹Jᵀ, link by link; an inequality may begin open.
  if (Kind::position_rows > 0 && Kind::bound == Bound::none) {
    double left = 1;
    for (int i = 0; i < 200 && left > 1e-12; ++i) {
      left = 0;
      for (const auto& handle : handles) {
        const Kind kind = *scene.template get_if<Kind>(scene.place(handle.id));
        const int b1 = kind.at.body1, b2 = kind.at.body2;
        const Pose<M> pose1 = scene.bodies().pose[b1], pose2 = scene.bodies().pose[b2];
        const auto C = kind.template value<double>(pose1, pose2);
        const auto J = kind.jacobian(pose1, pose2);
        const auto W =
            times_inverse_mass(J, scene.bodies().inverse_mass[b1], pose1, scene.bodies().inverse_mass[b2], pose2);
        const Eigen::Matrix<double, Kind::rows, Kind::rows> A = J.matrix * W.matrix.transpose();
        const Rows<Kind::rows> lambda =
            -(A + 1e-12 * Eigen::Matrix<double, Kind::rows, Kind::rows>::Identity()).inverse() * C;
        const Eigen::Matrix<double, 2 * M::dof, 1> by = W.matrix.transpose() * lambda;
        if (!by.allFinite()) throw std::invalid_argument("C or J is not a finite number where this scene begins.");
        const Velocity<M> first = by.template head<M::dof>(), second = by.template tail<M::dof>();
        if (moves(scene.bodies().inverse_mass[b1])) scene.set_pose(b1, moved<M, double>(pose1, first, 1.0));
        if (moves(scene.bodies().inverse_mass[b2])) scene.set_pose(b2, moved<M, double>(pose2, second, 1.0));
        left = std::max(left, C.cwiseAbs().maxCoeff());
      }
    }
    if (!(left < 1e-9)) throw std::invalid_argument("No place near the beginning of this scene fulfils C = 0.");
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (floating) {
      Velocity<M> thrown = Velocity<M>::Zero();
      thrown[1] = i ? 1 : -0.5;
      thrown[M::dof - 1] = i ? 2 : 1;
      scene.set_velocity(bodies[i], thrown);
    }
  Ran ran;
  ran.rows = Kind::rows * static_cast<int>(handles.size());
  ran.paths.resize(bodies.size());
  for (int i = 0; i < static_cast<int>(seconds / step); ++i) {
    simulation.step(step);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const auto& x = scene.bodies().pose[bodies[b]].position;
      ran.paths[b].push_back({x[0], x[1]});
    }
    for_each([&](const Kind& kind, const Pose<M>& pose1, const Pose<M>& pose2) {
      const auto C = kind.template value<double>(pose1, pose2);
      const auto rate = dot(kind.jacobian(pose1, pose2), scene.bodies().velocity[kind.at.body1],
                            scene.bodies().velocity[kind.at.body2]);
      for (int k = 0; k < Kind::rows; ++k) {
        const bool one_sided = Kind::bound == Bound::interval;
        ran.largest_C = std::max(ran.largest_C, one_sided ? -C[k] : std::fabs(C[k]));
        if (!one_sided) ran.largest_rate = std::max(ran.largest_rate, std::fabs(rate[k]));
      }
    });
    if constexpr (M::linear == 2)
      for (const auto& handle : handles)
        scene.change(handle, [&](Kind& kind) {
          for (int b = 0; b < 2; ++b) {
            const auto& r = scene.bodies().pose[b ? kind.at.body2 : kind.at.body1].rotation;
            double& angle = kind.angles[static_cast<std::size_t>(b)];
            angle += std::atan2(r.sin * std::cos(angle) - r.cos * std::sin(angle),
                                r.cos * std::cos(angle) + r.sin * std::sin(angle));
          }
        });
  }
  return ran;
}

template <class M>
Ran run_model(const Formulas& formulas, int rows, bool inequality, const std::string& name) {
  if (formulas.C.empty()) {
    if (rows == 1) return run_kind<M, Typed<M, 1, false, Bound::none>>(formulas, name);
  } else if (inequality) {
    if (rows == 1) return run_kind<M, Typed<M, 1, true, Bound::interval>>(formulas, name);
  } else {
    if (rows == 1) return run_kind<M, Typed<M, 1, true, Bound::none>>(formulas, name);
    if (rows == M::linear) return run_kind<M, Typed<M, M::linear, true, Bound::none>>(formulas, name);
  }
  throw std::invalid_argument("A scene runs one row, or equations with a C: two in the plane and three in space.");
}

/// Paths in braille, 60 columns wide.
std::string picture(const Ran& ran) {
  constexpr int columns = 60, rows = 20;
  double low[2] = {-0.3, -0.3}, high[2] = {0.3, 0.3};
  for (const auto& path : ran.paths)
    for (const auto& point : path)
      for (std::size_t i = 0; i < 2; ++i)
        low[i] = std::min(low[i], point[i]), high[i] = std::max(high[i], point[i]);
  const double scale = std::min((columns * 2 - 1) / (high[0] - low[0]), (rows * 4 - 1) / (high[1] - low[1]));
  std::vector<std::vector<unsigned>> dots(rows, std::vector<unsigned>(columns));
  for (const auto& path : ran.paths)
    for (const auto& point : path) {
      const int x = static_cast<int>((point[0] - low[0]) * scale),
                y = static_cast<int>((high[1] - point[1]) * scale);
      if (x < 0 || y < 0 || x >= columns * 2 || y >= rows * 4) continue;
      dots[static_cast<std::size_t>(y / 4)][static_cast<std::size_t>(x / 2)] |= course::braille_dot(x % 2, y % 4);
    }
  std::string text;
  for (auto& row : dots) {
    while (!row.empty() && row.back() == 0) row.pop_back();
    text += "  ";
    for (const unsigned cell : row) text += course::braille(cell);
    text += "\n";
  }
  return text;
}

std::string number_of(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.1e", x);
  return text;
}

}  // namespace

Ran run_in(const Sheet& sheet, const std::string& scene) {
  if (scene != "pendulum" && scene != "chain" && scene != "box")
    throw std::invalid_argument("There is no scene \"" + scene + "\": pendulum, chain or box.");
  if (!sheet.complete()) throw std::invalid_argument("A scene runs what has a right J: derive it first.");
  const Vocabulary& words = sheet.words();
  Formulas formulas{&words, {}, {}, constants_of(words)};
  int rows = 0;
  bool inequality = false, rates = false;
  for (const auto& [name, row] : sheet.rows()) {
    if (row.C) formulas.C.push_back(row.C);
    rates = rates || !row.C;
    formulas.J.push_back(row.J);
    rows += row.C ? row.C->shape.rows : row.rate->shape.rows;
    inequality = inequality || row.inequality;
  }
  if (rates && !formulas.C.empty())
    throw std::invalid_argument("A scene runs rows with a C or rows without, not both.");
  return words.world().dimension == 2 ? run_model<PlaneBody>(formulas, rows, inequality, scene)
                                      : run_model<SpaceBody>(formulas, rows, inequality, scene);
}

std::string run_scene(const Sheet& sheet, const std::string& scene) {
  try {
    const Ran ran = run_in(sheet, scene);
    const bool rates =
        std::any_of(sheet.rows().begin(), sheet.rows().end(), [](const auto& row) { return !row.second.C; });
    const bool inequality = std::any_of(sheet.rows().begin(), sheet.rows().end(),
                                        [](const auto& row) { return row.second.inequality; });
    return picture(ran) + "Five seconds at 240 steps a second, " + std::to_string(ran.rows) +
           (ran.rows == 1 ? " row: " : " rows: ") +
           (rates ? ""
                  : (inequality ? "C went below 0 by at most " : "|C| was at most ") + number_of(ran.largest_C)) +
           (rates ? "|JV| was at most " + number_of(ran.largest_rate) : "") +
           " (dots: the paths of the centres).\n";
  } catch (const std::exception& error) {
    return std::string(error.what()) + "\n";
  }
}

}  // namespace byhand::desk
