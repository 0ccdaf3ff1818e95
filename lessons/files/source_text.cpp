#include "lessons/page/source_text.hpp"

#include <fstream>
#include <iterator>

namespace byhand::course {

std::optional<std::string> source_text(const std::string& path) {
  std::ifstream file(path);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace byhand::course
