#include "playhouse/drivers/data_order.h"

#include <algorithm>
#include <set>

namespace playhouse::drivers {
namespace {

/// Finds a cycle: every node of `stuck` requires another one of them.
std::vector<std::size_t> find_circle(const std::vector<std::vector<std::size_t>>& required,
                                     const std::vector<bool>& stuck) {
  std::vector<std::size_t> way;
  std::vector<bool> seen(required.size());
  std::size_t node = static_cast<std::size_t>(std::ranges::find(stuck, true) - stuck.begin());
  while (!seen[node]) {
    seen[node] = true;
    way.push_back(node);
    node = *std::ranges::find_if(required[node], [&](std::size_t next) { return stuck[next]; });
  }
  way.erase(way.begin(), std::ranges::find(way, node));
  std::rotate(way.begin(), std::ranges::min_element(way), way.end());
  return way;
}

}  // namespace

DataOrder data_order(const std::vector<std::vector<std::size_t>>& required) {
  std::vector<std::vector<std::size_t>> requiring(required.size());
  std::vector<std::size_t> open(required.size());  // number of unplaced requirements, by node
  std::set<std::size_t> ready;
  for (std::size_t node = 0; node < required.size(); ++node) {
    for (const std::size_t other : required[node]) requiring[other].push_back(node);
    open[node] = required[node].size();
    if (open[node] == 0) ready.insert(node);
  }
  DataOrder found;
  std::vector<bool> stuck(required.size(), true);
  while (!ready.empty()) {
    const std::size_t node = *ready.begin();
    ready.erase(ready.begin());
    stuck[node] = false;
    found.order.push_back(node);
    for (const std::size_t other : requiring[node])
      if (--open[other] == 0) ready.insert(other);
  }
  if (found.order.size() < required.size()) {
    found.order.clear();
    found.circle = find_circle(required, stuck);
  }
  return found;
}

}  // namespace playhouse::drivers
