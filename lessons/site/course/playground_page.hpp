#pragma once

#include <string>

namespace byhand::site {

/// The page of the playground, playground.html. Its scripts are those that live/build wrote; where the site is
/// written without them, `runs` is false and the page says so. `exercises`: the site has them.
std::string playground_page(bool runs, bool exercises);

}  // namespace byhand::site
