#pragma once

#include <string>
#include <string_view>

namespace byhand::site {

/// Text for HTML and XML: <, >, & and " as entities. The pages are XML too, so that EPUB can hold them.
std::string escaped(std::string_view text);

}  // namespace byhand::site
