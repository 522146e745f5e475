#pragma once

/// Replace rules of a session's queue: the first matching rule decides. A value.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "playhouse/server/frame.h"

namespace playhouse::server {

enum class QueueAction : std::uint8_t {
  kAccept,   // append
  kReplace,  // remove the newest message of the same kind, then append
  kIgnore,   // drop
};

/// A negative field matches anything.
struct ReplaceRule {
  std::int32_t interf = -1;
  std::int32_t index = -1;
  std::int32_t type = -1;
  std::int32_t subtype = -1;
  QueueAction action = QueueAction::kAccept;
};

class ReplaceRules {
 public:
  /// A rule with equal criteria gets the new action in its old position,
  /// otherwise the rule is appended. False at limits::kSessionRules.
  bool add(const ReplaceRule& rule);
  /// kAccept if no rule matches.
  QueueAction action_for(const Frame& frame) const;

 private:
  std::vector<ReplaceRule> rules_;
};

}  // namespace playhouse::server
