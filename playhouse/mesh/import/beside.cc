#include "playhouse/mesh/import/beside.h"

#include <algorithm>
#include <charconv>

namespace playhouse::mesh {
namespace {

/// Decodes URI escapes: "a%20b" is "a b".
std::string without_escapes(std::string_view name) {
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned code = 0;
    const char* two = name.data() + i + 1;
    if (name[i] == '%' && i + 2 < name.size() && std::from_chars(two, two + 2, code, 16).ptr == two + 2) {
      plain += static_cast<char>(code);
      i += 2;
    } else {
      plain += name[i] == '\\' ? '/' : name[i];
    }
  }
  return plain;
}

bool is_below(std::string_view path) {
  if (path.empty() || path.starts_with('/') || path.find('\0') != path.npos || path.find(':') != path.npos)
    return false;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    if (path.substr(at, end - at) == "..") return false;
    at = end + 1;
  }
  return true;
}

}  // namespace

std::vector<std::string> places_beside(std::string_view name) {
  std::string path = without_escapes(name);
  while (path.starts_with("./")) path.erase(0, 2);
  std::vector<std::string> places;
  if (is_below(path)) places.push_back(path);
  const std::string last = path.substr(path.rfind('/') + 1);
  if (last != path && is_below(last)) places.push_back(last);
  return places;
}

}  // namespace playhouse::mesh
