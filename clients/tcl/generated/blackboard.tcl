# Interface blackboard, code 64. Named values shared by clients.
#
# Generated from interfaces/064_blackboard.toml by codegen; do not edit.

::playhouse::wire::interface blackboard 64 {
    # Subscribes to one entry; the answer has its value.
    message blackboard.req.subscribe_to_key REQ 1 common.BlackboardEntry
    # Unsubscribes one entry.
    message blackboard.req.unsubscribe_from_key REQ 2 common.BlackboardEntry
    # Sets an entry.
    message blackboard.req.set_entry REQ 3 common.BlackboardEntry
    # Subscribes to all entries of a group.
    message blackboard.req.subscribe_to_group REQ 4 common.BlackboardEntry
    # Unsubscribes a group.
    message blackboard.req.unsubscribe_from_group REQ 5 common.BlackboardEntry
    # Requests an entry once.
    message blackboard.req.get_entry REQ 6 common.BlackboardEntry
    # A subscribed entry has changed.
    message blackboard.data.update DATA 1 common.BlackboardEntry
}
