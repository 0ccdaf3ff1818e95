#include "lessons/tutor/place.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "renderer/error.hpp"
#include "renderer/file.hpp"

namespace byhand::tutor {
namespace {

namespace fs = std::filesystem;

/// Empty when there is no home to keep it in.
fs::path place_file(const std::string& slug) {
  const char* const state = std::getenv("XDG_STATE_HOME");
  const char* const home = std::getenv("HOME");
  fs::path folder;
  // The XDG base directory specification asks to ignore relative paths.
  if (state && fs::path(state).is_absolute())
    folder = state;
  else if (home && *home)
    folder = fs::path(home) / ".local" / "state";
  else
    return {};
  return folder / "constraints-by-hand" / (slug + ".json");
}

}  // namespace

Place read_place(const std::string& slug) {
  std::ifstream file(place_file(slug));
  const auto json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object()) return {};
  Place place;
  if (const auto step = json.find("step"); step != json.end() && step->is_string()) place.step = *step;
  if (const auto finished = json.find("finished"); finished != json.end() && finished->is_boolean())
    place.finished = *finished;
  return place;
}

bool keep_place(const std::string& slug, const Place& place) {
  const fs::path file = place_file(slug);
  if (file.empty()) return false;
  try {
    renderer::write_whole(
        file, nlohmann::ordered_json{{"step", place.step}, {"finished", place.finished}}.dump() + "\n");
  } catch (const renderer::EnvironmentError&) {
    return false;
  }
  return true;
}

}  // namespace byhand::tutor
