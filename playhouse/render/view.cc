#include "playhouse/render/view.h"

#include <algorithm>
#include <cmath>

namespace playhouse::render {
namespace {

using geom::Vec3;

/// Distance of shadow casters before the shaded region that is rendered at
/// true depth: others are flattened onto the near plane by GL_DEPTH_CLAMP.
constexpr double kBeforeShade = 1;  // m

Vec3 unit(const Vec3& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 ? (1 / length) * v : Vec3{0, 0, 1};
}

void set_row(Matrix& m, int row, const Vec3& v, double w) {
  m[row] = static_cast<float>(v.x);
  m[4 + row] = static_cast<float>(v.y);
  m[8 + row] = static_cast<float>(v.z);
  m[12 + row] = static_cast<float>(w);
}

}  // namespace

Axes axes_of(const geom::Quaternion& q_WC) {
  return {q_WC * Vec3{1, 0, 0}, q_WC * Vec3{0, 1, 0}, q_WC * Vec3{0, 0, 1}};
}

Matrix clip_from_eye(const View& view, const Axes& axes) {
  Matrix m{};
  const double span = view.far - view.near;
  set_row(m, 0, (-1 / view.half_width) * axes.left, 0);
  set_row(m, 1, (1 / view.half_height) * axes.up, 0);
  set_row(m, 2, (-view.near / span) * axes.ahead, view.near * view.far / span);
  set_row(m, 3, axes.ahead, 0);
  return m;
}

double depth_of(float value, const View& view) {
  if (!(value > 0)) return 0;
  return view.near * view.far / (value * (view.far - view.near) + view.near);
}

Planes planes_of(const View& view, const Axes& axes) {
  const auto side = [&](const Vec3& across, double half) {
    return Planes::Plane{unit(half * axes.ahead + across), 0};
  };
  return {{{side(-1 * axes.left, view.half_width),
            side(axes.left, view.half_width),
            side(-1 * axes.up, view.half_height),
            side(axes.up, view.half_height),
            {axes.ahead, -view.near},
            {-1 * axes.ahead, view.far}}}};
}

SunBox sun_box(const View& view, const Axes& axes, const Vec3& to_sun, double reach) {
  SunBox box;
  box.axes.ahead = -1 * to_sun;
  const Vec3 up = std::fabs(to_sun.z) > 0.99 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  box.axes.left = unit(cross(up, box.axes.ahead));
  box.axes.up = cross(box.axes.ahead, box.axes.left);
  box.low = {1e300, 1e300, 1e300};
  box.high = {-1e300, -1e300, -1e300};
  for (const double depth : {view.near, std::max(view.near, std::min(view.far, reach))})
    for (const double left : {-1.0, 1.0})
      for (const double above : {-1.0, 1.0}) {
        const Vec3 p =
            depth * (axes.ahead + left * view.half_width * axes.left + above * view.half_height * axes.up);
        const Vec3 q{dot(p, box.axes.ahead), dot(p, box.axes.left), dot(p, box.axes.up)};
        box.low = {std::min(box.low.x, q.x), std::min(box.low.y, q.y), std::min(box.low.z, q.z)};
        box.high = {std::max(box.high.x, q.x), std::max(box.high.y, q.y), std::max(box.high.z, q.z)};
      }
  box.low.x -= kBeforeShade;
  return box;
}

Matrix clip_from_eye(const SunBox& box) {
  Matrix m{};
  const auto row = [&](int at, const Vec3& axis, double low, double high, double from, double to) {
    const double scale = (to - from) / (high - low);
    set_row(m, at, scale * axis, from - scale * low);
  };
  row(0, box.axes.left, box.low.y, box.high.y, -1, 1);
  row(1, box.axes.up, box.low.z, box.high.z, -1, 1);
  row(2, box.axes.ahead, box.low.x, box.high.x, 0, 1);
  set_row(m, 3, {}, 1);
  return m;
}

std::vector<PageSlot> pack(std::span<const PictureSize> pictures, PictureSize page) {
  std::vector<PageSlot> places;
  PageSlot next;
  std::uint32_t shelf = 0;  // its height
  for (const PictureSize& size : pictures) {
    if (next.x > 0 && next.x + size.width > page.width) {
      next = {next.page, 0, next.y + shelf};
      shelf = 0;
    }
    if (next.x + next.y > 0 && next.y + size.height > page.height) {
      next = {next.page + 1, 0, 0};
      shelf = 0;
    }
    places.push_back(next);
    next.x += size.width;
    shelf = std::max(shelf, size.height);
  }
  return places;
}

}  // namespace playhouse::render
