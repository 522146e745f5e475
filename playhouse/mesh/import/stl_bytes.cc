#include "playhouse/mesh/import/stl_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include "playhouse/base/mesh_limits.h"
#include "playhouse/mesh/import/trimmed.h"

namespace playhouse::mesh {
namespace {

constexpr std::size_t kHeader = 80, kStart = kHeader + 4;  // bytes; then the triangles
constexpr std::size_t kNormal = 12, kPoint = 12, kEnd = 2, kTriangle = kNormal + 3 * kPoint + kEnd;

Error too_many() {
  return {{}, fmt::format("has too many triangles: up to {} are possible", limits::kMeshTriangles)};
}

/// Writes plain_stl() triangle by triangle.
class Plain {
 public:
  void add(std::string_view points) {
    bytes_.append(kNormal, '\0').append(points).append(kEnd, '\0');
    ++count_;
  }
  std::uint32_t count() const { return count_; }
  Result<std::string> take() {
    if (count_ == 0) return Error{{}, "has no triangles"};
    std::memcpy(bytes_.data() + kHeader, &count_, sizeof count_);
    return std::move(bytes_);
  }

 private:
  std::string bytes_ = std::string(kStart, '\0');
  std::uint32_t count_ = 0;
};

/// The number of triangles that a binary file tells; none in one that is too short to tell.
std::optional<std::uint32_t> told_count(std::string_view bytes) {
  if (bytes.size() < kStart) return std::nullopt;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeader, sizeof count);
  return count;
}

Result<std::string> from_binary(std::string_view bytes, std::uint32_t count) {
  if (count > limits::kMeshTriangles) return too_many();
  Plain plain;
  for (std::size_t i = 0; i < count; ++i)
    plain.add(bytes.substr(kStart + i * kTriangle + kNormal, 3 * kPoint));
  return plain.take();
}

/// The words of an ASCII file.
class Text {
 public:
  explicit Text(std::string_view bytes) : rest_(bytes) {}

  /// The next word, in lower case; empty at the end.
  std::string word() {
    while (!rest_.empty() && kBlank.find(rest_.front()) != std::string_view::npos) {
      line_ += rest_.front() == '\n' ? 1 : 0;
      rest_.remove_prefix(1);
    }
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlank));
    rest_.remove_prefix(word.size());
    return lower(word);
  }
  std::optional<float> number() {
    const std::string text = word();
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* const end = text.data() + text.size();
    double value = 0;
    const auto [stop, fault] = std::from_chars(begin, end, value);
    if (stop != end || fault != std::errc()) return std::nullopt;
    constexpr double kMost = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -kMost, kMost));
  }
  /// The name behind `solid` may be any words.
  void skip_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }
  Error broken(std::string_view why) const {
    return {{}, fmt::format("is broken in line {}: {}", line_, why)};
  }

 private:
  std::string_view rest_;
  std::size_t line_ = 1;
};

/// Everything but corners and the ends of triangles and solids can be skipped.
Result<std::string> from_text(std::string_view bytes) {
  Text text(bytes);
  Plain plain;
  std::string points;
  bool is_open = false;
  for (std::string word = text.word(); !word.empty(); word = text.word()) {
    if (word == "solid" || word == "endsolid") {
      is_open = word == "solid";
      text.skip_line();
    } else if (word == "vertex") {
      for (int i = 0; i < 3; ++i) {
        const std::optional<float> value = text.number();
        if (!value) return text.broken("a vertex needs three numbers");
        points.append(reinterpret_cast<const char*>(&*value), sizeof *value);
      }
    } else if (word == "endloop") {
      if (points.size() != 3 * kPoint) return text.broken("a triangle needs three vertices");
      if (plain.count() == limits::kMeshTriangles) return too_many();
      plain.add(points);
      points.clear();
    }
  }
  if (is_open || !points.empty()) return text.broken("it ends before its endsolid");
  return plain.take();
}

}  // namespace

bool is_stl(std::string_view path) {
  return lower(path).ends_with(".stl");
}

Result<std::string> plain_stl(std::string_view bytes) {
  // A binary file may begin with "solid", too; the text of an ASCII one, read as a count, is far too large.
  const std::optional<std::uint32_t> count = told_count(bytes);
  if (count && kStart + std::uint64_t{kTriangle} * *count <= bytes.size()) return from_binary(bytes, *count);
  if (constexpr std::string_view kMark = "\xEF\xBB\xBF"; bytes.starts_with(kMark))
    bytes.remove_prefix(kMark.size());
  if (Text(bytes).word() == "solid" && bytes.find('\0') == std::string_view::npos) return from_text(bytes);
  if (!count) return Error{{}, "is not a valid STL: it is not an ASCII one, and too short for a binary one"};
  return Error{
      {},
      fmt::format(
          "is broken: it is not an ASCII STL, and a binary one of {} triangles has {} bytes, found {}",
          *count, kStart + std::uint64_t{kTriangle} * *count, bytes.size())};
}

}  // namespace playhouse::mesh
