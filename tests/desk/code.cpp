// The code that the desk prints compiles, and at 100 states its C and J are those that were typed.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "lessons/desk/jet_functions.hpp"
#include "lessons/desk/report.hpp"
#include "lessons/desk/task.hpp"
#include "solver/byhand.hpp"

namespace {
#include "derived.hpp"
}

namespace byhand::desk {
namespace {

template <class M>
Pose<M> pose_of(const Vocabulary& words, const State<double>& state, const std::string& body) {
  const auto of = [&](const std::string& name) -> const Value<double>& {
    return state[static_cast<std::size_t>(words.at(name + body).id)];
  };
  Pose<M> pose;
  for (int i = 0; i < M::linear; ++i) pose.position[i] = of("x")[i];
  if constexpr (M::angular == 1) pose.rotation = {of("R")(0, 0), of("R")(1, 0)};
  if constexpr (M::angular == 3) {
    Eigen::Matrix3d R;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) R(i, j) = of("R")(i, j);
    pose.rotation = Eigen::Quaterniond(R);
  }
  return pose;
}

TEST(DeskCode, CompilesAndHasTheTypedJ) {
  int checked = 0;
  for_each_task([&](const std::string& file, auto derived, const auto& fill) {
    using Kind = decltype(derived);
    using M = typename Kind::M;
    std::ostringstream text;
    text << std::ifstream(std::string(BYHAND_DESK_TASKS) + "/" + file).rdbuf();
    const Task task = read_task(text.str());
    Sheet sheet;
    for (const auto* lines : {&task.before, &task.start, &task.goal})
      for (const std::string& line : *lines) sheet.add(line);
    ASSERT_EQ(sheet.rows().size(), 1u);
    const Row& row = sheet.rows().begin()->second;
    const Vocabulary& words = sheet.words();
    Random random(42);
    for (int i = 0; i < 100; ++i) {
      State<double> state = random_state(words, random);
      // An angle is known from the pose alone up to whole turns.
      for (const char* name : {"θ1", "θ2"})
        if (const Symbol* angle = words.find(name)) {
          double& at = state[static_cast<std::size_t>(angle->id)][0];
          at = std::atan2(std::sin(at), std::cos(at));
        }
      const auto of = [&](const char* name, auto& to) {
        const Value<double>& value = state[static_cast<std::size_t>(words.at(name).id)];
        if constexpr (std::is_same_v<std::decay_t<decltype(to)>, double>)
          to = value[0];
        else
          for (int k = 0; k < M::linear; ++k) to[k] = value[k];
      };
      fill(derived, of);
      if constexpr (M::angular > 0) {
        of("r1", derived.at.arms.first);
        of("r2", derived.at.arms.second);
      }
      const Pose<M> pose1 = pose_of<M>(words, state, "1"), pose2 = pose_of<M>(words, state, "2");
      const auto J = derived.jacobian(pose1, pose2);
      const auto wanted = coefficients(words, state, rate_by(words, row.J, (row.C ? row.C : row.rate)->shape, {}));
      EXPECT_EQ(position_rows_of<Kind>(), row.C ? Kind::rows : 0);
      for (int r = 0; r < Kind::rows; ++r) {
        if (row.C) {
          const double C = derived.template value<double>(pose1, pose2)[r],
                       C_wanted = evaluate(*row.C, environment<double>(words, state))[r];
          EXPECT_NEAR(C, C_wanted, 1e-12 * (1 + std::fabs(C_wanted))) << file;
        }
        for (int c = 0; c < 2 * M::dof; ++c) {
          const double typed = wanted[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
          EXPECT_NEAR(J.matrix(r, c), typed, 1e-11 * (1 + std::fabs(typed))) << file;
        }
      }
      ++checked;
      if (!row.C) continue;
      // And J is the gradient of the printed value.
      const Velocity<M> V1 = Velocity<M>::Constant(0.3), V2 = Velocity<M>::Constant(-0.7);
      const auto path = derived.template value<Jet>(on_its_way<M>(pose1, V1), on_its_way<M>(pose2, V2));
      const auto rate = dot(J, V1, V2);
      for (int r = 0; r < Kind::rows; ++r)
        EXPECT_NEAR(path[r].rate, rate[r], 1e-10 * (1 + std::fabs(rate[r]))) << file;
    }
  });
  EXPECT_EQ(checked, 1200);
}

}  // namespace
}  // namespace byhand::desk
