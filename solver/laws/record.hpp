#pragma once

#include <vector>

#include "solver/laws/law.hpp"

namespace byhand::laws {

/// What one signed number does over a run, zero being where it belongs: the stretch of a chain, the lean of a
/// column.
///
///   explodes   it gets beyond `large`, the size of the scene itself, or is no number any more
///   settles    in the last third of the run it is smaller than in the third before, or nowhere above `small`
///   rings      it does not, and crosses zero
///   drifts     it does not, on one side
///
/// "Smaller" is by the root of the mean square, so that a disturbance need not be over to be seen to die.
class Record {
 public:
  Record(double small, double large) : small_(small), large_(large) {}

  /// Notes the number after one more step; false once that is pointless, because it has exploded.
  bool note(double x);

  /// Of at least three steps.
  Outcome outcome() const;

 private:
  double small_, large_;
  std::vector<double> numbers_;
};

}  // namespace byhand::laws
