#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace byhand::site {

/// A ZIP archive, the same bytes for the same files: entries in the order in which they were added, without dates,
/// for all to read.
class Zip {
 public:
  enum class Store { compressed, as_it_is };
  /// `runs`: it may be executed where it is unpacked.
  void add(const std::string& name, std::string_view bytes, Store store = Store::compressed, bool runs = false);
  /// The archive. Nothing can be added afterwards.
  std::string finish();

 private:
  std::string archive_, directory_;
  int entries_ = 0;
};

/// Compressed as DEFLATE (RFC 1951); empty if the bytes do not become fewer.
std::string deflated(std::string_view bytes);

/// All files below a folder as an archive, in the order of their paths. What its owner may execute there may be
/// executed where it is unpacked.
std::string zip_of(const std::filesystem::path& folder);

}  // namespace byhand::site
