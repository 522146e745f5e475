# Interface bumper, code 14. Contact switches.
#
# Generated from interfaces/014_bumper.toml by codegen; do not edit.

::playhouse::wire::interface bumper 14 {
    # Which bumpers are pressed. (player_bumper_data_t)
    #   bumpers: One per bumper: 0 free, else pressed.
    struct Data {
        bumpers uint8[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu bumpers.count
        incr at 4
        set bumpers [opaque $body [length $body bumpers ${bumpers.count} 1]]
        return [dict create bumpers $bumpers]
    } {
        append out [count bumpers [string length [dict get $value bumpers]] 33554392]
        append out [count bumpers [string length [dict get $value bumpers]] 33554392]
        append out [pad bumpers [dict get $value bumpers]]
        return $out
    }

    # One bumper. (player_bumper_define_t)
    #   pose: Of the bumper's centre (in m, m, m, rad, rad, rad, frame X_RS).
    #   length: in m.
    #   radius: Radius of curvature; 0 if it is straight (in m).
    struct Define {
        pose common.Pose3d
        length float32
        radius float32
    } {
        if {[string length $body] - $at < 56} {cut $body $at {8 8 8 8 8 8 4 4}}
        binary scan $body @${at}QQQQQQRR pose.px pose.py pose.pz pose.proll pose.ppitch pose.pyaw length \
            radius
        incr at 56
        return [dict create \
            pose [dict create px ${pose.px} py ${pose.py} pz ${pose.pz} proll ${pose.proll} ppitch ${pose.ppitch} pyaw ${pose.pyaw}] \
            length $length radius $radius]
    } {
        append out [common::Pose3d.write [dict get $value pose]]
        append out [put float32 [dict get $value length]]
        append out [put float32 [dict get $value radius]]
        return $out
    }

    # Poses of the bumpers. (player_bumper_geom_t)
    struct Geom {
        bumper_def bumper.Define[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu bumper_def.count
        incr at 4
        set bumper_def {}
        for {set bumper_def.left [length $body bumper_def ${bumper_def.count} 56]} {${bumper_def.left} > 0} {incr bumper_def.left -1} {
            lappend bumper_def [Define.read $body]
        }
        return [dict create bumper_def $bumper_def]
    } {
        append out [count bumper_def [llength [dict get $value bumper_def]] 599185]
        append out [count bumper_def [llength [dict get $value bumper_def]] 599185]
        foreach item [dict get $value bumper_def] {append out [Define.write $item]}
        return $out
    }

    # Which bumpers are pressed.
    message bumper.data.state DATA 1 bumper.Data
    # Poses of the bumpers, sent on change.
    message bumper.data.geom DATA 2 bumper.Geom
    # Requests the poses of the bumpers.
    message bumper.req.get_geom REQ 1 bumper.Geom
}
