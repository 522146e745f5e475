#include "playhouse/render/instance_list.h"

#include <algorithm>
#include <tuple>

namespace playhouse::render {
namespace {

void set_rows(CardInstance& to, const geom::Quaternion& q, const geom::Vec3& p, double scale) {
  const Axes axes = axes_of(q);
  const geom::Vec3 columns[4] = {scale * axes.ahead, scale * axes.left, scale * axes.up, p};
  for (int k = 0; k < 4; ++k) {
    to.rows[k] = static_cast<float>(columns[k].x);
    to.rows[4 + k] = static_cast<float>(columns[k].y);
    to.rows[8 + k] = static_cast<float>(columns[k].z);
  }
}

}  // namespace

void InstanceList::sort(bool one_by_one) {
  std::ranges::sort(keys_, [&](const SortKey& a, const SortKey& b) {
    if (one_by_one) return std::tie(a.order, a.row) < std::tie(b.order, b.row);
    return std::tie(a.what, a.order, a.row) < std::tie(b.what, b.order, b.row);
  });
}

CardInstance seen_from(const geom::Vec3& eye, const Instance& instance) {
  CardInstance to{};
  set_rows(to, instance.q, instance.p - eye, 1);
  std::ranges::copy(instance.tint, to.tint);
  to.segment = instance.segment;
  to.glow = instance.glow;
  return to;
}

CardInstance seen_from(const geom::Vec3& eye, const Figure& figure, std::uint32_t first_bone) {
  CardInstance to{};
  set_rows(to, geom::orientation(figure.heading, {}), figure.p - eye, figure.height);
  std::ranges::copy(figure.clothes, to.tint);
  to.tint[3] = 1;
  to.segment = figure.segment;
  to.first_bone = first_bone;
  return to;
}

}  // namespace playhouse::render
