#pragma once

/// Topological order in which data pass through drivers: each driver after those whose devices it requires.

#include <cstddef>
#include <vector>

namespace playhouse::drivers {

struct DataOrder {
  std::vector<std::size_t> order;   // all nodes, each after those it requires; ties by number
  std::vector<std::size_t> circle;  // a cycle of requirements: each requires the next, the last the first
};

/// `required[i]` are the nodes that node i requires, maybe itself. Either `order` or `circle` is
/// empty. Of several cycles one is returned, deterministically; it starts with its lowest node.
DataOrder data_order(const std::vector<std::vector<std::size_t>>& required);

}  // namespace playhouse::drivers
