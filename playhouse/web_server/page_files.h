#pragma once

#include <span>
#include <string_view>

namespace playhouse::web_server {

/// One file of the built web page, as the build put it into the program. Everything lives as long as the
/// program.
struct PageFile {
  std::string_view path;  // "/index.html"
  std::string_view content_type;
  std::string_view etag;  // quoted, and weak: of the file, compressed or not
  std::string_view bytes;
  std::string_view gzip;  // the same, compressed; empty when that saves nothing
};

/// The page in web/dist at the time of the build; empty when it was not built. Defined by the library
/// playhouse_page (web/CMakeLists.txt).
std::span<const PageFile> page_files();

}  // namespace playhouse::web_server
