#pragma once

#include <filesystem>

namespace byhand::site {

/// Packs what narrow pages show: each narrow.json in the site, the pictures by the ids of their figures, becomes a
/// script that hands it to site.js compressed. A page that was opened from the disk may read no other file.
void pack_narrow_pictures(const std::filesystem::path& site);

}  // namespace byhand::site
