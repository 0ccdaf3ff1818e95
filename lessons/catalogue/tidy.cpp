#include "lessons/catalogue/tidy.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace byhand {
namespace {

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{:.12g}", value) : ""; }

std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  return '"' + text + '"';
}

}  // namespace

std::string described_parameters(const Problem& problem) {
  std::string text;
  for (const SceneParameter& parameter : problem.scene().parameters) {
    if (parameter.name == "gravity") continue;
    text += fmt::format("{}{} = {:.4g}", text.empty() ? "" : ", ", parameter.name, problem[parameter.name]);
    if (parameter.unit != "1") text += (parameter.unit == "°" ? "" : " ") + parameter.unit;
  }
  return text;
}

std::string tidy_head() {
  return "scene,parameters,model,method,substeps,passes,cure,strength,relaxation,regularisation,initial condition,"
         "error kind,error,unit,cost (instructions a frame),row-solves a frame,time (ns a frame),"
         "watched (s),outcome,reason\n";
}

std::string tidy_rows(const Problem& problem, std::span<const Point> points, std::span<const Error> watched,
                      int start) {
  std::string rows;
  for (const Point& point : points) {
    const Knobs& k = point.knobs;
    const std::string run = fmt::format("{},{},{},{},{},{},{},{},{},{},{}", problem.scene().name,
                                        quoted(described_parameters(problem)), problem.model(), point.family->name,
                                        k.substeps, k.passes, name_of(k.cure), cell(k.strength),
                                        cell(k.relaxation), cell(k.regularisation), start);
    const std::string end =
        fmt::format("{},{},{},{},{},{}\n", cell(point.cost), cell(point.row_solves), cell(point.nanoseconds),
                    cell(point.seconds), name_of(point.outcome, problem.scene().duty), quoted(point.reason));
    if (point.outcome != Outcome::good) {
      rows += run + ",,,," + end;
      continue;
    }
    for (const Error error : watched)
      if (point.has(error))
        rows += fmt::format("{},{},{},{},{}", run, name_of(error), cell(point[error]), unit_of(error), end);
  }
  return rows;
}

}  // namespace byhand
