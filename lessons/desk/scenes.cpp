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
constexpr int steps_a_moment = 4;

template <class M>
Linear<M> sides() {
  Linear<M> all = Linear<M>::Constant(0.2);
  all[0] = 0.5;
  return all;
}

/// Corners of a body's box; neighbours follow one another in the plane.
template <class M>
std::vector<Point> corners_of(const Pose<M>& pose) {
  std::vector<Point> all;
  for (const unsigned bits : {0U, 1U, 3U, 2U, 4U, 5U, 7U, 6U}) {
    if (bits >= 1U << M::linear) break;
    Linear<M> corner = 0.5 * sides<M>();
    for (int i = 0; i < M::linear; ++i)
      if (bits & 1U << i) corner[i] = -corner[i];
    const Linear<M> at = pose.position + rotate(pose.rotation, corner);
    all.push_back({at[0], at[1]});
  }
  return all;
}

/// The parts of the first row of J.
template <class M, int K>
void add_parts(const Jacobian<M, K>& J, std::size_t body1, std::size_t body2, std::vector<Parts>& parts) {
  for (const int first : {0, M::dof})
    parts.push_back(
        {first ? body2 : body1, {J.matrix(0, first), J.matrix(0, first + 1)}, J.matrix(0, first + M::dof - 1)});
}

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
    Linear<M> at = Linear<M>::Zero();
    at[0] = x;
    at[1] = y;
    return scene.add_body(at, moves ? box<M>(1, sides<M>()) : fixed<M>());
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
  for (const int body : bodies) ran.moves.push_back(moves(scene.bodies().inverse_mass[body]));
  const auto look = [&] {
    Moment moment;
    for (const int body : bodies) {
      const Pose<M>& pose = scene.bodies().pose[body];
      moment.centres.push_back({pose.position[0], pose.position[1]});
      moment.corners.push_back(corners_of<M>(pose));
    }
    for_each([&](const Kind& kind, const Pose<M>& pose1, const Pose<M>& pose2) {
      const auto place = [&](int body) {
        return static_cast<std::size_t>(std::find(bodies.begin(), bodies.end(), body) - bodies.begin());
      };
      add_parts<M, Kind::rows>(kind.jacobian(pose1, pose2), place(kind.at.body1), place(kind.at.body2),
                               moment.parts);
    });
    ran.moments.push_back(std::move(moment));
  };
  look();
  for (int i = 1; i <= static_cast<int>(seconds / step); ++i) {
    simulation.step(step);
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
    if (i % steps_a_moment == 0) look();
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

/// Dots in braille, on a paper that holds what is drawn.
class Paper {
 public:
  explicit Paper(const std::vector<Point>& holds) {
    for (const Point& point : holds)
      for (std::size_t i = 0; i < 2; ++i)
        low_[i] = std::min(low_[i], point[i]), high_[i] = std::max(high_[i], point[i]);
    scale_ = std::min((columns * 2 - 1) / (high_[0] - low_[0]), (rows * 4 - 1) / (high_[1] - low_[1]));
  }

  void dot(const Point& at) {
    const int x = static_cast<int>((at[0] - low_[0]) * scale_), y = static_cast<int>((high_[1] - at[1]) * scale_);
    if (x < 0 || y < 0 || x >= columns * 2 || y >= rows * 4) return;
    dots_[static_cast<std::size_t>(y / 4)][static_cast<std::size_t>(x / 2)] |= course::braille_dot(x % 2, y % 4);
  }
  void line(const Point& from, const Point& to) {
    const int count = 1 + static_cast<int>(std::hypot(to[0] - from[0], to[1] - from[1]) * scale_);
    for (int i = 0; i <= count; ++i) {
      const double t = static_cast<double>(i) / count;
      dot({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
    }
  }
  void arrow(const Point& from, const Point& by) {
    const Point to = {from[0] + by[0], from[1] + by[1]};
    line(from, to);
    const double length = std::hypot(by[0], by[1]);
    for (const double side : {-1.0, 1.0})
      line(to, {to[0] - (4 * by[0] - side * 3 * by[1]) / (scale_ * length),
                to[1] - (4 * by[1] + side * 3 * by[0]) / (scale_ * length)});
  }

  std::string text() const {
    std::string all;
    for (auto row : dots_) {
      while (!row.empty() && row.back() == 0) row.pop_back();
      all += "  ";
      for (const unsigned cell : row) all += course::braille(cell);
      all += "\n";
    }
    return all;
  }

 private:
  static constexpr int columns = 60, rows = 20;
  Point low_ = {-0.3, -0.3}, high_ = {0.3, 0.3};
  double scale_ = 1;  // dots a metre
  std::vector<std::vector<unsigned>> dots_{rows, std::vector<unsigned>(columns)};
};

/// The paths of the centres.
std::string picture(const Ran& ran) {
  std::vector<Point> all;
  for (const Moment& moment : ran.moments) all.insert(all.end(), moment.centres.begin(), moment.centres.end());
  Paper paper(all);
  for (std::size_t i = 0; i + 1 < ran.moments.size(); ++i)
    for (std::size_t b = 0; b < ran.moves.size(); ++b)
      paper.line(ran.moments[i].centres[b], ran.moments[i + 1].centres[b]);
  return paper.text();
}

std::string number_of(double x, const char* form = "%.1e") {
  char text[40];
  std::snprintf(text, sizeof text, form, x);
  return text;
}

/// The bodies where the scene begins, with the linear parts of J as arrows, the longest 0.6 m, and the angular
/// ones in words.
std::string picture_of_parts(const Ran& ran) {
  const Moment& begin = ran.moments.front();
  double longest = 0;
  for (const Parts& part : begin.parts) longest = std::max(longest, std::hypot(part.linear[0], part.linear[1]));
  const double scale = longest > 0 ? 0.6 / longest : 0;
  std::vector<Point> all;
  for (const auto& corners : begin.corners) all.insert(all.end(), corners.begin(), corners.end());
  for (const Parts& part : begin.parts) {
    const Point& from = begin.centres[part.body];
    all.push_back({from[0] + scale * part.linear[0], from[1] + scale * part.linear[1]});
  }
  Paper paper(all);
  for (const auto& corners : begin.corners)
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = i + 1; j < corners.size(); ++j)
        if (is_edge(i, j)) paper.line(corners[i], corners[j]);
  std::string turning;
  for (std::size_t i = 0; i < begin.parts.size(); ++i) {
    const Parts& part = begin.parts[i];
    if (std::hypot(part.linear[0], part.linear[1]) > 1e-9 * longest)
      paper.arrow(begin.centres[part.body], {scale * part.linear[0], scale * part.linear[1]});
    if (i < 2 && part.angular != 0)
      turning += (turning.empty() ? "" : ", ") + std::string("body ") + (i ? "2 " : "1 ") +
                 (part.angular > 0 ? "↺ " : "↻ ") + number_of(std::fabs(part.angular), "%.2g");
  }
  return paper.text() + "At the beginning: arrows are the linear parts of the first row of J" +
         (turning.empty() ? "; no part turns a body.\n" : "; it turns " + turning + ".\n");
}

}  // namespace

bool is_edge(std::size_t i, std::size_t j) {
  // Corners stand in the order of a Gray code, in which neighbours differ in one bit.
  const auto gray = [](std::size_t k) { return (k & 4U) | ((k ^ (k >> 1U)) & 3U); };
  const std::size_t differ = gray(i) ^ gray(j);
  return (differ & (differ - 1)) == 0;
}

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

std::string measured(const Sheet& sheet, const Ran& ran) {
  const auto any = [&](const auto& has) {
    return std::any_of(sheet.rows().begin(), sheet.rows().end(), [&](const auto& row) { return has(row.second); });
  };
  const bool rates = any([](const Row&row) { return !row.C; }),
             inequality = any([](const Row&row) { return row.inequality; });
  const Expression& C = sheet.rows().begin()->second.C;
  const std::string unit = C && sheet.rows().size() == 1 && C->unit.known ? " " + text_of(C->unit) : "";
  return "Five seconds at 240 steps a second, " + std::to_string(ran.rows) +
         (ran.rows == 1 ? " row: " : " rows: ") +
         (rates        ? "|JV| was at most " + number_of(ran.largest_rate)
          : inequality ? "C went below 0 by at most " + number_of(ran.largest_C)
                       : "|C| was at most " + number_of(ran.largest_C)) +
         (rates ? "" : unit) + ".";
}

std::string run_scene(const Sheet& sheet, const std::string& scene) {
  try {
    const Ran ran = run_in(sheet, scene);
    return picture_of_parts(ran) + picture(ran) + "The paths of the centres. " + measured(sheet, ran) + "\n";
  } catch (const std::exception& error) {
    return std::string(error.what()) + "\n";
  }
}

}  // namespace byhand::desk
