#pragma once

#include <span>
#include <string_view>

namespace playhouse::web_server {

/// One file of the web page, embedded into the
/// program at build time. Static lifetime.
struct PageFile {
  std::string_view path;  // "/index.html"
  std::string_view content_type;
  std::string_view etag;  // quoted, weak: the same for both encodings
  std::string_view bytes;
  std::string_view gzip;  // gzip-encoded; empty if that is no smaller
};

/// The contents of web/dist at build time; empty if it was not built.
/// Defined by the library playhouse_page (web/CMakeLists.txt).
std::span<const PageFile> page_files();

}  // namespace playhouse::web_server
