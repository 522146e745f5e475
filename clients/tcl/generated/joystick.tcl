# Interface joystick, code 49. A joystick or gamepad.
#
# Generated from interfaces/049_joystick.toml by codegen; do not edit.

::playhouse::wire::interface joystick 49 {
    # Sticks and buttons. (player_joystick_data_t)
    #   pos: One per axis, from -scale to scale.
    #   scale: Maximum value per axis.
    #   buttons: One bit per button, the first in the lowest bit.
    #   axes_count: Number of axes.
    struct Data {
        pos int32[8]
        scale int32[8]
        buttons uint32
        axes_count uint32
    } {
        if {[string length $body] - $at < 72} {cut $body $at {32 32 4 4}}
        binary scan $body @${at}I8I8IuIu pos scale buttons axes_count
        incr at 72
        return [dict create pos $pos scale $scale buttons $buttons axes_count $axes_count]
    } {
        exactly pos [llength [dict get $value pos]] 8
        append out [put_list int32 [dict get $value pos]]
        exactly scale [llength [dict get $value scale]] 8
        append out [put_list int32 [dict get $value scale]]
        append out [put uint32 [dict get $value buttons]]
        append out [put uint32 [dict get $value axes_count]]
        return $out
    }

    # Sticks and buttons.
    message joystick.data.state DATA 1 joystick.Data
}
