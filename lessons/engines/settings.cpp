#include "lessons/engines/settings.hpp"

#include <algorithm>
#include <cstdio>

namespace byhand::engines {
namespace {

bool is_switch(const std::string& name) {
  return name == "RK4" || name == "RATTLE" || name == "NNCG" || name == "DANTZIG" || name == "elliptic" ||
         name.ends_with("in joint coordinates");
}

}  // namespace

double Knobs::value(const std::string& name, double shipped) const {
  const auto found =
      std::find_if(turned_.begin(), turned_.end(), [&](const auto& knob) { return knob.first == name; });
  return found == turned_.end() ? shipped : found->second;
}

std::string Knobs::words() const {
  std::string words;
  for (const auto& [name, value] : turned_) {
    char number[32];
    std::snprintf(number, sizeof number, "%.4g", value);
    const bool counts = name.ends_with("iterations") || name.ends_with("steps") || name == "sweeps";
    const std::string told = is_switch(name) ? name
                             : counts ? number + (" " + (value == 1 ? name.substr(0, name.size() - 1) : name))
                                      : name + " " + number;
    if (!is_switch(name) || value != 0) words += (words.empty() ? "" : ", ") + told;
  }
  return words.empty() ? "as shipped" : words;
}

namespace {

template <std::size_t n, std::size_t m>
std::vector<Shares> shares(const std::array<int, n>& iterations, const std::array<int, m>& steps) {
  std::vector<Shares> all;
  for (const int a_frame : iterations)
    for (const int number : steps) all.push_back({number, a_frame / number});
  return all;
}

}  // namespace

std::vector<Shares> shares_of_joints() { return shares(joint_iterations, joint_steps); }
std::vector<Shares> shares_of_contacts() { return shares(contact_iterations, contact_steps); }

double iterations_a_frame(const Setting& setting) {
  double a_step = 1;
  for (const char* name : {"iterations", "velocity iterations", "sweeps"})
    a_step = std::max(a_step, setting.knobs.value(name, 1));
  return setting.steps * setting.knobs.value("substeps", 1) * a_step;
}

}  // namespace byhand::engines
