#include "playhouse_client/planner.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "convert.h"
#include "done.h"
#include "finite.h"

namespace playhouse::client {

namespace planner = wire::planner;

namespace {

/// Whether two poses are the same, whole turns aside, which drivers drop.
bool same(const Pose& one, const Pose& other) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return one.x == other.x && one.y == other.y && std::abs(std::remainder(one.a - other.a, kTurn)) < 1e-6;
}

}  // namespace

Result<Planner> Planner::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, planner::kCode, index, access);
  if (!device) return device.error();
  return Planner(std::move(*device));
}

std::optional<PlannerState> Planner::state() const {
  const auto data = device_.latest<planner::Data>(planner::kDataState);
  if (!data) return std::nullopt;
  return PlannerState{data->valid != 0,     data->done != 0,    pose(data->pos),       pose(data->goal),
                      pose(data->waypoint), data->waypoint_idx, data->waypoints_count, device_.timestamp()};
}

bool Planner::arrived() const {
  const auto newest = state();
  return newest && newest->done && goal_ && same(newest->goal, *goal_);
}

Result<void> Planner::go_to(const Pose& pose) {
  if (const auto sound = finite(device_, "go_to", {pose.x, pose.y, pose.a}); !sound) return sound;
  goal_ = pose;
  return device_.command(planner::kCmdGoal, planner::Cmd{on_wire(pose)});
}

Result<void> Planner::stop() {
  return done(device_.request(planner::kReqEnable, planner::EnableReq{0}));
}

Result<void> Planner::resume() {
  return done(device_.request(planner::kReqEnable, planner::EnableReq{1}));
}

Result<Path> Planner::path() {
  const auto answer = device_.request<planner::WaypointsReq>(planner::kReqGetWaypoints);
  if (!answer) return answer.error();
  Path path{{}, answer->waypoints_distance};
  for (const wire::Pose2d& waypoint : answer->waypoints) path.waypoints.push_back(pose(waypoint));
  return path;
}

}  // namespace playhouse::client
