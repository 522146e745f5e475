#pragma once

/// LockStep: barrier synchronisation: the world advances only when every member has
/// requested ticks. Members are clients, named or not, or a part of the program. Between two
/// ticks they take turns in the order of names: a member may change the world only after
/// those before it have requested their step, so that the order of changes does not depend
/// on network timing. All functions are thread-safe; callbacks run without a lock held.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace playhouse::run {

class LockStep final {
 public:
  struct LockStepOptions {
    std::size_t members = 1;      // required for the first tick
    std::set<std::string> names;  // if not empty: only these may join
    double timeout = 0;  // s that the others wait for a silent member before it is dropped; 0: for ever
  };
  /// Opaque member identity, compared only.
  using Who = const void*;
  /// Called once: without a reason when the ticks are done and published, else with the reason why not.
  using Done = std::function<void(std::optional<std::string> why_not)>;

  explicit LockStep(LockStepOptions options) : options_(std::move(options)) {}

  /// An unnamed member joins implicitly with its first step(). `shown` is for the log. Returns
  /// why it may not join; empty if it may. Joining again under the same name has no effect.
  std::string join(Who who, std::string name, std::string shown);
  /// Requests `ticks` ticks on behalf of this member.
  void step(Who who, std::string shown, std::uint64_t ticks, Done done);
  /// Removes a member, if it is one, and cancels its step.
  void leave(Who who);
  bool has(Who who) const;

  /// True if a member may change the world now, or if it is not a member.
  bool may_act(Who who) const;
  /// Callbacks on every change of turns; add them before the run.
  void when_changed(std::function<void()> changed) { changed_.push_back(std::move(changed)); }

  // Tick thread.

  /// True if all required members have requested the next tick.
  bool is_due() const;
  /// The tick is done, but not published: members without remaining
  /// ticks may act again. Returns the callbacks to run after publishing.
  std::vector<Done> ticked();
  /// Poll while no tick is due: logs silent members, and drops them after the
  /// timeout. `now` [s] is a monotonic clock; time paused does not count.
  void look_for_silence(double now, bool paused);
  /// The run is over: pending and later requests fail with this reason.
  void close(const std::string& why);

 private:
  struct Member {
    Who who = nullptr;
    std::string name;  // empty: unnamed
    std::string shown;
    std::uint64_t joined = 0;  // sequence number
    std::uint64_t until = 0;   // last tick requested; while behind it, a member is in its step
    Done done;                 // set while it waits
    std::string text() const;
  };
  const Member* find(Who who) const;
  Member* find(Who who);
  std::string why_not(const std::string& name) const;
  void put(Member member);
  Done take_out(Who who);
  const Member* awaited() const;
  void tell() const;

  const LockStepOptions options_;
  std::vector<std::function<void()>> changed_;

  mutable std::mutex mutex_;     // guards what follows
  std::vector<Member> members_;  // by name, then by `joined`
  bool complete_ = false;        // all members required for the first tick have joined
  std::uint64_t ticks_ = 0;      // completed
  std::uint64_t next_joined_ = 0;
  std::string closed_;  // the reason; empty: open

  // Tick thread.
  struct Silence {
    Who who = nullptr;
    std::uint64_t ticks = 0;
    double since = 0;       // s
    double told_after = 0;  // s of silence until the next log line
  };
  Silence silence_;
};

}  // namespace playhouse::run
