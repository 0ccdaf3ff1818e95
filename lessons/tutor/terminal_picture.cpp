#include "lessons/tutor/terminal_picture.hpp"

#include <chafa.h>

#include <cstdlib>
#include <memory>
#include <string_view>

namespace byhand::tutor {
namespace {

template <auto release>
struct Release {
  template <class T>
  void operator()(T* object) const {
    release(object);
  }
};

bool has_true_colour() {
  const char* const says = std::getenv("COLORTERM");
  return says && (std::string_view(says) == "truecolor" || std::string_view(says) == "24bit");
}

}  // namespace

std::string terminal_picture(const renderer::Image& image, int columns, int rows) {
  // A cell is about twice as high as it is wide.
  chafa_calc_canvas_geometry(image.width, image.height, &columns, &rows, 0.5F, TRUE, FALSE);

  const std::unique_ptr<ChafaSymbolMap, Release<chafa_symbol_map_unref>> symbols(chafa_symbol_map_new());
  chafa_symbol_map_add_by_tags(symbols.get(),
                               static_cast<ChafaSymbolTags>(CHAFA_SYMBOL_TAG_BLOCK | CHAFA_SYMBOL_TAG_BORDER |
                                                            CHAFA_SYMBOL_TAG_DIAGONAL | CHAFA_SYMBOL_TAG_SPACE));
  const std::unique_ptr<ChafaCanvasConfig, Release<chafa_canvas_config_unref>> config(chafa_canvas_config_new());
  chafa_canvas_config_set_geometry(config.get(), columns, rows);
  chafa_canvas_config_set_symbol_map(config.get(), symbols.get());
  chafa_canvas_config_set_canvas_mode(
      config.get(), has_true_colour() ? CHAFA_CANVAS_MODE_TRUECOLOR : CHAFA_CANVAS_MODE_INDEXED_240);

  const std::unique_ptr<ChafaCanvas, Release<chafa_canvas_unref>> canvas(chafa_canvas_new(config.get()));
  chafa_canvas_draw_all_pixels(canvas.get(), CHAFA_PIXEL_RGB8, image.rgb.data(), image.width, image.height,
                               3 * image.width);
  const std::unique_ptr<ChafaTermInfo, Release<chafa_term_info_unref>> terminal(
      chafa_term_db_get_fallback_info(chafa_term_db_get_default()));
  GString* const printed = chafa_canvas_print(canvas.get(), terminal.get());
  std::string text(printed->str, printed->len);
  g_string_free(printed, TRUE);
  return text;
}

}  // namespace byhand::tutor
