#include "playhouse/drivers/blobtracker/blob_tracker.h"

#include <cmath>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/dio.h"

namespace playhouse::drivers {

namespace blf = wire::blobfinder;

namespace {

/// -1, 0 or 1: on which side of the middle of an image's side a place is; the middle has a part of it.
double side_of(double place, double length, double idle) {
  const double offset = 2 * place / length - 1;
  return offset < -idle ? -1 : offset > idle ? 1 : 0;
}

}  // namespace

const blf::Blob* blob_of_color(const blf::Data& image, std::uint32_t color) {
  const blf::Blob* largest = nullptr;
  for (const blf::Blob& blob : image.blobs)
    if ((blob.color & 0xFFFFFFu) == color && (largest == nullptr || blob.area > largest->area))
      largest = &blob;
  return largest;
}

std::optional<wire::ptz::Cmd> turn_towards(const BlobTrackerOptions& options, const blf::Data& image,
                                           const blf::Blob& blob, const wire::ptz::Data& looks) {
  if (image.width == 0 || image.height == 0) return std::nullopt;
  const double right = side_of(blob.x, image.width, options.idle),
               down = side_of(blob.y, image.height, options.idle);
  if (right == 0 && down == 0) return std::nullopt;
  wire::ptz::Cmd command;
  command.pan = looks.pan - static_cast<float>(right * options.step);
  command.tilt = looks.tilt - static_cast<float>(down * options.step);
  command.zoom = options.zoom < 0 ? looks.zoom : static_cast<float>(options.zoom);
  command.panspeed = static_cast<float>(options.pan_speed);
  command.tiltspeed = static_cast<float>(options.tilt_speed);
  return command;
}

BlobTracker::BlobTracker(Shell& shell, const BlobTrackerOptions& options)
    : shell_(shell),
      options_(options),
      images_(shell.client().latest(kBlobs, blf::kDataBlobs)),
      states_(shell.client().latest(kCamera, wire::ptz::kDataState)) {}

void BlobTracker::closed() {
  const std::lock_guard lock(mutex_);
  looks_.reset();
}

void BlobTracker::take_news(std::vector<device::Publication>& more) {
  std::optional<wire::ptz::Data> looks;
  {
    const std::lock_guard lock(mutex_);
    if (const std::optional<device::Publication> state = states_.take_latest()) {
      const Result<wire::ptz::Data> told = wire::decode<wire::ptz::Data>(state->body);
      if (told && std::isfinite(told->pan) && std::isfinite(told->tilt)) looks_ = *told;
    }
    looks = looks_;
  }
  const std::optional<device::Publication> message = images_.take_latest();
  if (!message) return;
  const Result<blf::Data> image = wire::decode<blf::Data>(message->body);
  if (!image) return;
  const blf::Blob* blob = blob_of_color(*image, options_.color);
  more.push_back({shell_.device(0), wire::dio::kDataValues, message->timestamp,
                  wire::encode(wire::dio::Data{1, blob != nullptr ? 1u : 0u})});
  if (blob == nullptr || !looks) return;
  if (const std::optional<wire::ptz::Cmd> command = turn_towards(options_, *image, *blob, *looks))
    shell_.client().command(kCamera, wire::ptz::kCmdState, wire::encode(*command));
}

Result<BlobTrackerOptions> blob_tracker_options(SectionFields fields) {
  BlobTrackerOptions options;
  constexpr std::string_view kParts[] = {"r", "g", "b"};
  for (const std::string_view part : kParts) {
    const int value = fields.integer({part, "Of the colour of the blobs."}, 0, 0, 255);
    options.color = options.color << 8u | static_cast<std::uint32_t>(value);
  }
  options.idle = fields.number(
      {"idle_area", "Part of the image, its middle, in which a blob is not followed."}, options.idle);
  fields.expect(options.idle <= 1, "idle_area", "is from 0 to 1");
  options.step = fields.angle({"step", "How far it turns for an image."}, options.step);
  options.pan_speed = fields.angle({"pan_speed", "How fast the camera turns.", "deg/s"}, options.pan_speed);
  options.tilt_speed = fields.angle({"tilt_speed", "The same up and down.", "deg/s"}, options.tilt_speed);
  options.zoom = fields.angle({"zoom", "The field of view; below 0 it stays."}, geom::radians(-1), 0,
                              SectionFields::kAnyNumber);
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

namespace {

Result<std::unique_ptr<device::Driver>> make_blob_tracker(const config::CfgSection& section, Site& site) {
  return make_algorithm<BlobTracker>(
      section, site, {.provides = {{"dio"}}, .uses = {{"blobfinder"}, {"ptz"}}}, blob_tracker_options);
}

constexpr DeviceText kBlobTrackerProvides[] = {
    {"dio", {}, HowMany::kOne, "has its first bit set while there is a blob"}};
constexpr DeviceText kBlobTrackerUses[] = {{"blobfinder", {}, HowMany::kOne, "of the camera"},
                                           {"ptz", {}, HowMany::kOne, "turns the camera"}};

}  // namespace

constinit const DriverDefinition kBlobTrackerDriver{
    .name = "blobtracker",
    .doc = "Turns a camera after blobs of a colour.",
    .provides = kBlobTrackerProvides,
    .uses = kBlobTrackerUses,
    .read_options = reading<blob_tracker_options>,
    .make = make_blob_tracker,
};

}  // namespace playhouse::drivers
