#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "lessons/catalogue/wish.hpp"

// Whether a method's choices keep a wish from other initial conditions, and with a harder scene.
namespace byhand {

/// As many starts have to keep a wish, all of them, before more than 95 % of such starts do with 95 % confidence:
/// 0.95⁵⁹ < 0.05.
inline constexpr int certain = 59;

/// Of the starts of verifications, and of those that a search holds what it finds against.
inline constexpr int seed_of_verifications = 1, seed_of_searches = 1000;

/// A run from each of several initial conditions.
struct Verification {
  int starts = 0, good = 0, within = 0;  // did their duty; had errors within the limits, too
  double seconds = 0;                    // of each
  double excess = 0;                     // the largest error of those over its limit; infinite where one failed
  int worst = 0;                         // place of the start from which it was so
  std::string first_failure = {};        // "a joint opened …"; empty if all are good
  int further = 0;                       // starts from which only what needs no true motion was judged, and kept
  std::vector<int> unknown = {};         // places of those left out above: the true motion is not well known
  int left_out = 0;                      // of those, how many others have taken the place of

  bool kept() const { return within == starts; }
  bool certified() const { return kept() && starts >= certain; }
};

/// " From 46 further starts it kept …"; empty where there are none.
std::string further_in_words(const Verification& verification);

/// Calls work(0) … work(count - 1), each once.
using SideBySide = std::function<void(int count, const std::function<void(int)>& work)>;
void one_after_another(int count, const std::function<void(int)>& work);

/// Runs a point's choices from these initial conditions. `until_one_fails` leaves the rest.
Verification verify(std::span<const Problem> starts, const Point& point, const Wish& wish,
                    const SideBySide& side_by_side = one_after_another, bool until_one_fails = false);

/// Initial conditions of a seed by their numbers, of which 0 is the scene's own.
std::vector<Problem> variations(const Problem& problem, std::span<const int> numbers, int seed);
/// 0, 1, …
std::vector<int> first_numbers(int count);

/// How margin() tries the factors.
inline constexpr const char* strides_of_margin = "in strides of 2 %, and beyond twice of a fifth";
/// The factor on the scene's stress parameter, at least 1, at which this point's method no longer
/// keeps within the limits; infinite if it does at the parameter's upper end and up to a thousand, NaN if the
/// parameter is not above zero, this takes more than `most` instructions, or the true motion is not well known
/// there.
double margin(const Problem& problem, const Point& point, const std::map<Error, double>& limits,
              Spent* spent = nullptr, double most = std::numeric_limits<double>::infinity(),
              const SideBySide& side_by_side = one_after_another);

}  // namespace byhand
