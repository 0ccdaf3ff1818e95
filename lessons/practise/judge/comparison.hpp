#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/practise/judge/film.hpp"
#include "renderer/canvas.hpp"

namespace byhand::practise {

/// The learner's film beside the right one, at frame `index`. A film that was cut short keeps its last frame.
void draw(renderer::Canvas& canvas, const Film& yours, const Film& right, int index);

/// Four instants of both, one row a film.
void draw_instants(renderer::Canvas& canvas, const Film& yours, const Film& right,
                   const std::vector<int>& instants);

/// How many frames tell a film: until a little after a body has left what is seen for good.
int frames_that_tell(const Film& yours, const Film& right);

/// Four instants as the bytes of a PNG.
std::string still_png(const Film& yours, const Film& right);

/// Writes the film as `<folder>/0000.png`, ….
void write_film(const std::filesystem::path& folder, const Film& yours, const Film& right);

}  // namespace byhand::practise
