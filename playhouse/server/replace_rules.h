#pragma once

/// What a session's queue does with a message: the rules a client added, the first match decides. A value.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "playhouse/server/frame.h"

namespace playhouse::server {

enum class QueueAction : std::uint8_t {
  kAccept,   // append
  kReplace,  // take out the newest message of the same kind, then append
  kIgnore,   // leave out
};

/// A negative field matches everything.
struct ReplaceRule {
  std::int32_t interf = -1;
  std::int32_t index = -1;
  std::int32_t type = -1;
  std::int32_t subtype = -1;
  QueueAction action = QueueAction::kAccept;
};

class ReplaceRules {
 public:
  /// A rule with the same criteria gets the new action in its old place, else the rule goes to the end. False
  /// if there are limits::kSessionRules already.
  bool add(const ReplaceRule& rule);
  /// kAccept if no rule matches.
  QueueAction action_for(const Frame& frame) const;

 private:
  std::vector<ReplaceRule> rules_;
};

}  // namespace playhouse::server
