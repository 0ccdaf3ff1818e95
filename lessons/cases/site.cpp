// The casebook on the web site: page_cases FOLDER [--quiet] writes cases.html, a page for each case and its films.
// Started by the program that writes the site.

#include <fmt/format.h>

#include <stdexcept>

#include "lessons/cases/pages.hpp"
#include "lessons/files/atomic_file.hpp"
#include "lessons/files/exit_status.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/page/html/markup.hpp"
#include "lessons/site/film_file.hpp"
#include "lessons/site/frame.hpp"
#include "lessons/site/page_writer.hpp"
#include "lessons/terminal/claim_table.hpp"

namespace byhand::cases {
namespace {

namespace fs = std::filesystem;
using site::escaped;

std::string page_name(const Folder& folder) { return fmt::format("case_{:02}.html", std::stoi(folder.slug)); }

constexpr int pictures = 12;  // of a film at most

/// Writes the films of a step, and links to them at the end of its section.
std::string with_films(std::string section, const course::RecordedStep& step, const fs::path& site,
                       const Folder& folder) {
  for (const course::Item& item : step.page.items())
    if (const auto* film = std::get_if<course::Sequence>(&item)) {
      const std::string path = fmt::format("cases/{}_{}.svg", folder.slug, film->name);
      course::write_whole(site / path, site::film_file(*film, pictures));
      section.insert(section.rfind("</section>"),
                     fmt::format("<p class=\"facts\"><a href=\"{}\">Play the film</a></p>\n", path));
    }
  return section;
}

std::string link(const Folder& folder, const char* rel, const char* words) {
  return fmt::format("<a rel=\"{}\" href=\"{}\"><span>{}</span> {}. {}</a>", rel, page_name(folder), words,
                     std::stoi(folder.slug), escaped(folder.make().title));
}

/// Writes a case's page. Returns what is wrong with its numbers; empty if nothing is.
std::string write(std::size_t place, const fs::path& site, bool quiet) {
  const Folder& folder = all()[place];
  const Case told = folder.make();
  const course::Lesson lesson = page_of(folder);
  const site::Told page = site::told(lesson, site, quiet);
  site::write_narrow(page.narrow, site, folder.slug);
  std::string content = fmt::format(
      R"(<article class="lesson">
<header class="lesson">
<p class="number">Case {0}</p>
<h1>{1}</h1>
<p class="summary">{2}</p>
<p class="facts"><a href="playground.html#{3}">Play with the scene</a>; at a terminal <code>./lessons/run case {0}</code>; law {4} of <a href="laws.html">the laws</a></p>
</header>
)",
      std::stoi(folder.slug), escaped(told.title), site::inline_html(told.report), folder.slug, told.law);
  for (std::size_t i = 0; i < page.steps.size(); ++i)
    content += with_films(page.sections[i], page.steps[i], site, folder);
  content += fmt::format(
      "<section class=\"closing\" id=\"take-away\">\n<h2>What to take "
      "away</h2>\n<p>{}</p>\n</section>\n</article>\n"
      "<nav class=\"neighbours\" aria-label=\"Neighbouring cases\">",
      site::inline_html(told.takeaway));
  if (place > 0) content += link(all()[place - 1], "prev", "Previous");
  if (place + 1 < all().size()) content += link(all()[place + 1], "next", "Next");
  course::write_whole(site / page_name(folder), site::framed({.title = told.title,
                                                              .content = content + "</nav>\n",
                                                              .summary = told.report,
                                                              .narrow = folder.slug,
                                                              .here = "cases.html",
                                                              .exercises = site::has_exercises(site)}));
  return course::false_claims(lesson, page.steps);
}

std::string casebook(const fs::path& site) {
  std::string rows;
  for (const Folder& folder : all()) {
    const Case told = folder.make();
    rows += fmt::format("<li><a href=\"{}\">{}</a><br />{}</li>\n", page_name(folder), escaped(told.title),
                        site::inline_html(told.report));
  }
  return site::framed({.title = "Casebook",
                       .content = fmt::format(
                           R"(<h1>The casebook</h1>
<p class="summary">Reports of engines' users. In each, the equations give the number before the run; then it is run, cured, and what the cure costs is counted.</p>
<ol class="tasks">
{}</ol>
)",
                           rows),
                       .summary = "Reports of engines' users: predicted from the equations, run, cured.",
                       .here = "cases.html",
                       .exercises = site::has_exercises(site)});
}

int run(const std::vector<std::string>& words) {
  const bool quiet = words.size() == 2 && words.back() == "--quiet";
  if (words.size() != (quiet ? 2 : 1) || words.front().empty())
    throw std::invalid_argument("page_cases takes the folder of the site, and --quiet");
  const fs::path site = words.front();
  std::string wrong;
  for (std::size_t place = 0; place < all().size(); ++place) wrong += write(place, site, quiet);
  course::write_whole(site / "cases.html", casebook(site));
  course::complain(wrong);
  return wrong.empty() ? course::fine : course::false_claim;
}

}  // namespace
}  // namespace byhand::cases

int main(int argc, char** argv) {
  return byhand::course::exit_status_of([&] { return byhand::cases::run({argv + 1, argv + argc}); });
}
