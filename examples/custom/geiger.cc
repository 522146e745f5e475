// A sensor: counts decays of the sources around it. The rate of a source falls with the square of the
// distance, and each wall in between halves it.
//
//   custom( library "geiger BACKGROUND SOURCE" )
//
// BACKGROUND: counts per second without any source. SOURCE: the fiducial_return of models that are sources;
// each gives 100 counts per second at a distance of 1 m.
//
// Readings: 0 counts since the previous measurement, 1 counts since the start, 2 sources within its range.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "playhouse/geom/logarithm.h"
#include "playhouse/world/custom_library.h"

namespace pw = playhouse::world;
namespace geom = playhouse::geom;

namespace {

constexpr double kActivity = 100;  // counts per second at 1 m
constexpr double kRange = 10;      // m
constexpr double kNearest = 0.1;   // m; the rate is limited to that at this distance

double squared_distance(const geom::Pose& a, const geom::Pose& b) {
  const geom::Vec2 apart = a.xy() - b.xy();
  return geom::dot(apart, apart) + (a.z - b.z) * (a.z - b.z);
}

// Number of events for a given mean: Poisson-distributed, by the times between events; for large means a
// normal distribution as approximation.
double poisson(double mean, playhouse::Rng& random) {
  if (mean > 1000) return std::round(mean + std::sqrt(mean) * random.gaussian());
  constexpr double kLn10 = 2.302585092994046;
  double events = 0;
  for (double time = 0;; ++events) {
    time -= kLn10 * geom::log10(1 - random.uniform());
    if (time > mean) return events;
  }
}

class Geiger : public pw::CustomKind {
  Sizes configure(std::span<const std::string> arguments) override {
    if (arguments.size() != 2) throw std::invalid_argument("needs two arguments: BACKGROUND SOURCE");
    background_ = std::stod(arguments[0]);
    source_ = std::stoi(arguments[1]);
    if (background_ < 0 || source_ == 0)
      throw std::invalid_argument("BACKGROUND is at least 0, SOURCE not 0");
    return {.readings = 3};
  }

  void sense(pw::CustomSensor& self) const override {
    const pw::Models& models = self.world.models;
    const geom::Pose& X_WM = models.X_WM[self.model];
    std::vector<pw::ModelRow> near;
    self.around.near(X_WM, kRange, near);
    double rate = background_, sources = 0;
    for (const pw::ModelRow other : near) {
      if (models.fiducial_return[other] != source_) continue;
      const geom::Pose& X_WO = models.X_WM[other];
      const double squared = std::max(squared_distance(X_WM, X_WO), kNearest * kNearest);
      rate += kActivity / squared * std::ldexp(1.0, -self.around.walls_between(X_WM, X_WO));
      ++sources;
    }
    const double period = std::max(self.world.desc(self.model).update_interval, self.dt);
    const double counts = poisson(rate * period, self.random);
    self.readings[0] = counts;
    self.readings[1] += counts;
    self.readings[2] = sources;
  }

  double background_ = 0;
  int source_ = 0;
};

}  // namespace

PLAYHOUSE_CUSTOM_KIND(Geiger)
