# Interface log, code 45. Records data of devices to a file, or plays back such a file.
#
# Generated from interfaces/045_log.toml by codegen; do not edit.

::playhouse::wire::interface log 45 {
    # Values of GetState.type.
    variable TYPE_READ 1
    variable TYPE_WRITE 2

    # Whether data is being recorded. (player_log_set_write_state_t)
    #   state: 1: on, 0: off.
    struct SetWriteState {
        state uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu state
        incr at 4
        set state [low 0xff $state]
        return [dict create state $state]
    } {
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # Whether the file is being played. (player_log_set_read_state_t)
    #   state: 1: on, 0: off.
    struct SetReadState {
        state uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu state
        incr at 4
        set state [low 0xff $state]
        return [dict create state $state]
    } {
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # Type and state of the device. (player_log_get_state_t)
    #   type: Reader or writer.
    #   state: 1: running, 0: stopped.
    struct GetState {
        type uint8
        state uint8
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuIu type state
        incr at 8
        set type [low 0xff $type]
        set state [low 0xff $state]
        return [dict create type $type state $state]
    } {
        append out [put uint8 [dict get $value type]]
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # The file to write to. (player_log_set_filename_t)
    #   filename: NUL-terminated.
    struct SetFilename {
        filename char[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        incr at 4
        set filename [opaque $body [length $body filename 256 1]]
        return [dict create filename $filename]
    } {
        append out [count filename [string length [dict get $value filename]] 256]
        append out [count filename [string length [dict get $value filename]] 256]
        append out [pad filename [dict get $value filename]]
        return $out
    }

    # Starts or stops writing.
    message log.req.set_write_state REQ 1 log.SetWriteState
    # Starts or stops playing.
    message log.req.set_read_state REQ 2 log.SetReadState
    # Requests the type and state of the device.
    message log.req.get_state REQ 3 log.GetState
    # Rewinds to the start of the file.
    message log.req.set_read_rewind REQ 4
    # Sets the file to write to.
    message log.req.set_filename REQ 5 log.SetFilename
}
