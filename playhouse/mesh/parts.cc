#include "playhouse/mesh/parts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

namespace playhouse::mesh {
namespace {

using geom::Vec3;
using Place = std::array<float, 3>;

/// Union-find; the smallest row represents a set.
class Sets {
 public:
  explicit Sets(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0u); }
  std::uint32_t find(std::uint32_t row) {
    while (above_[row] != row) row = above_[row] = above_[above_[row]];
    return row;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> above_;
};

Vec3 vec(const Place& p) {
  return {p[0], p[1], p[2]};
}

/// Points by group, in row order, without duplicates.
std::vector<std::vector<Vec3>> grouped(const std::vector<Place>& places,
                                       const std::vector<std::uint32_t>& group) {
  std::map<std::uint32_t, std::vector<Place>> by_group;
  for (std::size_t row = 0; row < places.size(); ++row) by_group[group[row]].push_back(places[row]);
  std::vector<std::vector<Vec3>> parts;
  for (auto& [first, part] : by_group) {
    std::sort(part.begin(), part.end());
    part.erase(std::unique(part.begin(), part.end()), part.end());
    std::vector<Vec3>& points = parts.emplace_back();
    for (const Place& p : part) points.push_back(vec(p));
  }
  return parts;
}

}  // namespace

std::vector<std::vector<Vec3>> parts_of(const Mesh& mesh, std::size_t most) {
  std::vector<Place> places;  // of used vertices
  std::vector<std::uint32_t> surface_of;
  for (std::uint32_t s = 0; s < mesh.surfaces.size(); ++s)
    for (const auto& corner : mesh.surfaces[s].corners)
      for (const std::uint32_t row : corner) {
        Place p = mesh.surfaces[s].p[row];
        for (float& x : p) x += 0.0f;  // -0 becomes 0
        places.push_back(p);
        surface_of.push_back(s);
      }
  std::vector<std::uint32_t> order(places.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return places[a] != places[b] ? places[a] < places[b] : a < b;
  });
  Sets sets(places.size());
  for (std::size_t i = 1; i < order.size(); ++i)
    if (places[order[i - 1]] == places[order[i]]) sets.join(order[i - 1], order[i]);
  for (std::uint32_t row = 0; row + 2 < places.size(); row += 3) {
    sets.join(row, row + 1);
    sets.join(row, row + 2);
  }
  std::vector<std::uint32_t> group;
  for (std::uint32_t row = 0; row < places.size(); ++row) group.push_back(sets.find(row));
  std::vector<std::vector<Vec3>> parts = grouped(places, group);
  if (parts.size() > most) parts = grouped(places, surface_of);
  if (parts.size() > most) parts = grouped(places, std::vector<std::uint32_t>(places.size(), 0));
  return parts;
}

}  // namespace playhouse::mesh
