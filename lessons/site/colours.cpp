#include "lessons/site/colours.hpp"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "renderer/palette.hpp"

namespace byhand::site {
namespace {

namespace palette = renderer::palette;

struct Quantity {
  const char *symbol, *css_class;
  renderer::Colour colour;
};

/// What has one meaning and one colour in all lessons. Not d, which is also that of a derivative.
constexpr Quantity quantities[] = {{"J", "constraint", palette::constraint},
                                   {"l", "constraint", palette::constraint},
                                   {"a", "constraint", palette::constraint},
                                   {"λ", "force", palette::force},
                                   {"F", "force", palette::force},
                                   {"V", "velocity", palette::velocity},
                                   {"v", "velocity", palette::velocity},
                                   {"ω", "velocity", palette::velocity},
                                   {"C", "error", palette::error}};

/// The variables, which are italic, in the texts that pictures write in this colour: their own or that of a group
/// around them.
std::string variables_in(std::string_view html, renderer::Colour colour) {
  constexpr std::string_view italic = "<tspan font-style=\"italic\">";
  const renderer::Colour seen = renderer::legible(colour);
  const std::string fill = fmt::format(" fill=\"#{:02x}{:02x}{:02x}\"", seen.r, seen.g, seen.b);
  std::string all;
  std::vector<bool> groups;  // around here, the innermost last: whether they have that colour
  for (auto at = html.find('<'); at != std::string_view::npos; at = html.find('<', at + 1)) {
    const std::string_view rest = html.substr(at), tag = rest.substr(0, rest.find('>'));
    const bool coloured = tag.find(fill) != std::string_view::npos;
    if (tag == "<g" || tag.starts_with("<g ")) groups.push_back(coloured);
    if (tag == "</g" && !groups.empty()) groups.pop_back();
    const bool own = tag.find(" fill=") != std::string_view::npos;
    if (!tag.starts_with("<text") || !(own ? coloured : !groups.empty() && groups.back())) continue;
    const std::string_view text = rest.substr(0, rest.find("</text>"));
    for (auto i = text.find(italic); i != std::string_view::npos; i = text.find(italic, i + 1)) {
      const auto begin = i + italic.size();
      all += text.substr(begin, text.find('<', begin) - begin);
    }
  }
  return all;
}

}  // namespace

std::string with_colours(std::string html) {
  for (const auto& [symbol, css_class, colour] : quantities) {
    if (variables_in(html, colour).find(symbol) == std::string::npos) continue;
    const std::string plain = fmt::format("<mi>{}</mi>", symbol),
                      coloured = fmt::format("<mi class=\"{}\">{}</mi>", css_class, symbol);
    for (auto at = html.find(plain); at != std::string::npos; at = html.find(plain, at + coloured.size()))
      html.replace(at, plain.size(), coloured);
  }
  return html;
}

}  // namespace byhand::site
