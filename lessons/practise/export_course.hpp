#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "lessons/practise/judge/submission.hpp"

namespace byhand::practise {

/// Makes a folder that a teacher gives to gradescope, classroom50, prairielearn or junit: the judge's sources, the
/// keys of this seed and what starts them; neither solutions nor mutants, hints or derivations. Throws
/// std::invalid_argument for another kind.
void export_course(const std::string& kind, const std::filesystem::path& folder, std::uint64_t seed,
                   const std::vector<const Exercise*>& wanted);

/// Throws std::invalid_argument unless the folder is empty or not there yet.
void require_empty(const std::filesystem::path& folder);

/// The predictions of all lessons as moodle (Moodle XML) or qti (QTI 2.1 items). `asked`: the folder with what
/// each lesson prints under --questions, as 01_jacobian.json; where it is empty, the lessons are run.
void export_questions(const std::string& kind, const std::filesystem::path& folder,
                      const std::filesystem::path& asked = {});

}  // namespace byhand::practise
