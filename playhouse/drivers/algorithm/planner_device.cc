#include "playhouse/drivers/algorithm/planner_device.h"

#include <utility>
#include <vector>

#include "playhouse/wire/codec.h"

namespace playhouse::drivers {

namespace planner = wire::planner;

void serve_planner(Shell& shell, std::size_t device, PlannerCalls calls) {
  for (const std::uint8_t subtype : {planner::kCmdGoal, planner::kCmdStart}) {
    shell.on_command<planner::Cmd>(
        subtype,
        [take = calls.take_goal, start = subtype == planner::kCmdStart](const planner::Cmd& command) {
          return take(command, start);
        },
        device);
  }
  shell.on_request(
      planner::kReqGetWaypoints,
      [waypoints = std::move(calls.waypoints)](const device::Message&, device::Replier replier) {
        replier.ack(wire::encode(waypoints()));
      },
      device);
  shell.on_request<planner::EnableReq>(
      planner::kReqEnable,
      [enable = std::move(calls.enable)](const planner::EnableReq& asked) {
        enable(asked.state != 0);
        return std::vector<std::byte>();
      },
      device);
}

}  // namespace playhouse::drivers
