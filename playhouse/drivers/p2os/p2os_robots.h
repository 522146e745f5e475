#pragma once

/// Robots with an ActivMedia controller, by the subclass that they tell: units of what they send, and where their parts are.
/// Source: the maker's parameter files.

#include <span>
#include <string_view>

namespace playhouse::drivers::p2os {

/// On the robot: m, m, deg.
struct SonarPlace {
  double x, y, direction;
};

struct RobotModel {
  std::string_view subclass;  // all are of class "Pioneer"
  double angle_unit;          // rad, of headings
  double wheel_factor;        // 1/mm: turning by (right - left) * wheel_factor / 2, of distances in mm
  double distance_unit;       // mm, of the counters of x and y
  double range_unit;          // mm
  double speed_unit;          // mm/s, of the speeds that it tells
  int wheels_unit;            // mm/s, of the speeds of command WHEELS
  int sonars, front_bumpers, rear_bumpers;
  double length, width;                // m
  std::span<const SonarPlace> placed;  // of its sonars; empty: not known
};

std::span<const RobotModel> robot_models();
/// Upper and lower case are alike; null: unknown.
const RobotModel* find_robot_model(std::string_view subclass);

}  // namespace playhouse::drivers::p2os
