#include "playhouse/mesh/packed.h"

#include <cstring>
#include <type_traits>

#include "playhouse/base/packing.h"

namespace playhouse::mesh {
namespace {

/// Counts the bytes of what each() below visits, at most, so that Out grows once.
class Size {
 public:
  template <typename T>
  requires std::is_trivially_copyable_v<T>
  void operator()(const T& value) { bytes_ += sizeof value; }
  void operator()(const std::string& text) { bytes_ += kCount + text.size(); }
  template <typename T>
  void operator()(const std::vector<T>& list) {
    bytes_ += kCount;
    if constexpr (std::is_trivially_copyable_v<T>) {
      bytes_ += list.size() * sizeof(T);
    } else {
      for (const T& one : list) each(*this, one);
    }
  }
  template <typename T>
  void operator()(const std::optional<T>& value) {
    bytes_ += 1;
    if (value) each(*this, *value);
  }
  std::size_t bytes() const { return bytes_; }

 private:
  static constexpr std::size_t kCount = 10;  // of a varint
  std::size_t bytes_ = 0;
};

/// Writes what each() below visits.
class Out {
 public:
  explicit Out(std::vector<std::byte>& bytes) : out_(bytes), bytes_(bytes) {}

  template <typename T>
  requires std::is_trivially_copyable_v<T>
  void operator()(const T& value) {
    const auto raw = std::as_bytes(std::span(&value, 1));
    bytes_.insert(bytes_.end(), raw.begin(), raw.end());
  }
  void operator()(const std::string& text) { out_.text(text); }
  template <typename T>
  void operator()(const std::vector<T>& list) {
    out_.varint(list.size());
    if constexpr (std::is_trivially_copyable_v<T>) {
      const auto raw = std::as_bytes(std::span(list));
      bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    } else {
      for (const T& one : list) each(*this, one);
    }
  }
  template <typename T>
  void operator()(const std::optional<T>& value) {
    out_.u8(value ? 1 : 0);
    if (value) each(*this, *value);
  }

 private:
  Packer out_;
  std::vector<std::byte>& bytes_;
};

/// Deserialiser for each() below.
class In {
 public:
  explicit In(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <typename T>
  requires std::is_trivially_copyable_v<T>
  void operator()(T& value) { take(&value, sizeof value); }
  void operator()(std::string& text) {
    text.resize(count(1));
    take(text.data(), text.size());
  }
  template <typename T>
  void operator()(std::vector<T>& list) {
    list.resize(count(std::is_trivially_copyable_v<T> ? sizeof(T) : 1));
    if constexpr (std::is_trivially_copyable_v<T>) {
      take(list.data(), list.size() * sizeof(T));
    } else {
      for (T& one : list) each(*this, one);
    }
  }
  template <typename T>
  void operator()(std::optional<T>& value) {
    std::uint8_t is_there = 0;
    (*this)(is_there);
    if (is_there != 0) each(*this, value.emplace());
  }
  bool is_whole() const { return ok_ && bytes_.empty(); }

 private:
  /// Element count, bounded by the bytes left, for elements of at least this size.
  std::size_t count(std::size_t bytes_each) {
    Unpacker in(bytes_);
    const std::uint64_t count = in.varint();
    ok_ = ok_ && in.ok() && count <= in.left() / bytes_each;
    bytes_ = bytes_.last(in.left());
    return ok_ ? static_cast<std::size_t>(count) : 0;
  }
  void take(void* to, std::size_t bytes) {
    ok_ = ok_ && bytes <= bytes_.size();
    if (!ok_ || bytes == 0) return;
    std::memcpy(to, bytes_.data(), bytes);
    bytes_ = bytes_.subspan(bytes);
  }

  std::span<const std::byte> bytes_;
  bool ok_ = true;
};

// Members of each type, for both directions.

template <typename Visit, typename T>
requires std::is_same_v<std::remove_const_t<T>, std::string> || std::is_same_v < std::remove_const_t<T>,
double > void each(Visit& visit, T& value) {
  visit(value);
}
template <typename Visit, typename T>
requires std::is_same_v<std::remove_const_t<T>, Image>
void each(Visit& visit, T& image) {
  visit(image.width), visit(image.height), visit(image.rgba);
}
template <typename Visit, typename T>
requires std::is_same_v<std::remove_const_t<T>, Material>
void each(Visit& visit, T& material) {
  visit(material.name), visit(material.base), visit(material.metallic), visit(material.roughness);
  visit(material.emission), visit(material.texture), visit(material.opacity);
  visit(material.least_opacity), visit(material.is_two_sided);
}
template <typename Visit, typename T>
requires std::is_same_v<std::remove_const_t<T>, Surface>
void each(Visit& visit, T& surface) {
  visit(surface.material), visit(surface.p), visit(surface.normal), visit(surface.uv), visit(surface.corners);
}
template <typename Visit, typename T>
requires std::is_same_v<std::remove_const_t<T>, CollisionShape>
void each(Visit& visit, T& shape) {
  visit(shape.kind), visit(shape.p), visit(shape.q), visit(shape.half), visit(shape.points),
      visit(shape.corners);
}
template <typename Visit, typename T>
requires std::is_same_v<std::remove_const_t<T>, PhysicalProperties>
void each(Visit& visit, T& physics) {
  visit(physics.shapes), visit(physics.mass), visit(physics.friction), visit(physics.restitution);
  visit(physics.is_fixed);
}
template <typename Visit, typename T>
requires std::is_same_v<std::remove_const_t<T>, MeshFile>
void each(Visit& visit, T& file) {
  auto& mesh = file.mesh;
  visit(mesh.surfaces), visit(mesh.materials), visit(mesh.images), visit(mesh.lights), visit(mesh.physics);
  visit(mesh.low), visit(mesh.high), visit(file.warnings);
}

}  // namespace

std::vector<std::byte> packed(const MeshFile& file) {
  Size size;
  each(size, file);
  std::vector<std::byte> bytes;
  bytes.reserve(size.bytes());
  Out out(bytes);
  each(out, file);
  return bytes;
}

std::optional<MeshFile> unpacked(std::span<const std::byte> bytes) {
  MeshFile file;
  In in(bytes);
  each(in, file);
  if (!in.is_whole()) return std::nullopt;
  return file;
}

}  // namespace playhouse::mesh
