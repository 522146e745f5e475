#include "playhouse/mesh/import/gltf_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/mesh_limits.h"

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

  /// The next string, as it is written; none if a structural mark comes first, which is consumed.
  std::optional<std::string_view> text_or_mark() {
    mark_ = 0;
    skipped_ = rest_.substr(0, rest_.find_first_of("\"[]{}:"));
    rest_.remove_prefix(skipped_.size());
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
  /// What was before it: numbers, commas, white space.
  std::string_view skipped() const { return skipped_; }
  int depth() const { return depth_; }
  bool is_at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_, skipped_;
  char mark_ = 0;
  int depth_ = 0;
};

/// True if a string, as it is written, is this word of ASCII letters.
bool says(std::string_view text, std::string_view word) {
  constexpr std::size_t kEscape = 6;  // as of "\u0061"
  for (const char letter : word) {
    if (text.starts_with("\\u") && text.size() >= kEscape) {
      unsigned code = 0;
      const char* const end = text.data() + kEscape;
      if (std::from_chars(text.data() + 2, end, code, 16).ptr != end || code != static_cast<unsigned>(letter))
        return false;
      text.remove_prefix(kEscape);
    } else if (text.starts_with(letter)) {
      text.remove_prefix(1);
    } else {
      return false;
    }
  }
  return text.empty();
}

using Rows = std::vector<std::uint32_t>;

void add_rows(std::string_view text, Rows& rows) {
  for (std::size_t at = 0; (at = text.find_first_of("0123456789", at)) != text.npos;) {
    std::uint32_t row = 0;
    const auto read = std::from_chars(text.data() + at, text.data() + text.size(), row);
    if (read.ec == std::errc()) rows.push_back(row);
    at = static_cast<std::size_t>(read.ptr - text.data());
  }
}

/// The numbers in the array `key` of each object of a top-level array, by the object's place in it. What is
/// there twice is taken together: a reader that takes either has no more.
std::vector<Rows> rows_of_each(std::string_view json, std::string_view list, std::string_view key) {
  constexpr int kTop = 1, kList = 2, kObject = 3, kArray = 4;  // depths
  std::vector<Rows> rows;
  std::size_t row = 0;
  bool is_list = false, is_key = false;
  for (Walk walk(json); !walk.is_at_end();) {
    const int depth = walk.depth();
    const auto text = walk.text_or_mark();
    if (is_list && depth == kList) row += static_cast<std::size_t>(std::ranges::count(walk.skipped(), ','));
    if (is_list && is_key && depth == kArray && row < rows.size()) add_rows(walk.skipped(), rows[row]);
    if (text) {
      if (depth == kTop) is_list = says(*text, list);
      if (depth == kObject) is_key = says(*text, key);
    } else if (is_list && walk.mark() == '[' && walk.depth() == kList) {
      row = 0;
    } else if (is_list && walk.mark() == '{' && walk.depth() == kObject) {
      rows.resize(std::max(rows.size(), row + 1));
      is_key = false;
    }
  }
  return rows;
}

/// Nodes below these, once for every path; no more than `most` of them are looked at.
std::size_t nodes_below(const std::vector<Rows>& children, const Rows& roots, std::size_t most) {
  Rows open = roots;
  std::size_t count = open.size();
  while (!open.empty() && count <= most) {
    const std::uint32_t next = open.back();
    open.pop_back();
    if (next >= children.size()) continue;
    count += children[next].size();
    open.insert(open.end(), children[next].begin(), children[next].end());
  }
  return count;
}

}  // namespace

std::vector<std::string> gltf_list(std::string_view bytes, std::string_view key) {
  std::vector<std::string> list;
  Walk walk(json_of(bytes));
  bool is_key = false;
  while (!walk.is_at_end()) {
    const std::optional<std::string_view> text = walk.text_or_mark();
    if (text) is_key = walk.depth() == 1 && says(*text, key);
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

Result<void> check_gltf_nodes(std::string_view bytes) {
  const std::string_view json = json_of(bytes);
  const std::vector<Rows> children = rows_of_each(json, "nodes", "children");
  for (const Rows& roots : rows_of_each(json, "scenes", "nodes"))
    if (nodes_below(children, roots, limits::kMeshNodes) > limits::kMeshNodes)
      return Error{{}, fmt::format("has too many nodes: up to {} are possible", limits::kMeshNodes)};
  return {};
}

}  // namespace playhouse::mesh
