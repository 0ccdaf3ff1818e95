#include "lessons/site/course/page_text.hpp"

#include <fmt/format.h>

#include "lessons/files/atomic_file.hpp"
#include "lessons/page/error.hpp"
#include "lessons/site/bitmaps.hpp"

namespace byhand::site {

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

void replace_all(std::string& text, std::string_view begin, std::string_view end, std::string_view by) {
  for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at + by.size()))
    text.replace(at, text.find(end, at + begin.size()) + end.size() - at, by);
}

std::string take_answers(std::string& text, const std::string& page) {
  constexpr std::string_view form = "<form class=\"question\"", number = "data-question=\"", fold = "<details ",
                             summary = "<summary>", end_of_summary = "</summary>", end = "</details>";
  std::string all;
  for (auto at = text.find(form); at != std::string::npos; at = text.find(form, at + 1)) {
    const auto named = text.find(number, at) + number.size();
    const std::string question = text.substr(named, text.find('"', named) - named);
    std::string answers;
    for (auto begin = text.find(fold, at); begin < text.find("</form>", at); begin = text.find(fold, at)) {
      const std::string part = text.substr(begin, text.find(end, begin) - begin);
      text.erase(begin, part.size() + end.size());
      const auto title = part.find(summary) + summary.size(), rest = part.find(end_of_summary);
      answers += fmt::format("<p><strong>{}</strong></p>{}", part.substr(title, rest - title),
                             part.substr(rest + end_of_summary.size()));
    }
    text.insert(
        text.find("</form>", at),
        fmt::format("<p id=\"question-{0}\"><a href=\"#answer-{0}\">Hints and answer {0}</a></p>", question));
    const std::string back =
        page.empty() ? "#question-" + question : page + "#step-" + question.substr(0, question.find('.'));
    all += fmt::format("<section id=\"answer-{0}\"><h3><a href=\"{1}\">Question {0}</a></h3>{2}</section>\n",
                       question, back, answers);
  }
  return all;
}

void keep_no_room(std::string& text) {
  replace_all(text, "<svg width=\"", "viewBox", "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox");
  replace_all(text, "<img width=\"", "src=", "<img width=\"1280\" height=\"720\" src=");
}

std::string content_of_page(const std::filesystem::path& page) {
  const auto all = course::read_whole(page);
  if (!all) throw course::EnvironmentError(fmt::format("Cannot read {}.", page.string()));
  constexpr std::string_view main = "<main id=\"content\" tabindex=\"-1\">";
  const auto begin = all->find(main) + main.size();
  std::string text = loaded_at_once(all->substr(begin, all->find("</main>") - begin));
  keep_no_room(text);
  replace_all(text, " <details class=\"files\">", "</details>", "");
  replace_all(text, "<p class=\"answer\">", "</p>", "");
  replace_all(text, "<input class=\"answer\"", "/>", "");
  replace_all(text, "<p class=\"reply\"", "</p>", "");
  replace_all(text, "<div class=\"controls\"", "</div>", "");
  replace_all(text, "<div class=\"others\"", "</div>\n", "");
  replace_all(text, "<p class=\"recorded\">", "</p>\n", "");
  replace_all(text, "<p><a class=\"try\"", "</p>\n", "");
  replace_all(text, "<p class=\"printed\">", "</p>\n", "");
  replace_all(text, "<a class=\"skip\"", "</a>\n", "");
  replace_all(text, "<nav class=\"neighbours\"", "</nav>", "");
  return text;
}

}  // namespace byhand::site
