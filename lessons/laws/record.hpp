#pragma once

#include <vector>

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// What one signed number does over a run that begins with a small disturbance, zero being where it belongs: the
/// stretch of a chain, the speed at which a column leans.
///
///   explodes   it gets beyond `large`, the size of the scene itself, or is no number any more
///   settles    it never gets ten thousand times as large as the disturbance, and in the last third of the run it
///   is
///              smaller than in the third before, or gone but for a ten-thousandth of the disturbance
///   rings      it does not, and crosses zero in the last third
///   drifts     it does not, on one side
///
/// "Smaller" is by the root of the mean square, so that a disturbance need not be over to be seen to die; "never"
/// because what has grown is held by other things at last, and may then become smaller by chance.
class Record {
 public:
  Record(double disturbance, double large) : disturbance_(disturbance), large_(large) {}

  /// Notes the number after one more step; false once there is nothing more to be seen, because it has exploded or
  /// settled.
  bool note(double x);

  /// Of at least three steps.
  Outcome outcome() const;

 private:
  double disturbance_, large_, largest_ = 0;
  std::size_t quiet_ = 0;  // for how many steps
  std::vector<double> numbers_;
};

}  // namespace byhand::laws
