// The files that a lesson reads, from those that the worker brought along (see files in worker.js).

#include <cstdio>
#include <memory>

#include "lessons/page/source_text.hpp"
#include "renderer/error.hpp"
#include "renderer/font_file.hpp"

namespace byhand {

std::optional<std::string> course::source_text(const std::string& path) {
  const std::unique_ptr<std::FILE, decltype(&std::fclose)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return std::nullopt;
  std::string text;
  char part[4096];
  for (std::size_t n; (n = std::fread(part, 1, sizeof part, file.get())) > 0;) text.append(part, n);
  return text;
}

std::vector<unsigned char> renderer::font_file(const char* name) {
  const auto bytes = course::source_text(std::string("/fonts/") + name);
  if (!bytes) throw Unavailable(std::string("The page came without the font ") + name + ".");
  return {bytes->begin(), bytes->end()};
}

}  // namespace byhand
