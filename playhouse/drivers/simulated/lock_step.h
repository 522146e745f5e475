#pragma once

/// LockStep: a world that goes on only when each of its members has said by how many ticks. Members are
/// clients, by name or not, or a part of the program. Between two ticks they have turns, in the order of
/// their names: who comes later may change the world only when those before have asked for their step, so
/// that what several change is carried out in an order that does not depend on whose bytes were faster.
/// Every function may be called from any thread; answers and tasks run without a lock held.

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "playhouse/device/turns.h"

namespace playhouse::drivers {

class LockStep final : public device::Turns {
 public:
  struct Options {
    std::size_t members = 1;      // that the first tick waits for
    std::set<std::string> names;  // if not empty: theirs, and nobody else's
    double timeout = 0;  // s that the others wait for a silent one, which is dropped then; 0: for ever
  };
  /// Opaque member identity, compared only.
  using Who = const void*;
  /// Called once: the ticks are done and their data published (nothing), or why they never will be.
  using Done = std::function<void(std::optional<std::string> why_not)>;

  explicit LockStep(Options options) : options_(std::move(options)) {}

  /// Who has not joined by name joins with its first step(). `shown` is for log lines. Gives why it may not;
  /// empty if it may. Joining again by the same name does nothing.
  std::string join(Who who, std::string name, std::string shown);
  /// The world may go on by `ticks`, as far as this member is concerned.
  void step(Who who, std::string shown, std::uint64_t ticks, Done done);
  /// No member any more; nothing if it was none. Its step is given up.
  void leave(Who who);
  bool has(Who who) const;

  bool may_act(const device::Caller& caller) const override;
  /// To be called before the run; every task is called then.
  void when_changed(std::function<void()> changed) override { changed_.push_back(std::move(changed)); }

  // Tick thread.

  /// All who have to have asked for the next tick.
  bool is_due() const;
  /// The tick is done, but not published: members that have all their ticks may act again. Gives what is to
  /// be called once it is.
  std::vector<Done> ticked();
  /// To be called every now and then while no tick is due: tells of who is silent, and drops it when its
  /// time is over. `now` [s] is that of a steady clock; while the world is paused nobody is late.
  void look_for_silence(double now, bool paused);
  /// The run is over: what waits is refused with this reason, as is everything that comes.
  void close(const std::string& why);

 private:
  struct Member {
    Who who = nullptr;
    std::string name;  // empty: it has none
    std::string shown;
    std::uint64_t joined = 0;  // a number that grows
    std::uint64_t until = 0;   // the tick that it has asked for; those behind are in its step
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

  const Options options_;
  std::vector<std::function<void()>> changed_;

  mutable std::mutex mutex_;     // guards what follows
  std::vector<Member> members_;  // by name, and then as they joined
  bool complete_ = false;        // all that the first tick waits for have joined
  std::uint64_t ticks_ = 0;      // done
  std::uint64_t next_joined_ = 0;
  std::string closed_;  // why; empty: it is not

  // Tick thread.
  struct Silence {
    Who who = nullptr;
    std::uint64_t ticks = 0;
    double since = 0;       // s
    double told_after = 0;  // s of silence that the next line is due after
  };
  Silence silence_;
};

}  // namespace playhouse::drivers
