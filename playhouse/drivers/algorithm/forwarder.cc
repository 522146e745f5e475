#include "playhouse/drivers/algorithm/forwarder.h"

#include <utility>

#include "playhouse/drivers/decoded.h"

namespace playhouse::drivers {

Forwarder::Forwarder(Shell& shell) : shell_(shell), data_(shell.client().queue(kForwarded, kStatesKept)) {
  shell.forward_others(kForwarded, [this](const device::Message& message) { return take(message); });
}

void Forwarder::take_news(std::vector<device::Publication>& more) {
  for (device::Publication& message : data_.take()) {
    message.device = shell_.device(0);
    message.clients.clear();
    std::optional<device::Publication> kept = passed(std::move(message));
    if (kept) more.push_back(std::move(*kept));
  }
}

}  // namespace playhouse::drivers
