/** Interface blackboard, code 64. Named values shared by clients. Generated from
 * interfaces/064_blackboard.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_BLACKBOARD_H
#define PLAYHOUSE_C_GENERATED_BLACKBOARD_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_BLACKBOARD_CODE 64

/** The messages, each under its name below. */
extern const ph_message_type ph_blackboard_messages[7];
/** A subscribed entry has changed. */
#define PH_BLACKBOARD_DATA_UPDATE (&ph_blackboard_messages[0])
/** Subscribes to one entry; the answer has its value. */
#define PH_BLACKBOARD_REQ_SUBSCRIBE_TO_KEY (&ph_blackboard_messages[1])
/** Unsubscribes one entry. */
#define PH_BLACKBOARD_REQ_UNSUBSCRIBE_FROM_KEY (&ph_blackboard_messages[2])
/** Sets an entry. */
#define PH_BLACKBOARD_REQ_SET_ENTRY (&ph_blackboard_messages[3])
/** Subscribes to all entries of a group. */
#define PH_BLACKBOARD_REQ_SUBSCRIBE_TO_GROUP (&ph_blackboard_messages[4])
/** Unsubscribes a group. */
#define PH_BLACKBOARD_REQ_UNSUBSCRIBE_FROM_GROUP (&ph_blackboard_messages[5])
/** Requests an entry once. */
#define PH_BLACKBOARD_REQ_GET_ENTRY (&ph_blackboard_messages[6])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_BLACKBOARD_H */
