#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace byhand::course {

/// Writes a file atomically and durably: writes a temporary file beside it, syncs it, renames it and syncs the
/// folder. Creates missing folders. Replaces a symbolic link, never the file that it names, and nothing else but
/// regular files. Throws EnvironmentError with path and reason, and then leaves an old file unchanged and no
/// temporary file.
void write_whole(const std::filesystem::path& path, std::string_view bytes);

/// The bytes of a regular file; nothing if it is missing, something else or cannot be read.
std::optional<std::string> read_whole(const std::filesystem::path& path);

/// Whether `path` is named as a temporary file of write_whole. One remains only after SIGKILL or a power failure.
bool is_unfinished(const std::filesystem::path& path);

/// Removes the temporary files that this process is writing. Safe in the handler of a signal that ends the
/// process.
void remove_unfinished() noexcept;

}  // namespace byhand::course
