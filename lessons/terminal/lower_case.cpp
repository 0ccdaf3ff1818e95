#include "lessons/page/lower_case.hpp"

#include <glib.h>

#include <memory>

namespace byhand::course {

std::string in_lower_case(const std::string& words) {
  const std::unique_ptr<char, decltype(&g_free)> lower(g_utf8_strdown(words.c_str(), -1), g_free);
  return lower.get();
}

}  // namespace byhand::course
