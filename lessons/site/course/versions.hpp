#pragma once

#include <filesystem>

namespace byhand::site {

/// Gives every script and style sheet that a page of the site loads the beginning of its SHA-256,
/// "site.js?v=3f2a9c01", so that a browser which keeps files never mixes those of two versions.
void write_versions(const std::filesystem::path& site);

}  // namespace byhand::site
