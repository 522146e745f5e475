#pragma once

/// Pacer: schedules ticks on the wall clock. A value type without a clock of its
/// own, so that tests need not wait. Times are seconds of any monotonic clock.

#include <cstdint>
#include <optional>

namespace playhouse::run {

class Pacer {
 public:
  /// `interval` is one tick [s], > 0.
  explicit Pacer(double interval) : interval_(interval) {}

  /// The next tick is due at `now`; later ones at `speed`
  /// times real time (0: always due) unless paused.
  void start(double now, double speed, bool paused);

  /// Changes speed or pause. The rest of the interval is kept in
  /// simulated time, so that repeated changes cannot advance a tick.
  void change(double now, double speed, bool paused);

  /// When the next tick is due [s] unless paused; none: always due.
  std::optional<double> due() const;

  /// Counts a tick completed at `now`. A run that lags by more than kLag drops the lost time
  /// instead of catching up. While paused (single step) a whole interval remains afterwards.
  void ticked(double now);

  /// Simulated time per wall time over the last full second; 0 before the first.
  double real_time_factor() const { return factor_; }

  static constexpr double kLag = 0.25;  // s

 private:
  bool keeps_time() const { return !paused_ && speed_ > 0; }
  void measure(double now);

  double interval_;
  double speed_ = 1;
  bool paused_ = false;
  double due_ = 0;   // wall clock, if keeps_time()
  double left_ = 0;  // simulated s until the next tick, otherwise
  double factor_ = 0;
  double mark_ = 0;
  std::uint64_t ticks_since_mark_ = 0;
};

}  // namespace playhouse::run
