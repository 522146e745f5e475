#include <limits>

#include "playhouse/base/packing.h"
#include "playhouse/replicate/delta.h"

namespace playhouse::replicate {
namespace {

class PacketReader {
 public:
  PacketReader(std::span<const std::byte> packet, const Layout& layout, Replica& replica)
      : in_(packet), layout_(layout), replica_(replica) {}

  Result<std::uint32_t> read() {
    if (in_.u8() != 1) return Error{"", "not a viewer packet"};
    const std::uint8_t flags = in_.u8();
    const std::uint64_t frame = in_.varint();
    replica_.tick = in_.varint();
    replica_.pace.paused = (flags & 1) != 0;
    replica_.pace.speed = in_.f32();
    replica_.pace.real_time_factor = in_.f32();
    section(replica_.models.size(),
            [this](std::uint8_t mask, std::uint32_t row) { model(mask, replica_.models[row]); });
    section(replica_.positions.size(),
            [this](std::uint8_t mask, std::uint32_t row) { position(mask, replica_.positions[row]); });
    section(layout_.sensors.size(), [this](std::uint8_t tag, std::uint32_t row) { scan(tag, row); });
    section(layout_.finder_model.size(), [this](std::uint8_t tag, std::uint32_t row) { finding(tag, row); });
    if (!in_.ok() || bad_)
      return Error{"",
                   bad_ ? "a viewer packet names what the scene has not" : "a viewer packet is cut short"};
    if (!in_.at_end()) return Error{"", "bytes follow a viewer packet"};
    return static_cast<std::uint32_t>(frame);
  }

 private:
  template <typename Item>
  void section(std::size_t rows, Item item) {
    std::int64_t row = 0;
    while (const std::uint8_t tag = in_.u8()) {
      row += in_.zigzag() % (std::int64_t{1} << 33);
      if (!in_.ok() || row < 0 || row >= static_cast<std::int64_t>(rows)) {
        bad_ = true;
        return;
      }
      item(tag, static_cast<std::uint32_t>(row));
      if (!in_.ok() || bad_) return;
    }
  }

  void model(std::uint8_t mask, ModelState& state) {
    if (mask & 1) add(state.x);
    if (mask & 2) add(state.y);
    if (mask & 4) add(state.z);
    if (mask & 8) turn(state.a);
    if (mask & 16) state.state = in_.u8();
    if (mask & 32) state.color = in_.u32();
  }

  void position(std::uint8_t mask, PositionState& state) {
    if (mask & 1) add(state.vx);
    if (mask & 2) add(state.vy);
    if (mask & 4) add(state.va);
    if (mask & 8) add(state.ox);
    if (mask & 16) add(state.oy);
    if (mask & 32) turn(state.oa);
  }

  void scan(std::uint8_t tag, std::uint32_t row) {
    if (tag == 2) {
      replica_.scans[row].clear();
      return;
    }
    const std::uint32_t count = layout_.sensors[row].beam_count;
    if (tag != 1 || in_.left() < 2 * std::size_t{count}) {
      bad_ = true;
      return;
    }
    std::vector<std::uint16_t>& beams = replica_.scans[row];
    beams.resize(count);
    for (std::uint16_t& beam : beams) beam = in_.u16();
  }

  void finding(std::uint8_t tag, std::uint32_t row) {
    if (tag == 2) {
      replica_.findings.erase(row);
      return;
    }
    const std::uint64_t count = in_.varint();
    if (tag != 1 || count > in_.left() / kHitBytesMin) {
      bad_ = true;
      return;
    }
    std::vector<HitState>& hits = replica_.findings[row];
    hits.resize(count);
    for (HitState& hit : hits) {
      hit.target = static_cast<std::uint32_t>(in_.varint());
      hit.id = static_cast<std::int32_t>(in_.zigzag());
      hit.range = static_cast<std::int32_t>(in_.varint());
      hit.bearing = in_.u16();
      hit.heading = in_.u16();
    }
  }

  void add(std::int32_t& value) {
    const std::int64_t sum = value + in_.zigzag() % (std::int64_t{1} << 33);
    if (sum < std::numeric_limits<std::int32_t>::min() || sum > std::numeric_limits<std::int32_t>::max()) {
      bad_ = true;
    } else {
      value = static_cast<std::int32_t>(sum);
    }
  }

  void turn(std::uint16_t& angle) {
    angle = static_cast<std::uint16_t>(angle + static_cast<std::uint16_t>(in_.zigzag() & 0xFFFF));
  }

  static constexpr std::size_t kHitBytesMin = 7;

  Unpacker in_;
  const Layout& layout_;
  Replica& replica_;
  bool bad_ = false;
};

}  // namespace

Result<std::uint32_t> apply_packet(std::span<const std::byte> packet, const Layout& layout,
                                   Replica& replica) {
  return PacketReader(packet, layout, replica).read();
}

}  // namespace playhouse::replicate
