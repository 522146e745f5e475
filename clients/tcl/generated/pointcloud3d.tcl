# Interface pointcloud3d, code 61. Points in space with colors.
#
# Generated from interfaces/061_pointcloud3d.toml by codegen; do not edit.

::playhouse::wire::interface pointcloud3d 61 {
    # One point. (player_pointcloud3d_element_t)
    #   point: in m, frame p_SP.
    struct Element {
        point common.Point3d
        color common.Color
    } {
        if {[string length $body] - $at < 40} {cut $body $at {8 8 8 4 4 4 4}}
        binary scan $body @${at}QQQIuIuIuIu point.px point.py point.pz color.alpha color.red color.green \
            color.blue
        incr at 40
        set color.alpha [low 0xff ${color.alpha}]
        set color.red [low 0xff ${color.red}]
        set color.green [low 0xff ${color.green}]
        set color.blue [low 0xff ${color.blue}]
        return [dict create point [dict create px ${point.px} py ${point.py} pz ${point.pz}] \
            color [dict create alpha ${color.alpha} red ${color.red} green ${color.green} blue ${color.blue}]]
    } {
        append out [common::Point3d.write [dict get $value point]]
        append out [common::Color.write [dict get $value color]]
        return $out
    }

    # One cloud. (player_pointcloud3d_data_t)
    struct Data {
        points pointcloud3d.Element[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu points.count
        incr at 4
        set points {}
        for {set points.left [length $body points ${points.count} 40]} {${points.left} > 0} {incr points.left -1} {
            lappend points [Element.read $body]
        }
        return [dict create points $points]
    } {
        append out [count points [llength [dict get $value points]] 838859]
        append out [count points [llength [dict get $value points]] 838859]
        foreach item [dict get $value points] {append out [Element.write $item]}
        return $out
    }

    # One cloud.
    message pointcloud3d.data.state DATA 1 pointcloud3d.Data
}
