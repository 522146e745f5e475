#pragma once

/// Camera that finds regions of one color (blobs).

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "playhouse/wire/generated/blobfinder.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

/// A region of one color; pixels are counted from the top left corner of the image.
struct Blob {
  std::uint32_t channel = 0;                               // that detected it
  std::array<std::uint8_t, 3> color{};                     // for display: red, green, blue, 0 to 255
  std::uint32_t area = 0;                                  // px
  std::uint32_t x = 0, y = 0;                              // px, its centre
  std::uint32_t left = 0, right = 0, top = 0, bottom = 0;  // px, first and last column and row
  double range = 0;                                        // m; 0 if unknown
};

/// In pixels.
struct ImageSize {
  std::uint32_t width = 0, height = 0;
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

class Blobfinder {
 public:
  static Result<Blobfinder> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// Blobs in the newest image; empty before the first data.
  std::vector<Blob> blobs() const;
  /// Size of the newest image; none before the first data.
  std::optional<ImageSize> image_size() const;

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Blobfinder(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
