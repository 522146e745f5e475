#pragma once

/// Inbox: hand-over from the io thread to the tick thread. Commands are
/// latest-value slots, one per model; everything else is a bounded
/// queue of requests. Per model the order is kept: a change seals the model's
/// slots, so earlier commands are executed before it and later ones after it.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <utility>
#include <variant>
#include <vector>

#include "playhouse/world/changes/journal.h"

namespace playhouse::run {

/// A request: looks at the world, decides, changes it by the journal, and answers.
using Request = std::function<void(world::Journal&)>;

class Inbox {
 public:
  /// A command is a change and nothing more.
  using InboxEntry = std::variant<world::Change, Request>;

  /// Replaces the command of its model that waits, or appends it.
  void command(world::Change command);

  /// False, without effect, if limits::kRequestQueue changes are
  /// queued, or after close(). `model`, if any, is the model concerned.
  bool post(Request request, world::ModelId model = {});

  /// As post(), for a change that concerns all models.
  bool post_to_all(Request request);

  /// As post(), but rejected only after close(): for changes that must
  /// not be lost and are bounded by their sender (closing a device).
  void post_always(Request request, world::ModelId model = {});

  /// Moves all entries to `out` (cleared first), in order.
  void take(std::vector<InboxEntry>& out);

  bool empty() const;

  /// Rejects everything from now on. Queued entries stay for take().
  void close();
  bool closed() const;

 private:
  void append(Request request, world::ModelId model);

  mutable std::mutex mutex_;
  std::vector<InboxEntry> entries_;
  std::map<world::ModelId, std::size_t> slots_;  // replaceable commands: index in entries_
  std::size_t changes_ = 0;
  bool closed_ = false;
};

}  // namespace playhouse::run
