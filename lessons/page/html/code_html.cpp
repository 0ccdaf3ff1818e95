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

std::string command_html(std::string_view command) {
  std::string all = "<code>";
  while (!command.empty()) {
    const size_t end = std::min(command.find(' '), command.size());
    const std::string_view word = command.substr(0, end);
    all += word.starts_with("--") ? "<span class=\"whole\">" + escaped(word) + "</span>" : escaped(word);
    if (end < command.size()) all += ' ';
    command.remove_prefix(std::min(end + 1, command.size()));
  }
  return all + "</code>";
}

}  // namespace byhand::site
