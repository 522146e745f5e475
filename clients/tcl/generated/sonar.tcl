# Interface sonar, code 5. An array of sonars. New drivers use the ranger interface.
#
# Generated from interfaces/005_sonar.toml by codegen; do not edit.

::playhouse::wire::interface sonar 5 {
    # One range per sonar. (player_sonar_data_t)
    #   ranges: Range of the nearest echo, in the order of the geometry (in m).
    struct Data {
        ranges float32[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu ranges.count
        incr at 4
        set ranges [numbers $body R 4 [length $body ranges ${ranges.count} 4]]
        return [dict create ranges $ranges]
    } {
        append out [count ranges [llength [dict get $value ranges]] 8388598]
        append out [count ranges [llength [dict get $value ranges]] 8388598]
        append out [put_list float32 [dict get $value ranges]]
        return $out
    }

    # Poses of the sonars. (player_sonar_geom_t)
    #   poses: One per sonar; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS).
    struct Geom {
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

    # The sonars' switch. (player_sonar_power_config_t)
    #   state: 1: on, 0: off.
    struct PowerConfig {
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

    # Requests the poses of the sonars.
    message sonar.req.get_geom REQ 1 sonar.Geom
    # Switches the sonars on or off.
    message sonar.req.power REQ 2 sonar.PowerConfig
    # One range per sonar.
    message sonar.data.ranges DATA 1 sonar.Data
    # Poses of the sonars, sent on change.
    message sonar.data.geom DATA 2 sonar.Geom
}
