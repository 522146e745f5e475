# Interface ir, code 22. An array of infrared range finders. New drivers use the ranger interface.
#
# Generated from interfaces/022_ir.toml by codegen; do not edit.

::playhouse::wire::interface ir 22 {
    # Measurements of the sensors. (player_ir_data_t)
    #   voltages: One per sensor, as measured (in V).
    #   ranges: One per sensor, computed from the voltage (in m).
    struct Data {
        voltages float32[]
        ranges float32[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu voltages.count
        incr at 4
        set voltages [numbers $body R 4 [length $body voltages ${voltages.count} 4]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu ranges.count
        incr at 4
        set ranges [numbers $body R 4 [length $body ranges ${ranges.count} 4]]
        return [dict create voltages $voltages ranges $ranges]
    } {
        append out [count voltages [llength [dict get $value voltages]] 8388598]
        append out [count voltages [llength [dict get $value voltages]] 8388598]
        append out [put_list float32 [dict get $value voltages]]
        append out [count ranges [llength [dict get $value ranges]] 8388598]
        append out [count ranges [llength [dict get $value ranges]] 8388598]
        append out [put_list float32 [dict get $value ranges]]
        return $out
    }

    # Poses of the sensors. (player_ir_pose_t)
    #   poses: One per sensor; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS).
    struct Pose {
        poses common.Pose3d[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu poses.count
        incr at 4
        set poses {}
        for {set poses.left [length $body poses ${poses.count} 48]} {${poses.left} > 0} {incr poses.left -1} {
            lappend poses [common::Pose3d.read $body]
        }
        return [dict create poses $poses]
    } {
        append out [count poses [llength [dict get $value poses]] 699049]
        append out [count poses [llength [dict get $value poses]] 699049]
        foreach item [dict get $value poses] {append out [common::Pose3d.write $item]}
        return $out
    }

    # The sensors' switch. (player_ir_power_req_t)
    #   state: 1: on, 0: off.
    struct PowerReq {
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

    # Requests the poses of the sensors.
    message ir.req.pose REQ 1 ir.Pose
    # Switches the sensors on or off.
    message ir.req.power REQ 2 ir.PowerReq
    # Voltages and ranges.
    message ir.data.ranges DATA 1 ir.Data
}
