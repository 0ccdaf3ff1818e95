#include "lessons/site/course/page_text.hpp"

#include <fmt/format.h>

#include "lessons/files/atomic_file.hpp"
#include "lessons/page/error.hpp"

namespace byhand::site {

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

void replace_all(std::string& text, std::string_view begin, std::string_view end, std::string_view by) {
  for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at + by.size()))
    text.replace(at, text.find(end, at + begin.size()) + end.size() - at, by);
}

std::string content_of_page(const std::filesystem::path& page) {
  const auto all = course::read_whole(page);
  if (!all) throw course::EnvironmentError(fmt::format("Cannot read {}.", page.string()));
  constexpr std::string_view main = "<main id=\"content\" tabindex=\"-1\">";
  const auto begin = all->find(main) + main.size();
  std::string text = all->substr(begin, all->find("</main>") - begin);
  replace_all(text, " <span class=\"files\">", "</span>", "");
  replace_all(text, "<p class=\"answer\">", "</p>", "");
  replace_all(text, "<input class=\"answer\"", "/>", "");
  replace_all(text, "<p class=\"reply\"", "</p>", "");
  replace_all(text, "<div class=\"controls\"", "</div>", "");
  replace_all(text, "<div class=\"others\"", "</div>\n", "");
  replace_all(text, "<p><a class=\"try\"", "</p>\n", "");
  replace_all(text, "<nav class=\"neighbours\"", "</nav>", "");
  return text;
}

}  // namespace byhand::site
