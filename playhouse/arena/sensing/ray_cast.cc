#include "playhouse/arena/sensing/ray_cast.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "playhouse/base/assert.h"
#include "playhouse/simd/vectors.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace playhouse::arena {
namespace {

constexpr std::size_t kLanes = 16, kMost = RayBatch::kMost, kBlocks = kMost / kLanes;
static_assert(kLanes == Bvh::kWidth && kLanes == TriangleBlock::kMost);
using Mask = std::uint32_t;  // bit i: lane i
constexpr Mask kEvery = 0xffff;

constexpr float kNarrow = 0.96f;    // least cosine to the axis in a fan of several blocks: 16 degrees
constexpr float kWidest = 0.6f;     // ... of one block
constexpr float kMargin = 1e-6f;    // rounding of coordinates at 1 ahead
constexpr float kRounding = 1e-6f;  // rounding of a plane's distance, as a share of the largest coordinate
constexpr double kInPlane = 0.125;  // share of Frame::slack that a float is rounded by
constexpr float kGrazing = 0.05f;   // cosine to the normal below which double precision decides
constexpr float kLeastSquared = 1e-30f;  // m^4; of an edge without a length
// Rounding of an edge function, as a share of the product of the vectors that it is made of: one of each, two
// of their cross product and three of the product with the ray.
constexpr float kEdgeRounding = 7 * 0x1p-24f;

// Planes of a fan's pyramid, normals inwards.
enum : std::size_t { kRight, kLeft, kLow, kHigh, kAhead, kPlanes };

/// The first `count` lanes.
constexpr Mask first_of(std::size_t count) {
  return count >= kLanes ? kEvery : (1u << count) - 1;
}

/// The origin and the axes of a fan. A direction has coordinates in the plane at 1 ahead, to the left and up.
struct Axes {
  float p[3], axis[3], left[3], up[3];
};

/// Rays from a point, all less than a right angle from an axis. A ray's reach is its range, ahead.
struct alignas(64) Fan : Axes {
  alignas(64) float d[3][kMost], range[kMost], ahead[kMost], normal[3][kMost];  // ahead: cosine to the axis
  std::uint32_t met[kMost];
  float group_right[kLanes], group_left[kLanes], group_reach[kLanes];  // of each group_size rays
  float block_right[kBlocks], block_left[kBlocks], block_reach[kBlocks];
  float right_end, left_end, low, high, reach;  // of all
  std::size_t blocks, group_size;
  std::uint32_t group;
};

/// A fan in the frame of the triangles.
struct alignas(64) Frame : Axes {
  alignas(64) float group_plane[2][3][kLanes], group_offset[2][kLanes];  // right and left
  float plane[kPlanes][3], offset[kPlanes];                              // inside: n x >= offset
  bool is_forward[kPlanes][3];                                           // of each coordinate of the normal
  const float (*d)[kMost];
  float slack;  // m that a plane's distance is rounded by, at most
};

/// Returns the length that it had.
float scale_to_unit(float (&v)[3]) {
  const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (float& each : v) each /= length;
  return length;
}

/// Largest magnitude of a coordinate.
float extent_of(const Bounds& box) {
  float extent = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (box.low[k] <= box.high[k]) extent = std::max({extent, std::fabs(box.low[k]), std::fabs(box.high[k])});
  return extent;
}

/// Left is where the last ray is from the first.
void cross_axes(Fan& fan) {
  const float* const a = fan.axis;
  const std::size_t last = fan.blocks * kLanes - 1;
  float along = 0, length = 0;
  for (std::size_t k = 0; k < 3; ++k) along += (fan.left[k] = fan.d[k][last] - fan.d[k][0]) * a[k];
  for (std::size_t k = 0; k < 3; ++k) {
    fan.left[k] -= along * a[k];
    length += fan.left[k] * fan.left[k];
  }
  if (!(length > 1e-8f)) {  // any
    const bool is_upright = std::fabs(a[2]) > 0.9f;
    fan.left[0] = is_upright ? 0 : -a[1];
    fan.left[1] = is_upright ? -a[2] : a[0];
    fan.left[2] = is_upright ? a[1] : 0;
  }
  scale_to_unit(fan.left);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    fan.up[k] = a[i] * fan.left[j] - a[j] * fan.left[i];
  }
}

/// The extreme of a block, which it overwrites, and of each group in it.
template <typename Extreme>
float fold(float* lane, std::size_t group_size, float* group, const Extreme& extreme) {
  const std::size_t groups = kLanes / group_size;
  for (std::size_t count = kLanes; count > 1; count /= 2) {  // pairs: no chain of dependent operations
    if (count == groups) std::copy_n(lane, count, group);
    for (std::size_t i = 0; i < count / 2; ++i) lane[i] = extreme(lane[2 * i], lane[2 * i + 1]);
  }
  if (groups == 1) *group = *lane;
  return *lane;
}
constexpr auto kSmaller = [](float a, float b) { return a < b ? a : b; };
constexpr auto kLarger = [](float a, float b) { return a > b ? a : b; };

/// Bounds of a block and its groups; overwrites the coordinates, with their margins, and reaches of its rays.
void bound_block(Fan& fan, std::size_t block, float* right, float* left, float* reach) {
  const std::size_t group = block * kLanes / fan.group_size;
  fan.block_right[block] = fold(right, fan.group_size, fan.group_right + group, kSmaller);
  fan.block_left[block] = fold(left, fan.group_size, fan.group_left + group, kLarger);
  fan.block_reach[block] = fold(reach, fan.group_size, fan.group_reach + group, kLarger);
}

void bound_all(Fan& fan) {
  fan.right_end = *std::min_element(fan.block_right, fan.block_right + fan.blocks);
  fan.left_end = *std::max_element(fan.block_left, fan.block_left + fan.blocks);
  fan.reach = *std::max_element(fan.block_reach, fan.block_reach + fan.blocks);
}

/// Updates what the rays of a block reach, of which `reach` has a lane each.
void shorten(Fan& fan, std::size_t block, float* reach) {
  const std::size_t group = block * kLanes / fan.group_size;
  fan.block_reach[block] = fold(reach, fan.group_size, fan.group_reach + group, kLarger);
  fan.reach = *std::max_element(fan.block_reach, fan.block_reach + fan.blocks);
}

/// The range of a ray that grazes a triangle or meets an edge as far as single precision tells, infinite if
/// it misses. In single precision a triangle would reach beyond its edges by what edge functions are rounded,
/// metres if a ray is nearly in its plane. A ray in the plane as far as coordinates tell misses the triangle:
/// its range would be that of roundings.
float exact_range(const TriangleBlock& triangles, std::size_t i, const Frame& frame, std::size_t ray) {
  constexpr double kEdgeOn = 1e-9, kDoubleRounding = 1e-14;
  geom::Vec3 corner[3];
  for (std::size_t c = 0; c < 3; ++c)
    corner[c] = {double{triangles.p[c][0][i]} - double{frame.p[0]},
                 double{triangles.p[c][1][i]} - double{frame.p[1]},
                 double{triangles.p[c][2][i]} - double{frame.p[2]}};
  const geom::Vec3 d{frame.d[0][ray], frame.d[1][ray], frame.d[2][ray]},
      n = cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double slope = dot(n, d), volume = dot(n, corner[0]), length = std::sqrt(dot(n, n));
  if (!(std::fabs(slope) > kEdgeOn * length) || std::fabs(volume) <= kInPlane * double{frame.slack} * length)
    return Bounds::kInfinity;
  bool is_left = false, is_right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const geom::Vec3 difference = corner[(k + 1) % 3] - corner[k], sum = corner[(k + 1) % 3] + corner[k];
    const double side = dot(cross(difference, sum), d),
                 margin = kDoubleRounding * std::sqrt(dot(difference, difference) * dot(sum, sum));
    is_left = is_left || side > margin;
    is_right = is_right || side < -margin;
  }
  return is_left && is_right ? Bounds::kInfinity : static_cast<float>(volume / slope);
}

/// A vector in the frame of an instance.
void rotate_into(const ShapeInstance& instance, const float* v, float (&local)[3]) {
  const std::array<float, 9>& R = instance.R_FS;
  for (std::size_t k = 0; k < 3; ++k) local[k] = R[3 * k] * v[0] + R[3 * k + 1] * v[1] + R[3 * k + 2] * v[2];
}
/// A vector of its frame, in F.
void rotate_out(const ShapeInstance& instance, float (&v)[3]) {
  const std::array<float, 9>& R = instance.R_FS;
  const float local[3] = {v[0], v[1], v[2]};
  for (std::size_t k = 0; k < 3; ++k) v[k] = R[k] * local[0] + R[3 + k] * local[1] + R[6 + k] * local[2];
}

}  // namespace
}  // namespace playhouse::arena

#define PLAYHOUSE_LANES inline
namespace playhouse::arena::plain {
namespace {
#include "playhouse/arena/sensing/float16_plain.inc"

#include "playhouse/arena/sensing/ray_cast_kernels.inc"
}  // namespace
}  // namespace playhouse::arena::plain
#undef PLAYHOUSE_LANES

#ifdef __x86_64__
#define PLAYHOUSE_LANES PLAYHOUSE_TARGET_AVX2 inline
namespace playhouse::arena::avx2 {
namespace {
#include "playhouse/arena/sensing/float16_avx2.inc"

#include "playhouse/arena/sensing/ray_cast_kernels.inc"
}  // namespace
}  // namespace playhouse::arena::avx2
#undef PLAYHOUSE_LANES

#define PLAYHOUSE_LANES PLAYHOUSE_TARGET_AVX512 inline
namespace playhouse::arena::avx512 {
namespace {
#include "playhouse/arena/sensing/float16_avx512.inc"

#include "playhouse/arena/sensing/ray_cast_kernels.inc"
}  // namespace
}  // namespace playhouse::arena::avx512
#undef PLAYHOUSE_LANES
#else
namespace playhouse::arena::avx2 = plain;
namespace playhouse::arena::avx512 = plain;
#endif

namespace playhouse::arena {

void cast_rays(const RayIndex& index, RayBatch& rays) {
  PLAYHOUSE_ASSERT(rays.count <= RayBatch::kMost);
  if (rays.count == 0) return;
  const auto cast = simd::choose_version(plain::cast, avx2::cast, avx512::cast);
  cast(index, 0, rays.count, rays);
}

}  // namespace playhouse::arena
