#pragma once

#include <optional>
#include <string>

#include "lessons/terminal/typeset.hpp"
#include "renderer/opengl/pixel_canvas.hpp"

namespace byhand::course {

/// A picture of characters: lines and areas in braille, labels in letters, on the terminal's own background.
/// `canvas` lists its labels (Canvas::list_labels).
std::string character_picture(renderer::PixelCanvas& canvas, int columns, const Style& style);

/// Whether the terminal shows real pictures, by kitty's or iTerm's protocol or as sixels.
bool shows_images();

/// The image as an escape sequence of such a terminal, `columns` wide and `rows` high, ending with a newline.
std::string image_sequence(const renderer::Image& image, int columns, int rows);

/// Number of rows of a picture with the proportions of the page, `columns` wide.
int picture_rows(int columns);
/// The widest picture that fits on the terminal.
int picture_columns(const Style& style);

/// A label without its markup for subscripts and superscripts: "v₁" for "v_1".
std::string without_markup(std::string_view label);

}  // namespace byhand::course
