#include "lessons/site/bitmaps.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace byhand::site {
namespace {

// The parts of an SVG image, and what stands for each where HTML shows it: "<image x=… href="PATH"/>".
constexpr std::array<std::string_view, 3> at_once{"<image ", " href=\"", "\"/>"},
    when_seen{"<foreignObject ", "><img loading=\"lazy\" alt=\"\" src=\"", "\"/></foreignObject>"};

std::string changed(std::string markup, const std::array<std::string_view, 3>& from,
                    const std::array<std::string_view, 3>& to) {
  for (auto at = markup.find(from[0]); at != std::string::npos; at = markup.find(from[0], at))
    for (std::size_t part = 0; part < from.size(); ++part) {
      at = markup.find(from[part], at);
      markup.replace(at, from[part].size(), to[part]);
      at += to[part].size();
    }
  return markup;
}

}  // namespace

std::string loaded_when_seen(std::string markup) { return changed(std::move(markup), at_once, when_seen); }

std::string loaded_at_once(std::string markup) { return changed(std::move(markup), when_seen, at_once); }

}  // namespace byhand::site
