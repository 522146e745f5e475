#include "playhouse/mesh/gltf_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>

#include "playhouse/base/in_quotes.h"

namespace playhouse::mesh {
namespace {

constexpr std::array<std::string_view, 2> kRead{"KHR_draco_mesh_compression", "KHR_lights_punctual"};
/// Optional material extensions, which may be ignored, except the one that replaces the whole material.
constexpr std::string_view kOfMaterials = "KHR_materials_", kAllLook = "KHR_materials_pbrSpecularGlossiness";

bool is_read(std::string_view extension) {
  if (extension.starts_with(kOfMaterials)) return extension != kAllLook;
  return std::ranges::find(kRead, extension) != kRead.end();
}

/// The JSON of a file: the whole text, or the first chunk of a binary.
std::string_view json_of(std::string_view bytes) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  if (!bytes.starts_with("glTF")) return bytes;
  if (bytes.size() < kHeader + kChunkHeader) return {};
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + kHeader, sizeof size);
  return bytes.substr(kHeader + kChunkHeader, size);
}

/// A minimal JSON scanner that tracks nesting only.
class Walk {
 public:
  explicit Walk(std::string_view json) : rest_(json) {}

  /// The next string, unescaped; none if a structural mark comes first, which is consumed.
  std::optional<std::string_view> text_or_mark() {
    mark_ = 0;
    rest_.remove_prefix(std::min(rest_.find_first_of("\"[]{}:"), rest_.size()));
    if (rest_.empty()) return std::nullopt;
    const char first = rest_.front();
    rest_.remove_prefix(1);
    if (first != '"') {
      mark_ = first;
      depth_ += first == '[' || first == '{' ? 1 : first == ']' || first == '}' ? -1 : 0;
      return std::nullopt;
    }
    std::size_t end = 0;
    while (end < rest_.size() && rest_[end] != '"') end += rest_[end] == '\\' ? 2 : 1;
    end = std::min(end, rest_.size());
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return text;
  }
  char mark() const { return mark_; }
  int depth() const { return depth_; }
  bool is_at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
  char mark_ = 0;
  int depth_ = 0;
};

}  // namespace

std::vector<std::string> gltf_list(std::string_view bytes, std::string_view key) {
  std::vector<std::string> list;
  Walk walk(json_of(bytes));
  bool is_key = false;
  while (!walk.is_at_end()) {
    const std::optional<std::string_view> text = walk.text_or_mark();
    if (text) is_key = walk.depth() == 1 && *text == key;
    if (!is_key || text || walk.mark() != '[' || walk.depth() != 2) continue;
    while (!walk.is_at_end() && walk.mark() != ']')
      if (const auto one = walk.text_or_mark()) list.emplace_back(*one);
    return list;
  }
  return list;
}

Result<void> check_gltf_extensions(std::string_view bytes) {
  for (const std::string& name : gltf_list(bytes, "extensionsRequired"))
    if (!is_read(name))
      return Error{{}, fmt::format("needs the glTF extension {}, which is not read", in_quotes(name))};
  return {};
}

}  // namespace playhouse::mesh
