#pragma once

/// The nearness diagram: nearest obstacles around a robot by sectors, and the region that leads to a goal.
/// Pure functions; their arithmetic gives the same bits on every machine. Everything is in the frame of
/// the robot, R.

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

/// Range of consideration [m].
inline constexpr double kNdSight = 4;

/// The nearest obstacle points of a sector.
struct NdSector {
  double distance = kNdSight;   // m; from the robot's center of rotation
  geom::Vec2 p_RC;              // the point at this distance
  double clearance = kNdSight;  // m; from the body, least of the sector
  geom::Vec2 nearest;           // the point with this clearance
  bool occupied() const { return distance < kNdSight; }
};

class NdDiagram {
 public:
  static constexpr std::size_t kSectors = 144;
  static constexpr double kWidth = geom::kTwoPi / kSectors;  // rad

  explicit NdDiagram(const geom::Box& body) : body_(body) {}

  /// Points inside the body and beyond sight don't count.
  void add(geom::Vec2 p_RC);

  std::span<const NdSector> sectors() const { return sectors_; }
  const NdSector& operator[](std::size_t sector) const { return sectors_[sector]; }
  /// Of a sector's middle, from -pi on.
  static double bearing(std::size_t sector);

 private:
  geom::Box body_;
  std::array<NdSector, kSectors> sectors_;
};

/// Distance of a point from a body; 0 inside.
double clearance(const geom::Box& body, geom::Vec2 p);

/// A region through which the robot can drive on.
struct NdRegion {
  double direction = 0;  // to drive in for it [rad]
  bool has_goal = false;
  bool wide = false;
};

struct NdWay {
  double radius = 0;           // m; half the width that the robot needs
  double spare = 0;            // m; of that, what the region chosen last may lack
  double avoid_distance = 0;   // m; to keep from obstacles where there is room
  geom::Vec2 p_RG;             // the goal
  std::optional<double> last;  // direction of the region chosen last [rad]
};

/// True if no obstacles closer together than the robot's width are between the robot and a point.
bool can_reach(const NdDiagram& diagram, double radius, geom::Vec2 p_RP);

/// The region of the goal if it can be reached, else of the gap nearest to its direction; none if
/// all directions are blocked.
std::optional<NdRegion> choose_region(const NdDiagram& diagram, const NdWay& way);

}  // namespace playhouse::drivers
