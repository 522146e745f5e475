#pragma once

/// PacedCommand: the latest command to hardware that gets one now and then, as its line has no time for each that clients
/// give. A value.

#include <optional>
#include <utility>

namespace playhouse::drivers {

template <typename T>
class PacedCommand {
 public:
  /// Replaces one that waits.
  void want(T command) { wanted_ = std::move(command); }
  /// There is time for one more.
  void allow() { may_send_ = true; }
  /// The one to send now; none if there is none, or no time for it.
  std::optional<T> take() {
    if (!may_send_ || !wanted_) return std::nullopt;
    may_send_ = false;
    return std::exchange(wanted_, std::nullopt);
  }
  void clear() { *this = {}; }

 private:
  std::optional<T> wanted_;
  bool may_send_ = false;
};

}  // namespace playhouse::drivers
