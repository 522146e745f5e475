/// A blobfinder as interface blobfinder (docs/drivers.md).

#include "playhouse/wire/generated/blobfinder.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/settings/settings.h"
#include "playhouse/scene/forms/colors.h"

namespace playhouse::drivers {
namespace {

namespace bf = wire::blobfinder;
using wire::MessageType;

bf::Blob item_of(const world::Blob& blob) {
  bf::Blob item;
  item.id = blob.channel;
  item.color = scene::rgba8(blob.color) >> 8;
  item.area = (blob.right - blob.left + 1) * (blob.bottom - blob.top + 1);
  item.x = (blob.left + blob.right) / 2;
  item.y = (blob.top + blob.bottom) / 2;
  item.left = blob.left;
  item.right = blob.right;
  item.top = blob.top;
  item.bottom = blob.bottom;
  item.range = static_cast<float>(blob.range);
  return item;
}

/// Channels that clients can set of a finder that searches all colors; else its own colors are the channels.
constexpr std::int32_t kChannels = 32;
constexpr std::uint32_t kBrightest = 255;

/// The colors that a channel reports.
struct Channel {
  bool on = false, is_set = false;
  bf::ColorConfig range;

  bool has(std::uint32_t rgb) const {
    const std::uint32_t red = rgb >> 16 & 0xff, green = rgb >> 8 & 0xff, blue = rgb & 0xff;
    return on && (!is_set || (red >= range.rmin && red <= range.rmax && green >= range.gmin &&
                              green <= range.gmax && blue >= range.bmin && blue <= range.bmax));
  }
};

struct BlobfinderSettings {
  std::array<Channel, kChannels> channels;
  std::int32_t brightness = 128, contrast = 128, colormode = 0, autogain = 0;
};

/// The colors that it searches; none: all.
std::span<const scene::Color> colors_of(const scene::BlobfinderDesc& camera) {
  const std::size_t all = camera.colors.size();
  return std::span(camera.colors)
      .first(camera.colors_count > 0 ? std::min<std::size_t>(camera.colors_count, all) : all);
}

bool is_range(std::uint32_t least, std::uint32_t most) {
  return least <= most && most <= kBrightest;
}

class Blobfinder final : public DeviceWithSettings<BlobfinderSettings> {
 public:
  Blobfinder(run::Simulation& simulation, world::ModelRow model)
      : DeviceWithSettings(simulation, simulation.world().id(model), usual_of(simulation.world(), model)) {
    const scene::BlobfinderDesc& camera = *simulation.world().desc(model).blobfinder;
    width_ = static_cast<std::uint32_t>(camera.width);
    height_ = static_cast<std::uint32_t>(camera.height);
    searches_all_ = colors_of(camera).empty();
  }

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kReq, bf::kReqSetColor},
        {MessageType::kReq, bf::kReqGetColor},
        {MessageType::kReq, bf::kReqSetImagerParams},
    };
    return kServed;
  }
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  std::span<const NamedSetting> named() const override {
    static constexpr NamedSetting kNamed[] = {
        {"brightness", &BlobfinderSettings::brightness},
        {"contrast", &BlobfinderSettings::contrast},
        {"colormode", &BlobfinderSettings::colormode},
        {"autogain", &BlobfinderSettings::autogain},
    };
    return kNamed;
  }
  bool settle(BlobfinderSettings& wanted) const override {
    const auto is_within = [](std::int32_t value, std::int32_t most) { return value >= 0 && value <= most; };
    return is_within(wanted.brightness, 255) && is_within(wanted.contrast, 255) &&
           is_within(wanted.colormode, 3) && is_within(wanted.autogain, 1);
  }
  /// Each color of the file is a channel; all colors are channel 0.
  static BlobfinderSettings usual_of(const world::World& world, world::ModelRow model);
  bool set_color(BlobfinderSettings& wanted, const bf::ColorConfig& range) const;
  /// The number under which a blob is reported; none if it is not.
  std::optional<std::uint32_t> channel_of(const world::Blob& blob) const;

  std::uint32_t width_ = 0, height_ = 0;  // px, of the image
  bool searches_all_ = false;
};

BlobfinderSettings Blobfinder::usual_of(const world::World& world, world::ModelRow model) {
  BlobfinderSettings usual;
  const std::span<const scene::Color> colors = colors_of(*world.desc(model).blobfinder);
  if (colors.empty()) usual.channels[0] = {true, false, {0, 0, kBrightest, 0, kBrightest, 0, kBrightest}};
  for (std::size_t i = 0; i < std::min(colors.size(), usual.channels.size()); ++i) {
    const std::uint32_t rgb = scene::rgba8(colors[i]) >> 8;
    const std::uint32_t red = rgb >> 16 & 0xff, green = rgb >> 8 & 0xff, blue = rgb & 0xff;
    usual.channels[i] = {true, false, {static_cast<std::int32_t>(i), red, red, green, green, blue, blue}};
  }
  return usual;
}

/// The file's colors are all that is searched, and a channel can only leave out some of them.
bool Blobfinder::set_color(BlobfinderSettings& wanted, const bf::ColorConfig& range) const {
  if (!is_range(range.rmin, range.rmax) || !is_range(range.gmin, range.gmax) ||
      !is_range(range.bmin, range.bmax) || range.channel < -1 || range.channel >= kChannels)
    return false;
  for (std::int32_t i = 0; i < kChannels; ++i) {
    Channel& channel = wanted.channels[static_cast<std::size_t>(i)];
    const bool is_meant = range.channel == i || (range.channel == -1 && channel.on);
    if (!is_meant) continue;
    if (!channel.on && !searches_all_) return false;
    channel = {true, true, range};
    channel.range.channel = i;
  }
  return true;
}

void Blobfinder::request(const device::Message& message, device::Replier replier) {
  if (message.subtype == bf::kReqSetImagerParams) {
    const auto value = wire::decode<bf::ImagerConfig>(message.body);
    if (!value) return;
    return change_settings(std::move(replier), [value = *value](BlobfinderSettings& wanted) {
      if (value.brightness != -1) wanted.brightness = value.brightness;
      if (value.contrast != -1) wanted.contrast = value.contrast;
      if (value.colormode != -1) wanted.colormode = value.colormode;
      if (value.autogain != -1) wanted.autogain = value.autogain;
      return true;
    });
  }
  const auto range = wire::decode<bf::ColorConfig>(message.body);
  if (!range) return;
  if (message.subtype == bf::kReqSetColor)
    return change_settings(std::move(replier), [this, range = *range](BlobfinderSettings& wanted) {
      return set_color(wanted, range);
    });
  if (range->channel < 0 || range->channel >= kChannels) return;
  const auto number = static_cast<std::size_t>(range->channel);
  // A change that changes nothing: NACK for a channel that is not there.
  change_settings(
      std::move(replier), [number](const BlobfinderSettings& now) { return now.channels[number].on; },
      [number](const BlobfinderSettings& now) { return wire::encode(now.channels[number].range); });
}

std::optional<std::uint32_t> Blobfinder::channel_of(const world::Blob& blob) const {
  const std::uint32_t rgb = scene::rgba8(blob.color) >> 8;
  const std::span<const Channel> channels = settings().channels;
  if (!searches_all_) {
    // Those beyond have no settings.
    if (blob.channel >= channels.size() || channels[blob.channel].has(rgb)) return blob.channel;
    return std::nullopt;
  }
  for (std::uint32_t i = 0; i < channels.size(); ++i)
    if (channels[i].has(rgb)) return i;
  return std::nullopt;
}

void Blobfinder::emit(const world::World& world, std::vector<device::Publication>& out) {
  const world::ModelRow row = world.row(model());
  if (!row) return;
  const world::BlobfinderRow camera = world.models.part[row];
  if (world.blobfinders.measured_tick[camera] != world.tick()) return;
  bf::Data data;
  data.width = width_;
  data.height = height_;
  for (const world::Blob& blob : world.blobfinders.blobs[camera]) {
    const std::optional<std::uint32_t> channel = channel_of(blob);
    if (!channel) continue;
    data.blobs.push_back(item_of(blob));
    data.blobs.back().id = *channel;
  }
  publish(world, bf::kDataBlobs, data, out);
}

}  // namespace

std::unique_ptr<SimulatedDevice> make_blobfinder_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Blobfinder>(simulation, model);
}

}  // namespace playhouse::drivers
