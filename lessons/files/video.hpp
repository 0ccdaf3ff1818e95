#pragma once

#include <filesystem>
#include <string>

namespace byhand::course {

/// The film of the frames 0000.png, 0001.png, … of a folder at `rate` frames per second, encoded by ffmpeg;
/// `format`: webm (VP9) or mp4 (H.264). The same frames give the same bytes. Throws EnvironmentError if
/// ffmpeg is missing or fails.
std::string encoded_film(const std::filesystem::path& frames, double rate, const std::string& format);

}  // namespace byhand::course
