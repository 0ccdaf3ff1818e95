#pragma once

#include <vector>

#include "lessons/files/picture_drawer.hpp"
#include "lessons/page/page.hpp"
#include "renderer/image.hpp"
#include "tests/lessons/settings/rules.hpp"

namespace byhand::tests {

/// Whether hardly anything stands out from the paper: less than one pixel in a thousand.
bool is_blank(const renderer::Image& image);

/// Draws the page's pictures, and of each sequence its first, middle and last frame, small and into no file. None
/// may be blank.
std::vector<Finding> blank_pictures(const course::Page& page, course::PictureDrawer& pictures);

}  // namespace byhand::tests
