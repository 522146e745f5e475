#pragma once

/// SiteWorld: the simulated world that drivers of one file share, for drivers that know no engine. The bridge has the
/// one that there is (bridge/simulated/simulated_world.h).

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "playhouse/device/address.h"

namespace playhouse::drivers {

/// Of a run, at its start and after it went back or started again.
struct Moment {
  std::uint64_t tick = 0;
  double time = 0;         // s
  std::uint64_t seed = 0;  // of random numbers
};

/// A driver that keeps to the ticks of a run. Tick thread.
class RunListener {
 public:
  virtual ~RunListener() = default;
  virtual void ticked(std::uint64_t tick) = 0;
  /// The run goes on from there.
  virtual void rewound(const Moment& moment) = 0;
  /// The world put the robot elsewhere, as by RESET.
  virtual void placed() = 0;
};

class SiteWorld {
 public:
  virtual ~SiteWorld() = default;
  /// Simulated time. Any thread. [s]
  virtual double time() const = 0;
  /// Runs the task between two ticks, soon. Any thread.
  virtual void between_ticks(std::function<void()> task) = 0;
  /// This device is of no model any more. Tick thread.
  virtual void forget(device::Address device) = 0;
  /// How many sensors the model of a device has; 1 without a model. Before the run.
  virtual std::size_t sensors_of(device::Address device) const = 0;
  /// `own` are devices of the model of the device `robot` from now on; the listener, which outlives the run, hears
  /// of that model. Before the run, whose state is returned.
  virtual Moment join(device::Address robot, std::span<const device::Address> own, RunListener& listener) = 0;
};

}  // namespace playhouse::drivers
