#include "playhouse/base/packing.h"
#include "playhouse/replicate/delta.h"
#include "playhouse/replicate/drawing_code.h"
#include "playhouse/replicate/row_code.h"

namespace playhouse::replicate {
namespace {

class PacketReader {
 public:
  PacketReader(std::span<const std::byte> packet, Replica& replica)
      : in_(packet), layout_(*replica.layout), replica_(replica) {}

  Result<std::uint32_t> read() {
    if (in_.u8() != packet::kFirst) return Error{"", "not a viewer packet"};
    const std::uint8_t flags = in_.u8();
    const std::uint64_t frame = in_.varint();
    replica_.tick = in_.varint();
    replica_.pace.paused = (flags & packet::kPaused) != 0;
    replica_.pace.speed = in_.f32();
    replica_.pace.real_time_factor = in_.f32();
    section([this](std::uint8_t mask, world::ModelRow row) { model(mask, replica_.models[row]); });
    section([this](std::uint8_t tag, world::ModelRow row) { say(tag, row); });
    section([this](std::uint8_t tag, world::ModelRow row) { scan(tag, row); });
    section([this](std::uint8_t tag, world::ModelRow row) { view(tag, row); });
    section([this](std::uint8_t tag, world::ModelRow row) { drawing(tag, row); });
    if (!in_.ok() || bad_)
      return Error{"",
                   bad_ ? "a viewer packet names what the scene has not" : "a viewer packet is cut short"};
    if (!in_.at_end()) return Error{"", "bytes follow a viewer packet"};
    return static_cast<std::uint32_t>(frame);
  }

 private:
  template <typename Item>
  void section(Item item) {
    std::int64_t id = 0;
    for (std::uint8_t tag = in_.u8(); tag != packet::kEnd; tag = in_.u8()) {
      id += in_.zigzag() % (std::int64_t{1} << 33);
      const bool fits = in_.ok() && id >= 0 && id < world::ModelId::kNone;
      const world::ModelRow row = fits ? layout_.row({static_cast<std::uint32_t>(id)}) : world::ModelRow{};
      if (!row) {
        bad_ = true;
        return;
      }
      item(tag, row);
      if (!in_.ok() || bad_) return;
    }
  }

  void model(std::uint8_t mask, ModelState& state) {
    if (!read_fields(mask, in_, state)) bad_ = true;
  }

  void say(std::uint8_t tag, world::ModelRow model) {
    std::string text = in_.text();
    if (tag != packet::kFresh) {
      bad_ = true;
    } else if (text.empty()) {
      replica_.says.erase(model);
    } else {
      replica_.says[model] = std::move(text);
    }
  }

  void scan(std::uint8_t tag, world::ModelRow model) {
    const auto sensor = layout_.sensor(layout_.id[model], in_.varint());
    if (!sensor || tag > packet::kGone) {
      bad_ = true;
      return;
    }
    std::vector<std::uint16_t>& beams = replica_.scans[sensor];
    const std::uint32_t count = tag == packet::kGone ? 0 : layout_.sensors[sensor].beam_count;
    if (in_.left() < 2 * std::size_t{count}) {
      bad_ = true;
      return;
    }
    beams.resize(count);
    for (std::uint16_t& beam : beams) beam = in_.u16();
  }

  void view(std::uint8_t tag, world::ModelRow model) {
    const std::uint32_t number = (tag - 1u) / 2;
    if (number >= views().size()) {
      bad_ = true;
      return;
    }
    if (tag % 2 == 0) {
      replica_.views.erase({number, model});
      return;
    }
    const KindView& what = views()[number];
    const std::uint64_t records = what.list ? in_.varint() : 1;
    if (records > in_.left()) {  // a record has at least one byte
      bad_ = true;
      return;
    }
    std::vector<std::int32_t>& values = replica_.views[{number, model}];
    values.resize(records * what.codes.size());
    for (std::size_t k = 0; k < values.size() && in_.ok(); ++k)
      values[k] = value(what.codes[k % what.codes.size()]);
  }

  void drawing(std::uint8_t tag, world::ModelRow model) {
    if (tag == packet::kGone) {
      replica_.drawings.erase(model);
      return;
    }
    std::optional<std::vector<SentCorner>> read =
        tag == packet::kFresh ? read_drawing(in_) : std::optional<std::vector<SentCorner>>();
    if (read) {
      replica_.drawings[model] = std::make_shared<const std::vector<SentCorner>>(*std::move(read));
    } else {
      bad_ = true;
    }
  }

  std::int32_t value(Code code) {
    switch (code) {
      case Code::kVarint:
        return static_cast<std::int32_t>(in_.varint());
      case Code::kZigzag:
        return static_cast<std::int32_t>(in_.zigzag());
      case Code::kTurn:
        return in_.u16();
      case Code::kRgba:
        return static_cast<std::int32_t>(in_.u32());
    }
    return 0;
  }

  Unpacker in_;
  const Layout& layout_;
  Replica& replica_;
  bool bad_ = false;
};

}  // namespace

Result<std::uint32_t> apply_packet(std::span<const std::byte> packet, Replica& replica) {
  return PacketReader(packet, replica).read();
}

}  // namespace playhouse::replicate
