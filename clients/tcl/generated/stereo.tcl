# Interface stereo, code 65. A pair of cameras, their disparity and the points in space.
#
# Generated from interfaces/065_stereo.toml by codegen; do not edit.

::playhouse::wire::interface stereo 65 {
    # One point. (player_pointcloud3d_stereo_element_t)
    #   px: in m, frame p_SP.
    #   py: in m, frame p_SP.
    #   pz: in m, frame p_SP.
    struct Pointcloud3dStereoElement {
        px float32
        py float32
        pz float32
        red uint8
        green uint8
        blue uint8
    } {
        if {[string length $body] - $at < 24} {cut $body $at {4 4 4 4 4 4}}
        binary scan $body @${at}RRRIuIuIu px py pz red green blue
        incr at 24
        set red [low 0xff $red]
        set green [low 0xff $green]
        set blue [low 0xff $blue]
        return [dict create px $px py $py pz $pz red $red green $green blue $blue]
    } {
        append out [put float32 [dict get $value px]]
        append out [put float32 [dict get $value py]]
        append out [put float32 [dict get $value pz]]
        append out [put uint8 [dict get $value red]]
        append out [put uint8 [dict get $value green]]
        append out [put uint8 [dict get $value blue]]
        return $out
    }

    # A pair of images, and the results computed from it. (player_stereo_data_t)
    #   left_channel: Image of the left camera.
    #   right_channel: Image of the right camera.
    #   disparity: Disparity, as an image.
    #   points: Points in space.
    #   mode: Driver-specific.
    struct Data {
        left_channel camera.Data
        right_channel camera.Data
        disparity camera.Data
        points stereo.Pointcloud3dStereoElement[]
        mode uint32
    } {
        set left_channel [camera::Data.read $body]
        set right_channel [camera::Data.read $body]
        set disparity [camera::Data.read $body]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu points.count
        incr at 4
        set points {}
        for {set points.left [length $body points ${points.count} 24]} {${points.left} > 0} {incr points.left -1} {
            lappend points [Pointcloud3dStereoElement.read $body]
        }
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu mode
        incr at 4
        return [dict create left_channel $left_channel right_channel $right_channel disparity $disparity \
            points $points mode $mode]
    } {
        append out [camera::Data.write [dict get $value left_channel]]
        append out [camera::Data.write [dict get $value right_channel]]
        append out [camera::Data.write [dict get $value disparity]]
        append out [count points [llength [dict get $value points]] 1398099]
        append out [count points [llength [dict get $value points]] 1398099]
        foreach item [dict get $value points] {append out [Pointcloud3dStereoElement.write $item]}
        append out [put uint32 [dict get $value mode]]
        return $out
    }

    # A pair of images, and the results computed from it.
    message stereo.data.state DATA 1 stereo.Data
}
