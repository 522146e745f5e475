/** Generated from interfaces/064_blackboard.toml by codegen; do not edit. */
#include "playhouse/c/generated/blackboard.h"

#include <stddef.h>

const ph_message_type ph_blackboard_messages[7] = {
    {64, PH_KIND_DATA, 1, "blackboard.data.update", &ph_common_blackboard_entry_type},
    {64, PH_KIND_REQ, 1, "blackboard.req.subscribe_to_key", &ph_common_blackboard_entry_type},
    {64, PH_KIND_REQ, 2, "blackboard.req.unsubscribe_from_key", &ph_common_blackboard_entry_type},
    {64, PH_KIND_REQ, 3, "blackboard.req.set_entry", &ph_common_blackboard_entry_type},
    {64, PH_KIND_REQ, 4, "blackboard.req.subscribe_to_group", &ph_common_blackboard_entry_type},
    {64, PH_KIND_REQ, 5, "blackboard.req.unsubscribe_from_group", &ph_common_blackboard_entry_type},
    {64, PH_KIND_REQ, 6, "blackboard.req.get_entry", &ph_common_blackboard_entry_type},
};
