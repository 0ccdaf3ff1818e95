#pragma once

#include <string>
#include <vector>

#include "lessons/page/lesson.hpp"

namespace byhand::course {

/// A step and the page that it recorded with the present parameters.
struct RecordedStep {
  const Step* step;
  Page page;
  std::vector<std::string> reads = {};  // names of the parameters on which page and pictures depend, once drawn
};

/// Begins to note which parameters are read, and says which were since.
void forget_reads(const Lesson& lesson);
std::vector<std::string> reads(const Lesson& lesson);

/// Runs the step. Drops each wrong answer of a question that lies within the tolerance of another answer; at the
/// default parameters such an answer is a LessonError instead.
RecordedStep record_step(const Lesson& lesson, const Step& step, bool quiet);

/// Throws LessonError unless the steps of a whole lesson make at least one claim and name each picture
/// differently.
void validate(const std::vector<RecordedStep>& steps);

std::vector<Claim> claims(const Page& page);

}  // namespace byhand::course
