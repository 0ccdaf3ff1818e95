#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/chart.hpp"

// Curves of functions and of recorded runs. A run is a list of samples, each with its `time` [s].
namespace byhand::pictures {

/// f at equal distances from x = low to high: `curve("exact", 0, end, f)`.
template <class F>
renderer::Curve curve(std::string label, double low, double high, F&& f, int intervals = 200) {
  renderer::Curve drawn{.label = std::move(label)};
  for (int i = 0; i <= intervals; ++i) {
    drawn.x.push_back(low + (high - low) * i / intervals);
    drawn.y.push_back(f(drawn.x.back()));
  }
  return drawn;
}

/// The same dashed, as what a law predicts.
template <class F>
renderer::Curve theory(std::string label, double low, double high, F&& f, int intervals = 200) {
  renderer::Curve drawn = curve(std::move(label), low, high, f, intervals);
  drawn.style = renderer::CurveStyle::theory;
  return drawn;
}

/// A number of each sample: a member, or what a function makes of it.
template <class Sample, class F>
std::vector<double> each(const std::vector<Sample>& samples, F&& number) {
  std::vector<double> numbers;
  numbers.reserve(samples.size());
  for (const Sample& sample : samples) numbers.push_back(std::invoke(number, sample));
  return numbers;
}

/// `curve("rod", samples, &Sample::time, &Sample::angle)`
template <class Sample, class X, class Y>
renderer::Curve curve(const std::string& label, const std::vector<Sample>& samples, X&& x, Y&& y) {
  return {.label = label, .x = each(samples, x), .y = each(samples, y)};
}

/// The last sample that is not later than `time` [s], the first if all are.
template <class Sample>
const Sample& at(const std::vector<Sample>& samples, double time) {
  std::size_t i = 0;
  while (i + 1 < samples.size() && samples[i + 1].time <= time + 1e-9) ++i;
  return samples[i];
}

}  // namespace byhand::pictures
