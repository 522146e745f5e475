#include "playhouse/replicate/drawing_code.h"

#include <cstddef>
#include <cstdint>

namespace playhouse::replicate {
namespace {

constexpr std::uint8_t kFlat = 4, kMostCorners = 3;  // added to the number of corners of a shape; of a shape

/// The corners at its begin that are alike.
std::span<const SentCorner> run_of(std::span<const SentCorner> drawing) {
  std::size_t count = 1;
  while (count < drawing.size() && drawing[count].color == drawing[0].color &&
         drawing[count].corners == drawing[0].corners && drawing[count].flat == drawing[0].flat)
    ++count;
  return drawing.first(count);
}

std::uint64_t runs_of(std::span<const SentCorner> drawing) {
  std::uint64_t runs = 0;
  for (; !drawing.empty(); drawing = drawing.subspan(run_of(drawing).size())) ++runs;
  return runs;
}

/// Modulo 2^32, as the page computes it.
std::int32_t difference(std::int32_t to, std::int32_t from) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from));
}
std::int32_t sum(std::int32_t from, std::int64_t by) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(from) + static_cast<std::uint32_t>(by));
}

}  // namespace

void write_drawing(std::span<const SentCorner> drawing, Packer& pack) {
  pack.varint(runs_of(drawing));
  SentCorner before;
  while (!drawing.empty()) {
    const std::span<const SentCorner> run = run_of(drawing);
    pack.u8(static_cast<std::uint8_t>(run[0].corners + (run[0].flat ? kFlat : 0)));
    pack.u32(run[0].color);
    pack.varint(run.size() / run[0].corners);
    for (const SentCorner& corner : run) {
      pack.zigzag(difference(corner.x, before.x));
      pack.zigzag(difference(corner.y, before.y));
      pack.zigzag(difference(corner.z, before.z));
      before = corner;
    }
    drawing = drawing.subspan(run.size());
  }
}

std::optional<std::vector<SentCorner>> read_drawing(Unpacker& in) {
  std::vector<SentCorner> drawing;
  SentCorner corner;
  for (std::uint64_t runs = in.varint(); runs > 0 && in.ok(); --runs) {
    const std::uint8_t form = in.u8();
    corner.corners = form % kFlat;
    corner.flat = form >= kFlat;
    corner.color = in.u32();
    const std::uint64_t shapes = in.varint();
    const bool is_possible = corner.corners != 0 && form <= kFlat + kMostCorners && shapes <= in.left();
    if (!in.ok() || !is_possible) return std::nullopt;
    for (std::uint64_t left = shapes * corner.corners; left > 0 && in.ok(); --left) {
      corner.x = sum(corner.x, in.zigzag());
      corner.y = sum(corner.y, in.zigzag());
      corner.z = sum(corner.z, in.zigzag());
      drawing.push_back(corner);
    }
  }
  if (!in.ok()) return std::nullopt;
  return drawing;
}

}  // namespace playhouse::replicate
