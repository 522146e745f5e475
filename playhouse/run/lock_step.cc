#include "playhouse/run/lock_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"

namespace playhouse::run {
namespace {

/// First report of silence; then at every doubling. [s]
constexpr double kFirstTold = 5;

}  // namespace

std::string LockStep::Member::text() const {
  return name.empty() ? shown : fmt::format("{} ({})", in_quotes(name), shown);
}

const LockStep::Member* LockStep::find(Who who) const {
  const auto found = std::ranges::find(members_, who, &Member::who);
  return found == members_.end() ? nullptr : &*found;
}

LockStep::Member* LockStep::find(Who who) {
  return const_cast<Member*>(std::as_const(*this).find(who));
}

std::string LockStep::why_not(const std::string& name) const {
  if (!closed_.empty()) return closed_;
  const bool by_name = !options_.names.empty();
  if (by_name && name.empty()) return "clients of this world join by name first";
  if (by_name && !options_.names.contains(name))
    return fmt::format("this world does not wait for {}", in_quotes(name));
  if (!name.empty() && std::ranges::find(members_, name, &Member::name) != members_.end())
    return fmt::format("{} has joined already", in_quotes(name));
  if (members_.size() >= options_.members) return "all that this world waits for have joined";
  return {};
}

void LockStep::put(Member member) {
  member.joined = next_joined_++;
  member.until = ticks_;
  const auto key = [](const Member& each) { return std::tie(each.name, each.joined); };
  members_.insert(std::ranges::upper_bound(members_, key(member), {}, key), std::move(member));
  complete_ = complete_ || members_.size() == options_.members;
}

std::string LockStep::join(Who who, std::string name, std::string shown) {
  {
    const std::lock_guard lock(mutex_);
    const Member* member = find(who);
    if (member != nullptr) return member->name == name ? "" : "it has joined by another name";
    if (std::string why = why_not(name); !why.empty()) return why;
    put({.who = who, .name = std::move(name), .shown = std::move(shown), .done = {}});
  }
  tell();
  return {};
}

void LockStep::step(Who who, std::string shown, std::uint64_t ticks, Done done) {
  std::string refused;
  {
    const std::lock_guard lock(mutex_);
    if (find(who) == nullptr) {
      refused = why_not({});
      if (refused.empty()) put({.who = who, .name = {}, .shown = std::move(shown), .done = {}});
    }
    Member* member = find(who);
    if (refused.empty() && !closed_.empty()) refused = closed_;
    if (refused.empty() && member->done) refused = "its last step is not done yet";
    if (refused.empty()) {
      member->until = ticks_ + ticks;
      member->done = std::move(done);
    }
  }
  if (!refused.empty()) return done(std::move(refused));
  tell();
}

LockStep::Done LockStep::take_out(Who who) {
  Member* member = find(who);
  if (member == nullptr) return {};
  Done done = std::move(member->done);
  members_.erase(members_.begin() + (member - members_.data()));
  if (members_.empty()) complete_ = false;  // the next member starts anew
  return done;
}

void LockStep::leave(Who who) {
  Done done;
  {
    const std::lock_guard lock(mutex_);
    if (find(who) == nullptr) return;
    done = take_out(who);
  }
  if (done) done("it left");
  tell();
}

bool LockStep::has(Who who) const {
  const std::lock_guard lock(mutex_);
  return find(who) != nullptr;
}

bool LockStep::may_act(Who who) const {
  const std::lock_guard lock(mutex_);
  const Member* member = find(who);
  if (member == nullptr || !closed_.empty()) return true;
  if (!complete_ || member->done) return false;
  return std::all_of(members_.data(), member, [](const Member& before) { return bool{before.done}; });
}

bool LockStep::is_due() const {
  const std::lock_guard lock(mutex_);
  return complete_ && awaited() == nullptr;
}

/// The first member without a pending step.
const LockStep::Member* LockStep::awaited() const {
  const auto found = std::ranges::find_if(members_, [](const Member& member) { return !member.done; });
  return found == members_.end() ? nullptr : &*found;
}

std::vector<LockStep::Done> LockStep::ticked() {
  std::vector<Done> done;
  {
    const std::lock_guard lock(mutex_);
    ++ticks_;
    for (Member& member : members_)
      if (member.done && member.until <= ticks_) done.push_back(std::exchange(member.done, {}));
  }
  tell();
  return done;
}

void LockStep::look_for_silence(double now, bool paused) {
  std::string silent;
  bool dropped = false;
  {
    const std::lock_guard lock(mutex_);
    const Member* member = complete_ ? awaited() : nullptr;
    const Who who = member == nullptr ? nullptr : member->who;
    if (paused || who != silence_.who || ticks_ != silence_.ticks) silence_ = {who, ticks_, now, kFirstTold};
    if (member == nullptr) return;
    const double seconds = now - silence_.since;
    dropped = options_.timeout > 0 && seconds >= options_.timeout;
    if (!dropped && seconds < silence_.told_after) return;
    silent = fmt::format("lock-step: client {} has been silent for {:.1f} s{}", member->text(), seconds,
                         dropped ? "; the others go on without it" : ", and the world waits for it");
    silence_.told_after *= 2;
    if (dropped) take_out(who);  // it has no pending step
  }
  log::warn("{}", silent);
  if (dropped) tell();
}

void LockStep::close(const std::string& why) {
  std::vector<Done> refused;
  {
    const std::lock_guard lock(mutex_);
    closed_ = why;
    for (Member& member : members_)
      if (member.done) refused.push_back(std::exchange(member.done, {}));
  }
  for (const Done& done : refused) done(why);
  tell();
}

void LockStep::tell() const {
  for (const std::function<void()>& changed : changed_) changed();
}

}  // namespace playhouse::run
