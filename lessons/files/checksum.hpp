#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace byhand::course {

/// SHA-256 of the bytes as 64 hexadecimal digits, as `sha256sum` prints it.
std::string sha256(std::string_view bytes);
/// The same of a regular file, of any size, in little memory; "" for one that cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace byhand::course
