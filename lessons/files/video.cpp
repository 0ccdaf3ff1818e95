#include "lessons/files/video.hpp"

#include <fmt/format.h>
#include <glib.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <vector>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/printed_by.hpp"
#include "lessons/page/error.hpp"

namespace byhand::course {
namespace {

/// A file of its own in the folder for temporary files, removed at the end.
class TemporaryFile {
 public:
  TemporaryFile() {
    GError* error = nullptr;
    char* name = nullptr;
    const int descriptor = g_file_open_tmp("byhand-film-XXXXXX", &name, &error);
    if (descriptor < 0) {
      const std::string why = error->message;
      g_error_free(error);
      throw EnvironmentError("A film needs a temporary file: " + why + ".");
    }
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
  std::string pattern;  // in which % stands for itself
  for (const char c : frames.string()) pattern += c == '%' ? "%%" : std::string(1, c);
  std::vector<std::string> words = {
      "-loglevel", "error", "-nostdin", "-y", "-framerate", fmt::format("{}", rate), "-i", pattern + "/%04d.png",
      // One thread and no dates or versions: the same bytes.
      "-threads", "1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-pix_fmt", "yuv420p", "-f", format};
  const std::vector<std::string> codec =
      format == "webm"
          ? std::vector<std::string>{"-c:v", "libvpx-vp9", "-crf", "32", "-b:v", "0", "-cpu-used", "5"}
          : std::vector<std::string>{"-c:v", "libx264", "-crf", "23", "-movflags", "+faststart"};
  words.insert(words.end(), codec.begin(), codec.end());
  words.push_back(film.path);
  printed_by(ffmpeg.get(), words);
  const auto bytes = read_whole(film.path);
  if (!bytes || bytes->empty()) throw EnvironmentError(fmt::format("ffmpeg made no film of {}.", frames.string()));
  return *bytes;
}

}  // namespace byhand::course
