#pragma once

/// Pacer: when the next tick is due on the wall clock. A value type without a clock of its own, so that tests
/// need no waiting. Times are seconds of any steady clock.

#include <cstdint>
#include <optional>

namespace playhouse::drivers {

class Pacer {
 public:
  /// `interval` is one tick [s], > 0.
  explicit Pacer(double interval) : interval_(interval) {}

  /// The next tick is due at `now`; later ones follow at `speed` times real time (0: always due) unless
  /// paused.
  void start(double now, double speed, bool paused);

  /// Another speed, a pause or its end: what is left of the interval stays as it was, in simulated time, so
  /// that no number of changes brings a tick forward.
  void change(double now, double speed, bool paused);

  /// When the next tick is due [s] unless paused, or nothing when it always is.
  std::optional<double> due() const;

  /// Counts a tick done at `now`. A run that falls behind by more than kLag gives up the time it lost instead
  /// of racing to catch up. While paused (a single step) the whole interval lies ahead again.
  void ticked(double now);

  /// Simulated over wall time, over the last full second; 0 before the first.
  double real_time_factor() const { return factor_; }

  static constexpr double kLag = 0.25;  // s

 private:
  bool keeps_time() const { return !paused_ && speed_ > 0; }
  void measure(double now);

  double interval_;
  double speed_ = 1;
  bool paused_ = false;
  double due_ = 0;   // wall clock, if keeps_time()
  double left_ = 0;  // simulated s until the next tick, if not
  double factor_ = 0;
  double mark_ = 0;
  std::uint64_t ticks_since_mark_ = 0;
};

}  // namespace playhouse::drivers
