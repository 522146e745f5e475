#include "playhouse/server/replace_rules.h"

#include <algorithm>

#include "playhouse/base/limits.h"

namespace playhouse::server {
namespace {

bool same_field(std::int32_t a, std::int32_t b) {
  return a == b || (a < 0 && b < 0);
}

bool same_criteria(const ReplaceRule& a, const ReplaceRule& b) {
  return same_field(a.interf, b.interf) && same_field(a.index, b.index) && same_field(a.type, b.type) &&
         same_field(a.subtype, b.subtype);
}

bool matches(const ReplaceRule& rule, const Frame& frame) {
  const auto field = [](std::int32_t wanted, std::int32_t actual) { return wanted < 0 || wanted == actual; };
  return field(rule.interf, frame.interf) && field(rule.index, frame.index) &&
         field(rule.type, static_cast<std::int32_t>(frame.type)) && field(rule.subtype, frame.subtype);
}

}  // namespace

bool ReplaceRules::add(const ReplaceRule& rule) {
  const auto found = std::find_if(rules_.begin(), rules_.end(),
                                  [&](const ReplaceRule& old) { return same_criteria(old, rule); });
  if (found != rules_.end()) {
    found->action = rule.action;
    return true;
  }
  if (rules_.size() >= limits::kSessionRules) return false;
  rules_.push_back(rule);
  return true;
}

QueueAction ReplaceRules::action_for(const Frame& frame) const {
  const auto found = std::find_if(rules_.begin(), rules_.end(),
                                  [&](const ReplaceRule& rule) { return matches(rule, frame); });
  return found == rules_.end() ? QueueAction::kAccept : found->action;
}

}  // namespace playhouse::server
