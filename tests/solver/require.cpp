#include "solver/support/require.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace require_test {

using namespace byhand;
using testing::StrEq, testing::ThrowsMessage;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Require, SaysTheNameTheValueAndWhatIsAllowed) {
  EXPECT_THAT(
      [] { require_positive("length", -1, "m"); },
      ThrowsMessage<std::invalid_argument>(StrEq("length is -1, but it must be a positive finite number [m]")));
  EXPECT_THAT([] { require_finite("speed", std::nan("")); },
              ThrowsMessage<std::invalid_argument>(StrEq("speed is nan, but it must be a finite number")));
  EXPECT_THAT([] { require_in("beta", 2.5, 0, 2); },
              ThrowsMessage<std::invalid_argument>(StrEq("beta is 2.5, but it must be between 0 and 2")));
  EXPECT_THAT([] { require_inside("omega", 2, 0, 2); },
              ThrowsMessage<std::invalid_argument>(StrEq("omega is 2, but it must be above 0 and below 2")));
  EXPECT_THAT([] { require(false, "body", 7, "one of 0 to 3"); },
              ThrowsMessage<std::invalid_argument>(StrEq("body is 7, but it must be one of 0 to 3")));
}

TEST(Require, LetsTheAllowedPass) {
  EXPECT_NO_THROW(require_positive("x", std::numeric_limits<double>::denorm_min()));
  EXPECT_NO_THROW(require_finite("x", -1e308));
  EXPECT_NO_THROW(require_in("x", 0, 0, 2));
  EXPECT_NO_THROW(require_in("x", 2, 0, 2));
  EXPECT_NO_THROW(require_inside("x", 1.999, 0, 2));
}

TEST(Require, RefusesWhatIsNotFinite) {
  for (const double bad : {infinity, -infinity, std::nan("")}) {
    EXPECT_THROW(require_positive("x", bad), std::invalid_argument);
    EXPECT_THROW(require_finite("x", bad), std::invalid_argument);
    EXPECT_THROW(require_in("x", bad, 0, 2), std::invalid_argument);
    EXPECT_THROW(require_inside("x", bad, 0, 2), std::invalid_argument);
  }
  EXPECT_THROW(require_positive("x", 0.0), std::invalid_argument);
}

}  // namespace require_test
