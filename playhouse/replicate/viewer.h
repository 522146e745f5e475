#pragma once

/// Viewer: one watching page, without its socket: what it looks at, what it holds, how many frames are under
/// way. A page that acknowledges slowly gets fewer frames; nothing queues for it. Thread: the thread that
/// serves viewers.

#include "playhouse/base/limits.h"
#include "playhouse/replicate/command.h"
#include "playhouse/replicate/delta.h"

namespace playhouse::replicate {

enum class Emit { kIfChanged, kAlways };

/// What goes to a viewer next, in this order.
struct NextFrame {
  std::shared_ptr<const std::string> changes;  // of the population; none if it is the same
  bool packet = false;                         // there is one
};

/// changes_text() of the last two populations that somebody asked for: viewers mostly ask for the same. None
/// where they are the same models.
class ChangesTexts {
 public:
  std::shared_ptr<const std::string> text(const std::shared_ptr<const Layout>& from,
                                          const std::shared_ptr<const Layout>& to);

 private:
  std::shared_ptr<const Layout> from_, to_;
  std::shared_ptr<const std::string> text_;
};

class Viewer {
 public:
  /// It holds this population, as scene_text() says.
  explicit Viewer(std::shared_ptr<const Layout> layout) : replica_(std::move(layout)) {}

  const Wish& wish() const { return wish_; }

  void look(const Look& look);
  /// The robot of a part is selected, not the part. One that is not there, or no more, is none.
  void select(const Select& select);
  /// Fails for a frame that was never sent.
  Result<void> acknowledge(std::uint32_t frame);

  /// False: too many frames are unacknowledged; ask again when one comes back.
  bool ready() const { return sent_ - acknowledged_ < limits::kViewerFramesInFlight; }

  /// Writes the next packet into `out` and counts it as sent. No packet: there is nothing to send, or the
  /// viewer is not ready. `waiting()` then says whether rows are left for the next frame.
  NextFrame next_frame(const Snapshot& snapshot, Emit emit, ChangesTexts& texts, std::vector<std::byte>& out);
  bool waiting() const { return waiting_; }

 private:
  Wish wish_;
  Replica replica_;
  DeltaWriter writer_;
  std::uint32_t sent_ = 0, acknowledged_ = 0;
  bool waiting_ = false;
};

}  // namespace playhouse::replicate
