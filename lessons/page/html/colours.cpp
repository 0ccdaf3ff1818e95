#include "lessons/page/html/colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "renderer/palette.hpp"

namespace byhand::site {
namespace {

namespace palette = renderer::palette;

struct Quantity {
  std::string_view symbol, css_class;
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

/// The fill that a tag names, or nothing.
std::string_view fill_of(std::string_view tag) {
  constexpr std::string_view name = " fill=\"";
  const auto at = tag.find(name);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = tag.substr(at + name.size());
  return rest.substr(0, rest.find('"'));
}

bool is_in(const Quantity& quantity, std::string_view variable, std::string_view fill) {
  const renderer::Colour seen = renderer::legible(quantity.colour);
  return variable.find(quantity.symbol) != std::string_view::npos &&
         fill == fmt::format("#{:02x}{:02x}{:02x}", seen.r, seen.g, seen.b);
}

/// The quantities that pictures name in their colour: in italics, in a text with that fill or, without its own, in
/// the group around it.
std::set<const Quantity*> named_in_pictures(std::string_view html) {
  constexpr std::string_view italic = "<tspan font-style=\"italic\">";
  std::set<const Quantity*> named;
  std::vector<std::string_view> groups;  // the fills of those around here, the innermost last
  for (auto at = html.find('<'); at != std::string_view::npos; at = html.find('<', at + 1)) {
    const std::string_view rest = html.substr(at), tag = rest.substr(0, rest.find('>'));
    if (tag == "<g" || tag.starts_with("<g ")) groups.push_back(fill_of(tag));
    if (tag == "</g" && !groups.empty()) groups.pop_back();
    if (!tag.starts_with("<text")) continue;
    std::string_view fill = fill_of(tag);
    if (fill.empty() && !groups.empty()) fill = groups.back();
    const std::string_view text = rest.substr(0, rest.find("</text>"));
    for (auto i = text.find(italic); i != std::string_view::npos; i = text.find(italic, i + 1)) {
      const auto begin = i + italic.size();
      const std::string_view variable = text.substr(begin, text.find('<', begin) - begin);
      for (const Quantity& quantity : quantities)
        if (is_in(quantity, variable, fill)) named.insert(&quantity);
    }
  }
  return named;
}

}  // namespace

std::string with_colours(std::string_view html) {
  constexpr std::string_view plain = "<mi>";
  const std::set<const Quantity*> named = named_in_pictures(html);
  std::string all;
  std::size_t copied = 0;
  for (auto at = html.find(plain); at != std::string_view::npos; at = html.find(plain, at + 1)) {
    const std::string_view symbol = html.substr(at + plain.size(), html.find("</mi>", at) - at - plain.size());
    const auto quantity =
        std::find_if(named.begin(), named.end(), [&](const Quantity* one) { return one->symbol == symbol; });
    if (quantity == named.end()) continue;
    all += html.substr(copied, at - copied);
    all += fmt::format("<mi class=\"{}\">", (*quantity)->css_class);
    copied = at + plain.size();
  }
  return all += html.substr(copied);
}

}  // namespace byhand::site
