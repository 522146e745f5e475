// Generated from interfaces/064_blackboard.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/blackboard.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::blackboard {

const MessageDef kRows[7] = {
    {64, MessageType::kData, kDataUpdate, "blackboard.data.update", "BlackboardEntry", true, Policy::kQueue,
     check_required<BlackboardEntry>, reencode<BlackboardEntry>, body_to_json<BlackboardEntry>},
    {64, MessageType::kReq, kReqSubscribeToKey, "blackboard.req.subscribe_to_key", "BlackboardEntry", true, Policy::kNone,
     check_optional<BlackboardEntry>, reencode<BlackboardEntry>, body_to_json<BlackboardEntry>},
    {64, MessageType::kReq, kReqUnsubscribeFromKey, "blackboard.req.unsubscribe_from_key", "BlackboardEntry", true, Policy::kNone,
     check_optional<BlackboardEntry>, reencode<BlackboardEntry>, body_to_json<BlackboardEntry>},
    {64, MessageType::kReq, kReqSetEntry, "blackboard.req.set_entry", "BlackboardEntry", true, Policy::kNone,
     check_optional<BlackboardEntry>, reencode<BlackboardEntry>, body_to_json<BlackboardEntry>},
    {64, MessageType::kReq, kReqSubscribeToGroup, "blackboard.req.subscribe_to_group", "BlackboardEntry", true, Policy::kNone,
     check_optional<BlackboardEntry>, reencode<BlackboardEntry>, body_to_json<BlackboardEntry>},
    {64, MessageType::kReq, kReqUnsubscribeFromGroup, "blackboard.req.unsubscribe_from_group", "BlackboardEntry", true, Policy::kNone,
     check_optional<BlackboardEntry>, reencode<BlackboardEntry>, body_to_json<BlackboardEntry>},
    {64, MessageType::kReq, kReqGetEntry, "blackboard.req.get_entry", "BlackboardEntry", true, Policy::kNone,
     check_optional<BlackboardEntry>, reencode<BlackboardEntry>, body_to_json<BlackboardEntry>},
};

}  // namespace playhouse::wire::blackboard
