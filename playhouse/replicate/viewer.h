#pragma once

/// Viewer: one page without its socket: its interest, its replica, its frames
/// in flight. Flow control: a page that acknowledges slowly gets fewer
/// frames; nothing is queued for it. Thread: the thread that serves viewers.

#include "playhouse/base/limits.h"
#include "playhouse/replicate/command.h"
#include "playhouse/replicate/delta.h"
#include "playhouse/replicate/scene_text.h"

namespace playhouse::replicate {

enum class Emit { kIfChanged, kAlways };

/// What to send to a viewer next, in this order.
struct NextFrame {
  std::shared_ptr<const std::string> changes;  // population update; null if unchanged
  bool packet = false;                         // a state packet was written
};

/// Cache of the last changes_text(): viewers mostly
/// need the same one. Null if the models are the same.
class ChangesTexts {
 public:
  explicit ChangesTexts(TellDevices devices = TellDevices::kYes) : devices_(devices) {}

  std::shared_ptr<const std::string> text(const std::shared_ptr<const Layout>& from,
                                          const std::shared_ptr<const Layout>& to);

 private:
  const TellDevices devices_;
  std::shared_ptr<const Layout> from_, to_;
  std::shared_ptr<const std::string> text_;
};

class Viewer {
 public:
  /// It holds this population, as scene_text() described it.
  explicit Viewer(std::shared_ptr<const Layout> layout) : replica_(std::move(layout)) {}

  const Wish& wish() const { return wish_; }

  void look(const Look& look);
  /// Selects the robot that a part belongs to. A model that does not exist clears the selection.
  void select(const Select& select);
  /// Fails on a frame number that was never sent.
  Result<void> acknowledge(std::uint32_t frame);

  /// False: too many frames in flight; ask again after an acknowledgement.
  bool ready() const { return sent_ - acknowledged_ < limits::kViewerFramesInFlight; }

  /// Writes the next packet, of about `budget` bytes, into `out` and counts it as sent. No packet: nothing
  /// to send, or not ready. `waiting()` then tells whether rows were deferred to the next frame.
  NextFrame next_frame(const Snapshot& snapshot, Emit emit, ChangesTexts& texts, std::vector<std::byte>& out,
                       std::size_t budget = limits::kViewerFrameBytes);
  bool waiting() const { return waiting_; }

 private:
  Wish wish_;
  Replica replica_;
  DeltaWriter writer_;
  std::uint32_t sent_ = 0, acknowledged_ = 0;
  bool waiting_ = false;
};

}  // namespace playhouse::replicate
