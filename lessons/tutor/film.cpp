#include "lessons/tutor/film.hpp"

#include <fmt/format.h>
#include <glib.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <vector>

#include "renderer/error.hpp"
#include "renderer/file.hpp"

namespace byhand::tutor {
namespace {

using renderer::EnvironmentError;

std::string taken(GError* error) {
  const std::string why = error->message;
  g_error_free(error);
  return why;
}

/// A file of its own in the folder for temporary files, removed at the end.
class TemporaryFile {
 public:
  TemporaryFile() {
    GError* error = nullptr;
    char* name = nullptr;
    const int descriptor = g_file_open_tmp("byhand-film-XXXXXX", &name, &error);
    if (descriptor < 0) throw EnvironmentError("A film needs a temporary file: " + taken(error) + ".");
    close(descriptor);
    path = name;
    g_free(name);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::remove(path.c_str()); }

  std::string path;
};

}  // namespace

std::string encoded_film(const std::filesystem::path& frames, double rate, const std::string& format) {
  const std::unique_ptr<char, decltype(&g_free)> ffmpeg(g_find_program_in_path("ffmpeg"), g_free);
  if (!ffmpeg) throw EnvironmentError("Films need ffmpeg: apt install ffmpeg, or leave out --film.");
  const TemporaryFile film;
  std::vector<std::string> words = {ffmpeg.get(), "-loglevel", "error", "-nostdin", "-y", "-framerate",
                                    fmt::format("{}", rate), "-i", (frames / "%04d.png").string(),
                                    // One thread and no dates or versions: the same bytes.
                                    "-threads", "1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-pix_fmt",
                                    "yuv420p", "-f", format};
  const std::vector<std::string> codec =
      format == "webm"
          ? std::vector<std::string>{"-c:v", "libvpx-vp9", "-crf", "32", "-b:v", "0", "-cpu-used", "5"}
          : std::vector<std::string>{"-c:v", "libx264", "-crf", "23", "-movflags", "+faststart"};
  words.insert(words.end(), codec.begin(), codec.end());
  words.push_back(film.path);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  GError* error = nullptr;
  int status = 0;
  char* complaint = nullptr;
  g_spawn_sync(nullptr, arguments.data(), nullptr, G_SPAWN_STDOUT_TO_DEV_NULL, nullptr, nullptr, nullptr,
               &complaint, &status, &error);
  const std::unique_ptr<char, decltype(&g_free)> said(complaint, g_free);
  if (error) throw EnvironmentError("ffmpeg cannot be started: " + taken(error) + ".");
  const auto bytes = renderer::read_whole(film.path);
  if (status != 0 || !bytes || bytes->empty())
    throw EnvironmentError(fmt::format("ffmpeg made no film of {}: {}", frames.string(), said ? said.get() : ""));
  return *bytes;
}

}  // namespace byhand::tutor
