#include "playhouse_client/keeping.h"

#include <utility>

namespace playhouse::client {

Keeping::Keeping(Device device) : device_(std::move(device)) {
  device_.keep(kWaiting);
}

std::deque<std::vector<std::byte>> Keeping::take_kept() {
  return device_.take_kept();
}

}  // namespace playhouse::client
