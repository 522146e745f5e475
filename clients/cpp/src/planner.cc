#include "playhouse_client/planner.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "convert.h"
#include "done.h"
#include "finite.h"
#include "refusal.h"

namespace playhouse::client {

namespace planner = wire::planner;

namespace {

/// Whether two poses are the same, whole turns aside, which drivers drop.
bool same(const Pose& one, const Pose& other) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return one.x == other.x && one.y == other.y && std::abs(std::remainder(one.a - other.a, kTurn)) < 1e-6;
}

constexpr int kStatesUnderWay = 2;    // of another goal, after an answer
constexpr double kRefusalPeriod = 1;  // of the server's time [s], between two questions while there is a path

Error without_data(const Device& device, Seconds patience) {
  return {device.name(), "no data in " + std::to_string(patience.count()) + " s"};
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

Result<std::string> Planner::why_refused() {
  return refusal_of(device_);
}

Result<void> Planner::next_data(Client& client, Seconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!device_.take_fresh()) {
    const Seconds left = deadline - std::chrono::steady_clock::now();
    if (left <= Seconds(0)) return without_data(device_, patience);
    if (const auto read = client.read(left); !read) return read.error();
    if (device_.gone()) return done(refusal_of(device_));
  }
  return {};
}

Result<void> Planner::drive_to(Client& client, const Pose& pose, Seconds patience) {
  if (const auto sent = go_to(pose); !sent) return sent;
  std::optional<double> asked;  // when, by the server's time
  int others = 0;               // states of another goal since
  while (true) {
    if (const auto fresh = next_data(client, patience); !fresh) return fresh;
    if (arrived()) return {};
    const std::optional<PlannerState> now = state();
    if (!now) continue;
    const bool is_mine = same(now->goal, *goal_);
    // Once a request was answered, which came after the goal, data of before it may still be on their way.
    others = is_mine || !asked ? 0 : others + 1;
    if (others > kStatesUnderWay) return Error{device_.name(), "it has another goal, or no longer one"};
    if (now->valid && is_mine && asked && now->time >= *asked && now->time < *asked + kRefusalPeriod)
      continue;
    asked = now->time;
    const Result<std::string> why = why_refused();
    if (!why) return why.error();
    if (!why->empty()) return Error{device_.name(), *why};
  }
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
