#include "playhouse/arena/physics/supports.h"

#include <algorithm>

namespace playhouse::arena {
namespace {

constexpr double kWide = 2;  // m along x; wider boxes are tested by brute force

bool overlap(const Aabb& a, const Aabb& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

}  // namespace

void Supports::set(const ByRow<RigidBody, Aabb>& boxes) {
  narrow_.clear();
  wide_.clear();
  for (const RigidBodyRow body : boxes.rows())
    (boxes[body].high.x - boxes[body].low.x > kWide ? wide_ : narrow_).push_back({boxes[body], body});
  std::ranges::sort(narrow_, {}, [](const BodyBox& entry) { return std::pair(entry.box.low.x, entry.body); });
}

void Supports::find(const Aabb& box, std::vector<RigidBodyRow>& bodies) const {
  bodies.clear();
  for (const BodyBox& entry : wide_)
    if (overlap(entry.box, box)) bodies.push_back(entry.body);
  const auto low_x = [](const BodyBox& entry) { return entry.box.low.x; };
  for (auto entry = std::ranges::lower_bound(narrow_, box.low.x - kWide, {}, low_x);
       entry != narrow_.end() && entry->box.low.x <= box.high.x; ++entry)
    if (overlap(entry->box, box)) bodies.push_back(entry->body);
  std::ranges::sort(bodies);
}

}  // namespace playhouse::arena
