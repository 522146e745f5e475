#include "playhouse/rays/lens.h"

#include <algorithm>
#include <cmath>

namespace playhouse::rays {
namespace {

using geom::Rotation;

/// Directions closer than this to the horizon or the vertical are moved away from it.
constexpr double kLeast = 1e-9;

/// The direction of a pixel, scaled to depth 1 along the optical axis.
struct Sight {
  double ahead, left, up;
};

class Image {
 public:
  Image(const scene::CameraDesc& camera, double tilt, double zoom)
      : half_(scene::half_image(camera, zoom)),
        width(static_cast<std::uint32_t>(camera.width)),
        height(static_cast<std::uint32_t>(camera.height)),
        tilt_(Rotation::of(tilt)) {}

  Sight sight(std::uint32_t row, std::uint32_t column) const {
    const double left = half_.width * (1 - (2.0 * column + 1) / width);
    const double up = half_.height * (1 - (2.0 * row + 1) / height);
    return {tilt_.c - tilt_.s * up, left, tilt_.s + tilt_.c * up};
  }

 private:
  scene::HalfImage half_;

 public:
  const std::uint32_t width, height;  // px

 private:
  Rotation tilt_;
};

/// Assigns pixels to the slices `slice_of(row, column)`, in image order (counting sort).
template <typename SliceOf>
void sort_into_slices(const Image& image, const scene::CameraDesc& camera, const SliceOf& slice_of,
                      Lens& lens) {
  const std::size_t slices = lens.ahead.size(), pixels = std::size_t{image.width} * image.height;
  const auto each = [&](const auto& visit) {
    for (std::uint32_t row = 0; row < image.height; ++row)
      for (std::uint32_t column = 0; column < image.width; ++column) visit(row, column);
  };
  std::vector<std::uint32_t> slice(pixels);
  lens.first.assign(slices + 1, 0);
  each([&](std::uint32_t row, std::uint32_t column) {
    const std::uint32_t s = slice_of(row, column);
    slice[row * image.width + column] = s;
    ++lens.first[s + 1];
  });
  for (std::size_t s = 1; s <= slices; ++s) lens.first[s] += lens.first[s - 1];
  std::vector<std::uint32_t> next(lens.first.begin(), lens.first.end() - 1);
  lens.place.resize(pixels);
  lens.run.resize(pixels + Lens::kPad);
  lens.least.resize(pixels + Lens::kPad);
  lens.depth.resize(pixels);
  lens.reach.assign(slices, 0);
  each([&](std::uint32_t row, std::uint32_t column) {
    const std::uint32_t at = row * image.width + column, s = slice[at], i = next[s]++;
    const Sight sight = image.sight(row, column);
    const double along = std::max(kLeast, std::sqrt(sight.ahead * sight.ahead + sight.left * sight.left));
    const double up = std::fabs(sight.up) < kLeast ? std::copysign(kLeast, sight.up) : sight.up;
    lens.place[i] = at;
    lens.run[i] = along / up;
    lens.depth[i] = 1 / along;
    lens.least[i] = camera.range_min * along;
    lens.reach[s] = std::max(lens.reach[s], camera.range_max * along);
  });
}

/// One slice per column, for a level camera.
void slice_columns(const Image& image, const scene::CameraDesc& camera, Lens& lens) {
  for (std::uint32_t column = 0; column < image.width; ++column) {
    const Sight sight = image.sight(0, column);
    const double along = std::sqrt(sight.ahead * sight.ahead + sight.left * sight.left);
    lens.ahead.push_back({sight.ahead / along, sight.left / along});
  }
  sort_into_slices(
      image, camera, [](std::uint32_t, std::uint32_t column) { return column; }, lens);
}

/// Slices at equal angles over the range of bearings of all pixels.
void slice_bearings(const Image& image, double zoom, const scene::CameraDesc& camera, Lens& lens) {
  std::vector<double> bearing;
  for (std::uint32_t row = 0; row < image.height; ++row)
    for (std::uint32_t column = 0; column < image.width; ++column) {
      const Sight sight = image.sight(row, column);
      bearing.push_back(geom::atan2(sight.left, sight.ahead));
    }
  const double least = std::ranges::min(bearing), most = std::ranges::max(bearing);
  const double step = 0.5 * zoom / image.width;
  const auto slices = static_cast<std::uint32_t>((most - least) / step) + 1;
  for (std::uint32_t s = 0; s < slices; ++s) lens.ahead.push_back(Rotation::of(least + (s + 0.5) * step));
  sort_into_slices(
      image, camera,
      [&](std::uint32_t row, std::uint32_t column) {
        const double s = (bearing[std::size_t{row} * image.width + column] - least) / step;
        return std::min(static_cast<std::uint32_t>(s), slices - 1);
      },
      lens);
}

}  // namespace

Lens make_lens(const scene::CameraDesc& camera, double tilt, double zoom) {
  // Values come from a loaded state, which may be corrupt.
  if (!(std::fabs(tilt) <= 1e5)) tilt = 0;
  if (!(zoom > 0 && zoom < geom::kPi)) zoom = camera.fov_horizontal;
  const Image image(camera, tilt, zoom);
  Lens lens;
  if (tilt == 0) {
    slice_columns(image, camera, lens);
  } else {
    slice_bearings(image, zoom, camera, lens);
  }
  return lens;
}

}  // namespace playhouse::rays
