#include "playhouse_client/robot.h"

#include <utility>

#include "model_list.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse_client/client.h"
#include "session.h"

namespace playhouse::client {

Robot::Robot(std::shared_ptr<Session> session, std::string name, std::string type,
             std::vector<RobotDevice> devices)
    : session_(std::move(session)),
      name_(std::move(name)),
      type_(std::move(type)),
      devices_(std::move(devices)) {}

Result<Device> Robot::device(std::string_view interf, std::size_t n, Access access) const {
  const wire::InterfaceDef* wanted = wire::find_interface(interf);
  if (wanted == nullptr) {
    std::vector<std::string_view> names;
    for (const wire::InterfaceDef& known : wire::interfaces()) names.push_back(known.name);
    return Error{"", "there is no interface " + in_quotes(interf) + did_you_mean(interf, names)};
  }
  std::size_t found = 0;
  std::string all;
  for (const RobotDevice& device : devices_) {
    all += (all.empty() ? "" : ", ") + device.address.name();
    if (device.address.interf != wanted->code) continue;
    if (found++ == n) return Device::open(session_, wanted->code, device.address.index, access);
  }
  const std::string missing = found == 0
                                  ? " has no " + std::string(interf)
                                  : " has " + std::to_string(found) + " " + std::string(interf) + " only";
  return Error{
      "", "robot " + in_quotes(name_) + missing + " (it has " + (all.empty() ? "no devices" : all) + ")"};
}

}  // namespace playhouse::client
