#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/07_sweep/signature.hpp"
#include "lessons/practise/judge/stage.hpp"

double residual(const std::vector<Row>& rows, const Velocities& V) {
  double most = 0;
  for (const Row& row : rows) most = std::max(most, std::abs(dot(row.J, V) + row.b));
  return most;
}

void probe(Probe& p, const Code& code) {
  const auto [warm_start, sweep] = Learners::of(code);
  const InverseMasses W = p.inverse_masses();
  const Velocities V = p.velocities("V");
  std::vector<Row> rows(static_cast<std::size_t>(1 + (p.one_of(5) + 2) % 5));  // 3 on the first probe
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string name = "row" + std::to_string(i + 1);
    Row& row = rows[i];
    row.J = p.row(name + ".J");
    row.W = over_masses(row.J, W);
    row.K = inverse_mass_along(row.J, W);
    row.b = p.number(name + ".b", "m²/s", -2, 2);
    row.lambda = p.number(name + ".lambda", "kg/s", -2, 2);
  }
  const std::vector<Row> first = rows;

  Velocities now = V;
  warm_start(rows, now);
  p.answer("warm v1", "m/s", now.v1);
  p.answer("warm w1", "rad/s", now.w1);
  p.answer("warm v2", "m/s", now.v2);
  p.answer("warm w2", "rad/s", now.w2);
  sweep(rows, now);
  p.answer("v1, 1 sweep", "m/s", now.v1);
  p.answer("w1, 1 sweep", "rad/s", now.w1);
  p.law("after a sweep its last row is solved: JV = −b", "m²/s", dot(rows.back().J, now), -rows.back().b);
  for (int i = 0; i < 4; ++i) sweep(rows, now);
  p.answer("λ of the first and last row, 5 sweeps", "kg/s", Vec2{rows.front().lambda, rows.back().lambda});
  p.answer("left, 5 sweeps", "m²/s", residual(rows, now));
  Velocities paid = V;
  for (std::size_t i = 0; i < rows.size(); ++i) paid += rows[i].lambda * first[i].W;
  p.law("V has changed by what λ counts", "m/s", now.v2.x, paid.v2.x);
}

void film(Film& film, const Code& code) {
  const auto [warm_start, sweep] = Learners::of(code);
  film.title = "Two rods of 1 m, the lower bob ten times as heavy, 2 sweeps a step";
  film.quantity = "length of the upper rod";
  film.unit = "m";
  constexpr double h = time_step;
  const InverseMasses masses{1 / 0.5, 0, 1 / 5.0, 0};
  Vec2 p1{1, 0}, p2{2, 0};
  Velocities V;
  std::vector<Row> rows(2);
  for (int i = 0; i <= 180; ++i) {
    if (i % 2 == 0)
      film.frames.push_back({{{Shape::rod, {}, p1},
                              {Shape::rod, p1, p2},
                              {Shape::anchor, {}, {}},
                              {Shape::bob, p1, {0.1, 0}},
                              {Shape::bob, p2, {0.2, 0}}},
                             length(p1)});
    V.v1.y -= 9.81 * h;
    V.v2.y -= 9.81 * h;
    const Vec2 d = p2 - p1;
    rows[0].J = {p1, 0, {}, 0};
    rows[1].J = rod_slope({}, {}, d);
    rows[0].b = -rate_that_keeps(rod_error(p1, 1), 0.9, h);
    rows[1].b = -rate_that_keeps(rod_error(d, 1), 0.9, h);
    for (Row& row : rows) {
      row.W = over_masses(row.J, masses);
      row.K = inverse_mass_along(row.J, masses);
    }
    warm_start(rows, V);
    for (int k = 0; k < 2; ++k) sweep(rows, V);
    p1 += h * V.v1;
    p2 += h * V.v2;
  }
}
