#pragma once

/// Layout: what never changes while a world runs, as a viewer needs it: who is part of whom, which sensor
/// belongs to which model, and the quantised state at the start, which is every viewer's first baseline. Made
/// once from the world, before its first tick, then shared read-only by all threads.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::replicate {

/// One model as viewers see it.
struct ModelState {
  std::int32_t x = 0, y = 0, z = 0;  // pose in the parent  [mm]
  std::uint16_t a = 0;               // heading             [1/65536 turn]
  std::uint8_t state = 0;            // bits below
  std::uint32_t color = 0;           // 0xRRGGBBAA
  friend bool operator==(const ModelState&, const ModelState&) = default;
};

inline constexpr std::uint8_t kStalled = 1;     // its last motion was blocked
inline constexpr std::uint8_t kSubscribed = 2;  // somebody reads or drives it
inline constexpr std::uint8_t kMotorOff = 4;

/// What a selected robot believes and does.
struct PositionState {
  std::int32_t vx = 0, vy = 0;  // velocity in the body frame  [mm/s]
  std::int32_t va = 0;          // turn rate                   [mrad/s]
  std::int32_t ox = 0, oy = 0;  // odometry                    [mm]
  std::uint16_t oa = 0;         // odometry heading            [1/65536 turn]
  friend bool operator==(const PositionState&, const PositionState&) = default;
};

struct SensorLayout {
  std::uint32_t ranger = 0, model = 0;  // rows
  std::uint32_t first_beam = 0, beam_count = 0;
  double range_max = 0;  // m; a beam is sent as range / range_max * 65535
};

inline constexpr std::uint8_t kMovable = 1;   // a person may drag it
inline constexpr std::uint8_t kAlwaysOn = 2;  // measures without subscribers

struct Layout {
  explicit Layout(const world::World& world);

  std::vector<std::uint32_t> root;            // per model
  std::vector<std::uint8_t> traits;           // per model: the bits above
  std::vector<SensorLayout> sensors;          // per sensor row
  std::vector<std::uint32_t> position_model;  // per position row
  std::vector<std::uint32_t> finder_model;    // per fiducial finder row
  std::vector<ModelState> start;              // per model

  /// Every model of the robot with this top-level row, itself first.
  std::span<const std::uint32_t> tree(std::uint32_t root_row) const;
  /// The position rows of that robot; usually one.
  std::span<const std::uint32_t> tree_positions(std::uint32_t root_row) const;

 private:
  std::vector<std::uint32_t> tree_start_, tree_rows_;
  std::vector<std::uint32_t> position_start_, position_rows_;
};

/// Quantised state of one model.
ModelState model_state(const world::World& world, std::uint32_t row);

/// [m] to [mm] and the like: rounds, clips to 32 bits, 0 for what is not a number.
std::int32_t quantize(double value, double per_unit);
/// [rad] to 1/65536 turn.
std::uint16_t quantize_angle(double radians);
/// [m] to a fraction of the sensor's range_max, 65535 at or beyond it.
std::uint16_t quantize_range(double range, double range_max);

}  // namespace playhouse::replicate
