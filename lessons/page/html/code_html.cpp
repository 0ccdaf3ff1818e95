#include "lessons/page/html/code_html.hpp"

#include <algorithm>

#include "lessons/page/html/markup.hpp"

namespace byhand::site {

std::string code_html(std::string_view code) {
  std::string all = "<pre><code>";
  while (!code.empty()) {
    const size_t end = std::min(code.find('\n'), code.size());
    const std::string_view line = code.substr(0, end);
    const size_t comment = std::min(line.find("//"), line.size());
    all += "<span class=\"line\">" + escaped(line.substr(0, comment));
    if (comment < line.size()) all += "<span class=\"comment\">" + escaped(line.substr(comment)) + "</span>";
    all += "\n</span>";
    code.remove_prefix(std::min(end + 1, code.size()));
  }
  return all + "</code></pre>";
}

}  // namespace byhand::site
