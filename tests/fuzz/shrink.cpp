#include "tests/fuzz/shrink.hpp"

#include <cmath>

#include "tests/fuzz/draw.hpp"

namespace byhand::fuzz {

namespace {

/// Without one body and what is joined to it.
template <class M>
Recipe<M> without(Recipe<M> recipe, int body) {
  recipe.parts.erase(recipe.parts.begin() + body);
  std::erase_if(recipe.links, [&](const auto& link) { return link.first == body || link.second == body; });
  for (auto& link : recipe.links) {
    link.first -= link.first > body;
    link.second -= link.second > body;
  }
  return recipe;
}

/// To this many binary digits after the point.
double rounded(double x, int digits) { return std::ldexp(std::round(std::ldexp(x, digits)), -digits); }

/// Simpler scenes, the simplest first.
template <class M>
std::vector<Recipe<M>> simpler(const Recipe<M>& recipe) {
  std::vector<Recipe<M>> all;
  const auto change = [&](auto&& f) {
    Recipe<M> changed = recipe;
    f(changed);
    all.push_back(changed);
  };
  const int bodies = static_cast<int>(recipe.parts.size());
  for (int body = bodies - 1; body >= 0; --body) all.push_back(without(recipe, body));
  for (std::size_t i = 0; i < recipe.links.size(); ++i)
    change([&](auto& r) { r.links.erase(r.links.begin() + static_cast<long>(i)); });
  for (int body = 0; body < bodies; ++body) {
    const auto& part = recipe.parts[body];
    if (!part.velocity.isZero(0)) change([&](auto& r) { r.parts[body].velocity.setZero(); });
    if (part.friction > 0) change([&](auto& r) { r.parts[body].friction = 0; });
    if (part.mass > 0 && part.mass != 1) change([&](auto& r) { r.parts[body].mass = 1; });
    if (const double power = std::pow(10, std::round(std::log10(part.mass))); part.mass > 0 && part.mass != power)
      change([&](auto& r) { r.parts[body].mass = power; });
    for (const int digits : {0, 2, 6}) {
      Recipe<M> round = recipe;
      for (double& x : round.parts[body].pose.position) x = rounded(x, digits);
      for (double& x : round.parts[body].velocity) x = rounded(x, digits);
      if (round.parts[body].pose.position != part.pose.position || round.parts[body].velocity != part.velocity)
        all.push_back(round);
    }
    if (!detail::axes<M>(part.pose).isIdentity(0))
      change([&](auto& r) { r.parts[body].pose.rotation = Pose<M>().rotation; });
  }
  return all;
}

}  // namespace

template <class M>
Recipe<M> shrunk(Recipe<M> recipe, const Law<M>& law, const VelocityStepping& method) {
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (const Recipe<M>& candidate : simpler(recipe))
      if (!broken(law, candidate, method).empty()) {
        recipe = candidate;
        smaller = true;
        break;
      }
  }
  return recipe;
}

template <class M>
std::optional<Failure<M>> failure(std::uint64_t draw, const VelocityStepping& method, std::string_view name) {
  Recipe<M> recipe = drawn<M>(draw);
  try {
    recipe = after(recipe, method, static_cast<int>(draw % 60));
  } catch (const std::exception&) {  // a law says so
  }
  for (const Law<M>& law : laws<M>()) {
    if (std::string_view(law.name).find(name) == std::string_view::npos || broken(law, recipe, method).empty())
      continue;
    const Recipe<M> least = shrunk(recipe, law, method);
    return Failure<M>{law.name, broken(law, least, method), least};
  }
  return std::nullopt;
}

#define BYHAND_INSTANTIATE(M)                                                   \
  template Recipe<M> shrunk(Recipe<M>, const Law<M>&, const VelocityStepping&); \
  template std::optional<Failure<M>> failure(std::uint64_t, const VelocityStepping&, std::string_view)
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand::fuzz
