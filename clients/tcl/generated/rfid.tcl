# Interface rfid, code 56. Reads and writes radio tags.
#
# Generated from interfaces/056_rfid.toml by codegen; do not edit.

::playhouse::wire::interface rfid 56 {
    # One tag. (player_rfid_tag_t)
    #   type: Type of tag.
    #   guid: Id of the tag, as bytes.
    struct Tag {
        type uint32
        guid char[]
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuIu type guid.count
        incr at 8
        set guid [opaque $body [length $body guid ${guid.count} 1]]
        return [dict create type $type guid $guid]
    } {
        append out [put uint32 [dict get $value type]]
        append out [count guid [string length [dict get $value guid]] 33554392]
        append out [count guid [string length [dict get $value guid]] 33554392]
        append out [pad guid [dict get $value guid]]
        return $out
    }

    # Tags in range. (player_rfid_data_t)
    struct Data {
        tags rfid.Tag[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu tags.count
        incr at 4
        set tags {}
        for {set tags.left [length $body tags ${tags.count} 12]} {${tags.left} > 0} {incr tags.left -1} {
            lappend tags [Tag.read $body]
        }
        return [dict create tags $tags]
    } {
        append out [count tags [llength [dict get $value tags]] 2796199]
        append out [count tags [llength [dict get $value tags]] 2796199]
        foreach item [dict get $value tags] {append out [Tag.write $item]}
        return $out
    }

    # Tags in range.
    message rfid.data.tags DATA 1 rfid.Data
    # Switches the reader on or off.
    message rfid.req.power REQ 1
    # Reads a tag.
    message rfid.req.readtag REQ 2
    # Writes a tag.
    message rfid.req.writetag REQ 3
    # Locks a tag against writing.
    message rfid.req.locktag REQ 4
}
