#include "playhouse/drivers/plugin/plugin_messages.h"

#include <fmt/format.h>

#include "playhouse/base/limits.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {

std::string fault_of_message(std::span<const PluginDevice> devices, wire::MessageType type,
                             std::size_t device, std::uint8_t subtype, std::span<const std::byte> body) {
  if (device >= devices.size())
    return fmt::format("there is no device {} in a list of {}", device, devices.size());
  const PluginDevice& known = devices[device];
  const wire::MessageDef* const message = wire::find_message(known.code, type, subtype);
  if (message == nullptr) return fmt::format("no message of {} has subtype {}", known.interf, subtype);
  return message->check(body);
}

bool ToldLines::add(const std::string& line) {
  const std::lock_guard lock(mutex_);
  return lines_.size() < limits::kWarningsOfAKind && lines_.insert(line).second;
}

}  // namespace playhouse::drivers
