#include "playhouse/mesh/import/obj_text.h"

#include <algorithm>

#include "playhouse/mesh/import/trimmed.h"

namespace playhouse::mesh {
namespace {

/// Calls visit(first word, what follows it) for each line.
template <typename Visit>
void each_line(std::string_view text, const Visit& visit) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    const std::size_t word = std::min(line.find_first_of(kBlank), line.size());
    visit(line.substr(0, word), trimmed(line.substr(word)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

void add_colored(std::string_view mtl, std::set<std::string>& colored) {
  std::string material;
  each_line(mtl, [&](std::string_view word, std::string_view rest) {
    if (word == "newmtl") material = rest;
    if (word == "Kd") colored.insert(material);
  });
}

}  // namespace

ObjText look_at_obj(std::string_view name, std::string_view bytes, const FindFile& find) {
  const std::string of_name = std::string(name.substr(0, name.rfind('.'))) + ".mtl";
  ObjText text;
  std::set<std::string, std::less<>> seen;
  each_line(bytes, [&](std::string_view word, std::string_view rest) {
    if (word != "mtllib" || rest.empty() || !seen.insert(std::string(rest)).second) return;
    const std::string* mtl = find(rest);
    if (mtl == nullptr) mtl = find(of_name);
    if (mtl != nullptr) {
      add_colored(*mtl, text.colored);
    } else {
      text.missing.emplace_back(rest);
    }
  });
  return text;
}

}  // namespace playhouse::mesh
