// The derivation desk in a browser: a page asks with its lines, and is told what is said of them.

#include <nlohmann/json.hpp>
#include <optional>

#include "lessons/desk/print.hpp"
#include "lessons/desk/report.hpp"
#include "lessons/desk/scenes.hpp"
#include "lessons/page/answered.hpp"
#include "lessons/page/html/mathml.hpp"

namespace {

using namespace byhand::desk;
using nlohmann::json;

/// Columns of a text in the letters of JavaScript, UTF-16.
int letters(const std::string& text, int bytes) {
  int count = 0;
  for (int i = 0; i < bytes && i < static_cast<int>(text.size()); ++i) {
    const auto c = static_cast<unsigned char>(text[static_cast<std::size_t>(i)]);
    if ((c & 0xC0) != 0x80) count += c >= 0xF0 ? 2 : 1;
  }
  return count;
}

std::string head_in_latex(const std::string& head) {
  if (head.starts_with("dC")) return "\\dot{C}" + (head.size() > 2 ? "_{" + head.substr(2) + "}" : "");
  return latex_name(head);
}

json said(const Check& check) {
  static const char* const outcomes[] = {"told", "right", "wrong", "unreadable"};
  json result = {{"line", check.line - 1},
                 {"outcome", outcomes[static_cast<int>(check.outcome)]},
                 {"sentence", check.sentence},
                 {"name", check.finding.name},
                 {"numbers", check.numbers},
                 {"hints", check.finding.hints},
                 {"begin", letters(check.typed, check.where.begin)},
                 {"end", letters(check.typed, check.where.end)}};
  if (!check.latex.empty()) {
    try {
      result["mathml"] = byhand::site::display_mathml(head_in_latex(check.head) + " = " + check.latex);
    } catch (const std::exception&) {
      // A name that the course's LaTeX does not know stays in characters.
    }
    result["characters"] = check.head + " = " + check.characters;
  }
  return result;
}

/// What the page draws of a run: its edges by two corners each, and moments 60 a second.
json drawn(const Ran& ran) {
  json edges = json::array(), moments = json::array();
  const std::size_t corners = ran.moments.front().corners.front().size();
  for (std::size_t i = 0; i < corners; ++i)
    for (std::size_t j = i + 1; j < corners; ++j)
      if (is_edge(i, j)) edges.push_back({i, j});
  for (const Moment& moment : ran.moments) {
    json parts = json::array();
    for (const Parts& part : moment.parts)
      parts.push_back({{"body", part.body}, {"linear", part.linear}, {"angular", part.angular}});
    moments.push_back({{"centres", moment.centres}, {"corners", moment.corners}, {"parts", parts}});
  }
  return {{"moves", ran.moves}, {"edges", edges}, {"moments", moments}};
}

std::string answer_to(const std::string& request) {
  const json asked = json::parse(request);
  Sheet sheet;
  json checks = json::array();
  for (const std::string line : asked.at("lines"))
    for (const Check& check : sheet.add(line)) checks.push_back(said(check));
  json all = {{"status", sheet.status()}, {"checks", checks}};
  if (sheet.complete()) {
    all["report"] = text_of(report(sheet));
    all["code"] = cpp_struct(sheet);
  }
  if (asked.contains("scene")) {
    try {
      const Ran ran = run_in(sheet, asked.at("scene"));
      all["ran"] = drawn(ran);
      all["measured"] = measured(sheet, ran);
    } catch (const std::exception& error) {
      all["measured"] = error.what();
    }
  }
  return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::string byhand::course::answered(const std::string& request) {
  try {
    return answer_to(request);
  } catch (const std::exception& error) {
    return json{{"failure", error.what()}}.dump(-1, ' ', false, json::error_handler_t::replace);
  }
}
