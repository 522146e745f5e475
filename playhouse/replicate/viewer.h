#pragma once

/// Viewer: one watching page, without its socket: what it looks at, what it holds, how many frames are under
/// way. A page that acknowledges slowly gets fewer frames; nothing queues for it. Thread: the thread that
/// serves viewers.

#include "playhouse/base/limits.h"
#include "playhouse/replicate/command.h"
#include "playhouse/replicate/delta.h"

namespace playhouse::replicate {

enum class Emit { kIfChanged, kAlways };

class Viewer {
 public:
  explicit Viewer(const Layout& layout) : layout_(&layout), replica_(layout), writer_(layout) {}

  const Wish& wish() const { return wish_; }

  void look(const Look& look);
  /// Fails when there is no such row. The robot of a part is selected, not the part.
  Result<void> select(const Select& select);
  /// Fails for a frame that was never sent.
  Result<void> acknowledge(std::uint32_t frame);

  /// False: too many frames are unacknowledged; ask again when one comes back.
  bool ready() const { return sent_ - acknowledged_ < limits::kViewerFramesInFlight; }

  /// Writes the next frame into `out` and counts it as sent. False: there is nothing to send, or the viewer
  /// is not ready. `waiting()` then says whether rows are left for the next frame.
  bool next_frame(const Snapshot& snapshot, Emit emit, std::vector<std::byte>& out);
  bool waiting() const { return waiting_; }

 private:
  const Layout* layout_;
  Wish wish_;
  Replica replica_;
  DeltaWriter writer_;
  std::uint32_t sent_ = 0, acknowledged_ = 0;
  bool waiting_ = false;
};

}  // namespace playhouse::replicate
