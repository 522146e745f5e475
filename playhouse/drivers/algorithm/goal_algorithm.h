#pragma once

/// GoalAlgorithm: base of algorithms that drive a robot to goals, a position2d in front of others. Goals are
/// handled by steps of the subclass; everything else is forwarded. The input gives the pose, the output gets
/// velocities and requests; they may be one device.

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/geom/pose.h"
#include "playhouse/wire/generated/planner.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

class GoalAlgorithm : public Algorithm {
 public:
  /// Output and input are numbers of used devices.
  GoalAlgorithm(Shell& shell, std::size_t output, std::size_t input);

  void opened() override;
  void closing() override;
  void closed() override;
  void take_news(std::vector<device::Publication>& more) override;
  void rewound(const Moment& moment) override;

 protected:
  /// What a step drives to and from.
  struct Trip {
    std::uint64_t drive = 0;  // number of the drive, which may have several goals
    geom::Pose X_OG;
    wire::position2d::Data state;  // latest of the input
  };
  /// How a step ends a drive.
  enum class DriveEnd : std::uint8_t { kNot, kAtGoal, kStuck };

  /// For the constructor of a subclass whose goals a planner takes, too: number `device` of those provided, if
  /// it is (goal_planner.cc).
  void offer_planner(std::size_t device);
  /// Requests the geometry of the used devices.
  virtual void ask_geometry() = 0;
  /// Posts a step if there are new scans.
  virtual void take_scans() = 0;
  /// True if a step can use the state.
  virtual bool is_usable_state(const wire::position2d::Data& state) const;
  /// Logs why it drives to no goals until it is opened again, and refuses the current one.
  void drives_to_none(std::string why);

  /// None without a goal or a state. With mutex_ held.
  std::optional<Trip> trip() const;
  /// Applies the result of a step, unless its drive has ended.
  void steer(const Trip& trip, double speed, double turn_rate, DriveEnd end);

  Shell& shell_;
  mutable std::mutex mutex_;  // guards what a subclass learns on other threads than its own, and what follows

 private:
  struct Goal {
    geom::Pose X_OG;
    std::uint64_t drive = 0;
  };
  /// `start`: enables, too.
  device::Taken take_goal(const wire::position2d::CmdPos& command, bool start);
  device::Taken take_other(const device::Message& message);
  bool set_goal(std::optional<geom::Pose> X_OG);
  void refuse(std::string why);
  void take_state(device::Publication& message);
  void drive(double speed, double turn_rate);
  void enable(bool enabled);
  wire::planner::Data planner_state() const;
  wire::planner::WaypointsReq waypoints() const;

  std::optional<Goal> goal_;
  std::uint64_t drives_ = 0;  // so far
  bool gave_up_ = false;      // the last goal, being stuck
  std::string refusal_;       // of the last goal (refusal.h); empty: none
  std::string incapable_;     // why it drives to no goals; empty: it does
  std::optional<wire::position2d::Data> state_;

  // Of the planner.
  std::optional<std::size_t> planner_;  // its number; not guarded
  std::optional<geom::Pose> X_OD_;      // the goal of the last drive, until another command than a goal
  bool done_ = false;                   // with that drive
  bool enabled_ = true;

  const std::size_t output_;
  device::Subscription& position_;
};

}  // namespace playhouse::drivers
