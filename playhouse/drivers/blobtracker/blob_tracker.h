#pragma once

/// The .cfg driver "blobtracker": turns a camera after blobs of a colour.
///
/// In: the blobs of an image, and where the camera looks.
///
/// Out: it looks a step further towards the largest blob of the colour, if that is outside the middle of the image.

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/geom/trig.h"
#include "playhouse/wire/generated/blobfinder.h"
#include "playhouse/wire/generated/ptz.h"

namespace playhouse::drivers {

struct BlobTrackerOptions {
  std::uint32_t color = 0;                                               // 0xRRGGBB
  double idle = 0.4;                                                     // part of the image, its middle
  double step = geom::radians(1);                                        // rad
  double pan_speed = geom::radians(10), tilt_speed = geom::radians(10);  // rad/s
  double zoom = -1;                                                      // rad; below 0: as it is
};

Result<BlobTrackerOptions> blob_tracker_options(SectionFields fields);

/// The largest blob of the colour; null if there is none.
const wire::blobfinder::Blob* blob_of_color(const wire::blobfinder::Data& image, std::uint32_t color);
/// What the camera, which looks there, is told of a blob; none if that is in the middle.
std::optional<wire::ptz::Cmd> turn_towards(const BlobTrackerOptions& options,
                                           const wire::blobfinder::Data& image,
                                           const wire::blobfinder::Blob& blob, const wire::ptz::Data& looks);

/// Uses the blobfinder and the ptz. Provides a dio, whose first bit is 1 while there is a blob.
class BlobTracker final : public Algorithm {
 public:
  BlobTracker(Shell& shell, const BlobTrackerOptions& options);

  void closed() override;
  void take_news(std::vector<device::Publication>& more) override;

 private:
  static constexpr std::size_t kBlobs = 0, kCamera = 1;  // used devices

  Shell& shell_;
  const BlobTrackerOptions options_;
  device::Subscription& images_;
  device::Subscription& states_;

  std::mutex mutex_;                      // guards what follows
  std::optional<wire::ptz::Data> looks_;  // the newest
};

extern const DriverDefinition kBlobTrackerDriver;

}  // namespace playhouse::drivers
