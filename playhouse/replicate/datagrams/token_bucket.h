#pragma once

/// TokenBucket: a budget in bytes a second, of which a tenth of a second's, but at least `least_burst`, can
/// be saved. A packet larger than what is left makes it negative. Times are of any steady clock. [s]

#include <algorithm>

namespace playhouse::replicate {

inline constexpr double kLeastPacket = 200;  // bytes; smaller packets are mostly header

class TokenBucket {
 public:
  /// Empty at first.
  TokenBucket(double bytes_per_second, double least_burst, double now)
      : rate_(bytes_per_second), most_(std::max(bytes_per_second / 10, least_burst)), filled_(now) {}

  void refill(double now) {
    left_ = std::min(left_ + (now - filled_) * rate_, most_);
    filled_ = now;
  }
  void spend(double bytes) { left_ -= bytes; }
  double left() const { return left_; }

 private:
  double rate_, most_, filled_;
  double left_ = 0;
};

}  // namespace playhouse::replicate
