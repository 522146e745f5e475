#pragma once

/// In which order data pass through drivers: each behind those whose devices it requires.

#include <cstddef>
#include <vector>

namespace playhouse::drivers {

struct DataOrder {
  std::vector<std::size_t> order;   // every node, each behind those it requires; the first in number first
  std::vector<std::size_t> circle;  // nodes that require each other, each the next and the last the first
};

/// `required[i]` are the nodes that node i requires, itself perhaps. Of `order` and `circle` one is empty.
/// Of several circles it is one of them, the same for the same nodes; it begins with its first node.
DataOrder data_order(const std::vector<std::vector<std::size_t>>& required);

}  // namespace playhouse::drivers
