#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lessons/site/digest.hpp"

namespace byhand::site {

constexpr int minutes_of_a_class = 90;

/// What to do in a part of a class: show a scene or films, ask questions, do exercises.
struct PlannedPart {
  int minutes = 0;
  std::string step = {}, show = {}, ask = {};  // label of the step; empty for the exercises at the end
};

/// A class of 90 minutes on a lesson: its core steps, each as long as its words, questions, films and scene want,
/// then its exercises.
std::vector<PlannedPart> plan(const Digest& lesson, const std::vector<int>& exercises);

/// The numbers of the exercises by lesson, which the task.md of each names.
std::map<int, std::vector<int>> exercises_by_lesson(const std::filesystem::path& practise);

}  // namespace byhand::site
