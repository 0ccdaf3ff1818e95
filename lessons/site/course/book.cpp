#include "lessons/site/course/book.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/commit.hpp"
#include "lessons/page/error.hpp"
#include "lessons/page/html/markup.hpp"
#include "lessons/site/course/page_text.hpp"
#include "lessons/site/course/zip.hpp"
#include "lessons/site/lesson_page.hpp"

namespace byhand::site {
namespace {

namespace fs = std::filesystem;

std::string contents_of(const fs::path& path) {
  if (auto bytes = course::read_whole(path)) return *std::move(bytes);
  throw course::EnvironmentError(fmt::format("Cannot read {}.", path.string()));
}

std::string content(const fs::path& page) {
  std::string text = content_of_page(page);
  // Measured running times, whose charts alone are files, would make every copy another book.
  for (auto at = text.find("<img "); at != std::string::npos; at = text.find("<img ", at)) {
    at = text.rfind("<div class=\"picture\"", at);
    text.replace(at, text.find("</div>", at) + 6 - at,
                 "<p>(Running times differ from run to run; the site has this chart.)</p>");
  }
  // A reader of books may not be able to unfold them.
  if (const std::string answers = take_answers(text); !answers.empty())
    text += "<section class=\"answers\"><h2>Hints and answers</h2>\n" + answers + "</section>\n";
  // There are no sliders and no terminal.
  replace_all(text, "<details class=\"parameters\">", "</details>\n", "");
  replace_all(text, "<section class=\"closing\" id=\"to-try\">", "</section>\n", "");
  // An attribute of SVG 2, which EPUB 3 knows as a style only.
  replace_all(text, "paint-order=\"stroke\"", "style=\"paint-order:stroke\"");
  replace_all(text, ".html#", ".xhtml#");
  replace_all(text, ".html\"", ".xhtml\"");
  return text;
}

struct Chapter {
  std::string file, title;  // "04_baumgarte", "4. Baumgarte"
  std::string content;
};

std::string page(const std::string& title, std::string content) {
  // What HTML knows by its name, XML knows by its namespace.
  replace_all(content, "<math>", R"(<math xmlns="http://www.w3.org/1998/Math/MathML">)");
  return fmt::format(R"(<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE html>
<html xmlns="http://www.w3.org/1999/xhtml" xmlns:epub="http://www.idpf.org/2007/ops" lang="en" xml:lang="en">
<head>
<title>{}</title>
<link rel="stylesheet" type="text/css" href="assets/book.css" />
</head>
<body>
{}
</body>
</html>
)",
                     escaped(title), content);
}

std::string title_page() {
  return R"(<section epub:type="titlepage">
<h1>Constraints by Hand</h1>
<p class="summary">A course that derives physical constraints, solves them and keeps them stable, and shows where each method
fails and what its accuracy costs.</p>
<p>Its numbers and figures were computed by the C++ that it quotes. As a web site, where its parameters can be changed, and as
programs it is in the repository; <code>./lessons/run site</code> writes the site and this book.</p>
<p>MIT licence. Equations (1) to (23) are those of R. Gaul, <cite>Modelling and Solving Physical Constraints</cite>, 2013. The
licences of the fonts are in <code>assets/fonts/LICENCES.txt</code>.</p>
</section>)";
}

std::string table_of_contents(const std::vector<Chapter>& chapters, const std::vector<Digest>& lessons) {
  std::string rows;
  for (const Chapter& chapter : chapters) {
    std::string steps;
    for (const Digest& lesson : lessons)
      if (lesson.slug == chapter.file)
        for (const Digest::Step& step : lesson.steps)
          steps += fmt::format("<li><a href=\"{}.xhtml#step-{}\">{} {}</a></li>\n", chapter.file, step.label,
                               step.label, inline_html(step.title, Links::none));
    rows += fmt::format("<li><a href=\"{}.xhtml\">{}</a>{}</li>\n", chapter.file, escaped(chapter.title),
                        steps.empty() ? "" : "\n<ol>\n" + steps + "</ol>\n");
  }
  return "<nav epub:type=\"toc\" id=\"toc\"><h1>Contents</h1>\n<ol>\n" + rows + "</ol></nav>";
}

/// One entry of the list of files.
std::string item(const std::string& id, const std::string& file, const char* type,
                 const std::string& properties = "") {
  return fmt::format("<item id=\"{}\" href=\"{}\" media-type=\"{}\"{}/>\n", id, file, type,
                     properties.empty() ? "" : fmt::format(" properties=\"{}\"", properties));
}

std::string properties_of(const std::string& content) {
  std::string all;
  if (content.find("<math") != std::string::npos) all += "mathml";
  if (content.find("<svg") != std::string::npos) all += all.empty() ? "svg" : " svg";
  return all;
}

std::string package(const std::string& items, const std::string& spine) {
  return fmt::format(R"(<?xml version="1.0" encoding="utf-8"?>
<package xmlns="http://www.idpf.org/2007/opf" version="3.0" unique-identifier="id" xml:lang="en">
<metadata xmlns:dc="http://purl.org/dc/elements/1.1/">
<dc:identifier id="id">constraints-by-hand {0}</dc:identifier>
<dc:title>Constraints by Hand</dc:title>
<dc:creator>The authors of Constraints by Hand</dc:creator>
<dc:language>en</dc:language>
<dc:rights>MIT licence</dc:rights>
<meta property="dcterms:modified">{1}</meta>
<meta property="schema:accessMode">textual</meta>
<meta property="schema:accessMode">visual</meta>
<meta property="schema:accessModeSufficient">textual</meta>
<meta property="schema:accessibilityFeature">MathML</meta>
<meta property="schema:accessibilityFeature">alternativeText</meta>
<meta property="schema:accessibilityFeature">structuralNavigation</meta>
<meta property="schema:accessibilityFeature">tableOfContents</meta>
<meta property="schema:accessibilityHazard">none</meta>
<meta property="schema:accessibilitySummary">Formulas are MathML. Charts have their numbers in words.</meta>
</metadata>
<manifest>
{2}</manifest>
<spine>
{3}</spine>
</package>
)",
                     course::commit(), course::commit_time(), items, spine);
}

}  // namespace

std::string book(const fs::path& site, const std::vector<Digest>& lessons) {
  std::vector<Chapter> chapters = {{"title", "Constraints by Hand", title_page()}};
  for (const Digest& lesson : lessons)
    chapters.push_back({lesson.slug, lesson_title(lesson.slug), content(site / page_of(lesson.slug))});
  chapters.push_back({"equations", "Equations", content(site / "equations.html")});
  chapters.push_back({"laws", "Laws", content(site / "laws.html")});

  Zip zip;
  zip.add("mimetype", "application/epub+zip", Zip::Store::as_it_is);
  zip.add("META-INF/container.xml", R"(<?xml version="1.0"?>
<container version="1.0" xmlns="urn:oasis:names:tc:opendocument:xmlns:container">
<rootfiles><rootfile full-path="book/package.opf" media-type="application/oebps-package+xml"/></rootfiles>
</container>
)");
  std::string items, spine;
  for (const Chapter& chapter : chapters) {
    zip.add("book/" + chapter.file + ".xhtml", page(chapter.title, chapter.content));
    items += item("c-" + chapter.file, chapter.file + ".xhtml", "application/xhtml+xml",
                  properties_of(chapter.content));
    spine += fmt::format("<itemref idref=\"c-{}\"/>\n", chapter.file);
  }
  const std::string contents = table_of_contents(chapters, lessons), has = properties_of(contents);
  zip.add("book/contents.xhtml", page("Contents", contents));
  items += item("contents", "contents.xhtml", "application/xhtml+xml", has.empty() ? "nav" : "nav " + has);
  int files = 0;
  const auto add_files = [&](const fs::path& folder, const char* extension, const char* type) {
    if (!fs::is_directory(site / folder)) return;
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(site / folder))
      if (entry.path().extension() == extension) names.push_back((folder / entry.path().filename()).string());
    std::sort(names.begin(), names.end());
    for (const std::string& name : names) {
      zip.add("book/" + name, contents_of(site / name));
      items += item(fmt::format("f-{}", ++files), name, type);
    }
  };
  if (const auto cover = course::read_whole(site / "03_iterations" / "card.png")) {
    zip.add("book/cover.png", *cover);
    items += item("cover", "cover.png", "image/png", "cover-image");
  }
  zip.add("book/assets/book.css", contents_of(site / "assets" / "book.css"));
  items += item("style", "assets/book.css", "text/css");
  for (const Digest& lesson : lessons) add_files(fs::path(lesson.slug) / "figures", ".png", "image/png");
  add_files("assets/fonts", ".woff2", "font/woff2");
  add_files("assets/fonts", ".txt", "text/plain");
  zip.add("book/package.opf", package(items, spine));
  return zip.finish();
}

}  // namespace byhand::site
