#pragma once

#include <list>
#include <map>
#include <memory>
#include <string>

#include "lessons/page/html/seekable_film.hpp"
#include "lessons/page/lesson.hpp"
#include "lessons/page/recording.hpp"
#include "renderer/svg_canvas.hpp"

namespace byhand::site {

/// What draws scenes in space: as a page has them, and with fewer pixels, for a picture that soon is another.
struct DrawWindows {
  renderer::SvgCanvas::DrawWindow full = {}, small = {};
};

/// A lesson that answers the requests of its page, as JSON. Every request may carry the parameters that differ
/// from their defaults, as a reader types them: "settings": {"beta": "1.9"}.
///
///     {"ask": "describe"}                              {"parameters": […], "steps": [{"label", "title"}, …]}
///     {"ask": "check"}                                 {"typed": {"beta": "1.9"}}
///     {"ask": "tell", "step": "3a"}                    {"html": "<section …", "reads": ["beta", "h"]}
///     {"ask": "frame", "step": "3a", "film": "stems", "index": 7}         {"svg": "<svg …"}
///     {"ask": "grade", "step": "3a", "question": 1, "typed": "0.2 m"}     {"right", "understood", "reply"}
///
///     {"ask": "hold", "step": "1", "acts": [["grab", 480, 300], ["step", 2], ["release"]]}
///         {"svg", "bodies": [{"name", "x", "y", "reach"}, …], "held", "h", "parts", "words", "stopped"}
///
/// "tell" and "frame" with "small": true draw what is in space with fewer pixels, and any request with "narrow":
/// true is about pictures for a narrow page.
///
/// The scene that a step offers to hold goes on from one request to the next. Its acts are grab and move (to a
/// point of its picture, y down), release, step (so many) and reset; "part": 2.5 draws it within its next step
/// (see course::Held). A value that is refused is answered by {"refused": the lesson's sentence, "parameter":
/// "beta"}, what cannot be answered by {"error": "…"}.
class Program {
 public:
  /// `draw_windows` draws what its pictures show in space.
  explicit Program(course::Lesson lesson, DrawWindows draw_windows = {})
      : lesson_(std::move(lesson)), draw_windows_(std::move(draw_windows)) {}
  std::string answer(const std::string& request);

 private:
  struct Told {
    std::string settings;  // at which it was told
    course::RecordedStep recorded;
    std::map<std::string, SeekableFilm> films = {};
    std::string html = {};  // with pictures of `width`; empty before any are drawn
    int width = 0;
    bool small = false;  // what is in space was drawn so
  };

  /// The scene that a reader holds, at the settings for which it was made.
  struct InHand {
    std::string settings = {};
    std::unique_ptr<course::Held> scene = {};
  };

  void apply(const std::map<std::string, std::string>& settings);
  const course::Step& step(const std::string& label) const;
  std::string settings() const;
  /// The step at the present settings, told now unless it was one of the latest.
  Told& told(const course::Step& step);
  /// Draws its pictures, unless they are there; `small`: those that were drawn so will do.
  void draw(Told& told, int width, bool small) const;
  const renderer::SvgCanvas::DrawWindow& draw_window(bool small) const {
    return small ? draw_windows_.small : draw_windows_.full;
  }
  /// The scene of the step at the present settings.
  course::Held& in_hand(const course::Step& step);

  course::Lesson lesson_;
  DrawWindows draw_windows_;
  std::map<std::string, std::list<Told>> told_;  // by the label of the step, the latest first
  std::map<std::string, InHand> in_hand_;        // by the label of the step
};

}  // namespace byhand::site
