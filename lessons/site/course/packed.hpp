#pragma once

#include <filesystem>
#include <string>

namespace byhand::site {

/// A script that hands JSON to a function of site.js, compressed.
std::string packed_script(const std::string& receiver, const std::string& json);

/// Packs what narrow pages show: each narrow.json in the site, the pictures by the ids of their figures, becomes a
/// script that hands it to site.js compressed. A page that was opened from the disk may read no other file.
void pack_narrow_pictures(const std::filesystem::path& site);

}  // namespace byhand::site
