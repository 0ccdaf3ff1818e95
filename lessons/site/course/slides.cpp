#include "lessons/site/course/slides.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>
#include <vector>

#include "lessons/page/html/markup.hpp"
#include "lessons/site/course/page_text.hpp"
#include "lessons/site/lesson_page.hpp"

namespace byhand::site {
namespace {

struct Slide {
  std::string content, notes;

  std::string html() const {
    return fmt::format("<section>\n{}{}</section>\n", content,
                       notes.empty() ? "" : "<aside class=\"notes\">" + notes + "</aside>\n");
  }
};

/// The children of a step's section. Each begins a line; only source code has more.
std::vector<std::string> children(const std::string& section) {
  std::vector<std::string> all;
  std::istringstream lines(section);
  for (std::string line; std::getline(lines, line);) {
    const bool begins = line.starts_with("<h2>") || line.find(" data-item=") < line.find('>');
    if (begins)
      all.push_back(line + "\n");
    else if (!all.empty())
      all.back() += line + "\n";
  }
  return all;
}

/// One step: a title, and a slide for each child that is to be seen.
std::string stack(const std::string& section) {
  std::vector<Slide> slides;
  std::string notes, title;
  for (const std::string& child : children(section)) {
    if (child.starts_with("<h2>")) {
      slides.push_back({child, ""});
      title = child;
      replace_all(title, "h2>", "h3>");
    } else if (child.starts_with("<div class=\"text\"")) {
      notes += child;
    } else if (child.starts_with("<div") || child.starts_with("<figure") || child.starts_with("<form")) {
      slides.push_back({title + child, std::exchange(notes, "")});
    }
  }
  if (!slides.empty()) slides.back().notes += notes;
  std::string all = "<section>\n";
  for (const Slide& slide : slides) all += slide.html();
  return all + "</section>\n";
}

}  // namespace

std::string slides(const std::filesystem::path& site, const Digest& lesson) {
  const std::string name = lesson_title(lesson.slug);
  std::string page = content_of_page(site / page_of(lesson.slug)), stacks;
  replace_all(page, "href=\"", "href=\"../");
  replace_all(page, "src=\"", "src=\"../");
  replace_all(page, "<details class=\"hint\">", "</details>", "");
  replace_all(page, "<details class=\"words\">", "</details>", "");
  // What is shown again on slides of its own needs no address.
  replace_all(page, " id=\"figure-", "\"", "");
  replace_all(page, " id=\"film-", "\"", "");
  constexpr std::string_view begin = "<section class=\"step", end = "</section>";
  for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1))
    stacks += stack(page.substr(at, page.find(end, at) - at));
  return fmt::format(R"(<!DOCTYPE html>
<html lang="en" xmlns="http://www.w3.org/1999/xhtml">
<head>
<meta charset="utf-8" />
<meta name="viewport" content="width=device-width, initial-scale=1" />
<title>{0} – Constraints by Hand</title>
<link rel="stylesheet" href="reveal/reveal.css" />
<link rel="stylesheet" href="../assets/style.css" />
<link rel="stylesheet" href="../assets/slides.css" />
</head>
<body>
<div class="reveal"><div class="slides">
<section>
<h1>{0}</h1>
<p><a href="../{1}">Constraints by Hand</a></p>
</section>
{2}</div></div>
<script src="reveal/reveal.js"></script>
<script src="reveal/notes.js"></script>
<script>Reveal.initialize({{ hash: true, width: 1280, height: 800, margin: 0.02, transition: 'none', slideNumber: true, plugins: [RevealNotes] }});</script>
</body>
</html>
)",
                     escaped(name), page_of(lesson.slug), stacks);
}

}  // namespace byhand::site
