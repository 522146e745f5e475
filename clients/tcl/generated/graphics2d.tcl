# Interface graphics2d, code 55. Draws 2D shapes for display.
#
# Generated from interfaces/055_graphics2d.toml by codegen; do not edit.

::playhouse::wire::interface graphics2d 55 {
    # Points. (player_graphics2d_cmd_points_t)
    #   points: in m, frame p_SP.
    struct CmdPoints {
        points common.Point2d[]
        color common.Color
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu points.count
        incr at 4
        set points {}
        for {set points.left [length $body points ${points.count} 16]} {${points.left} > 0} {incr points.left -1} {
            lappend points [common::Point2d.read $body]
        }
        if {[string length $body] - $at < 16} {cut $body $at {4 4 4 4}}
        binary scan $body @${at}IuIuIuIu color.alpha color.red color.green color.blue
        incr at 16
        set color.alpha [low 0xff ${color.alpha}]
        set color.red [low 0xff ${color.red}]
        set color.green [low 0xff ${color.green}]
        set color.blue [low 0xff ${color.blue}]
        return [dict create points $points \
            color [dict create alpha ${color.alpha} red ${color.red} green ${color.green} blue ${color.blue}]]
    } {
        append out [count points [llength [dict get $value points]] 2097149]
        append out [count points [llength [dict get $value points]] 2097149]
        foreach item [dict get $value points] {append out [common::Point2d.write $item]}
        append out [common::Color.write [dict get $value color]]
        return $out
    }

    # A line through points. (player_graphics2d_cmd_polyline_t)
    #   points: in m, frame p_SP.
    struct CmdPolyline {
        points common.Point2d[]
        color common.Color
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu points.count
        incr at 4
        set points {}
        for {set points.left [length $body points ${points.count} 16]} {${points.left} > 0} {incr points.left -1} {
            lappend points [common::Point2d.read $body]
        }
        if {[string length $body] - $at < 16} {cut $body $at {4 4 4 4}}
        binary scan $body @${at}IuIuIuIu color.alpha color.red color.green color.blue
        incr at 16
        set color.alpha [low 0xff ${color.alpha}]
        set color.red [low 0xff ${color.red}]
        set color.green [low 0xff ${color.green}]
        set color.blue [low 0xff ${color.blue}]
        return [dict create points $points \
            color [dict create alpha ${color.alpha} red ${color.red} green ${color.green} blue ${color.blue}]]
    } {
        append out [count points [llength [dict get $value points]] 2097149]
        append out [count points [llength [dict get $value points]] 2097149]
        foreach item [dict get $value points] {append out [common::Point2d.write $item]}
        append out [common::Color.write [dict get $value color]]
        return $out
    }

    # A polygon. (player_graphics2d_cmd_polygon_t)
    #   points: Vertices (in m, frame p_SP).
    #   color: Outline color.
    #   fill_color: Fill color.
    #   filled: 1: filled.
    struct CmdPolygon {
        points common.Point2d[]
        color common.Color
        fill_color common.Color
        filled uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu points.count
        incr at 4
        set points {}
        for {set points.left [length $body points ${points.count} 16]} {${points.left} > 0} {incr points.left -1} {
            lappend points [common::Point2d.read $body]
        }
        if {[string length $body] - $at < 36} {cut $body $at {4 4 4 4 4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIuIuIuIuIuIu color.alpha color.red color.green color.blue \
            fill_color.alpha fill_color.red fill_color.green fill_color.blue filled
        incr at 36
        set color.alpha [low 0xff ${color.alpha}]
        set color.red [low 0xff ${color.red}]
        set color.green [low 0xff ${color.green}]
        set color.blue [low 0xff ${color.blue}]
        set fill_color.alpha [low 0xff ${fill_color.alpha}]
        set fill_color.red [low 0xff ${fill_color.red}]
        set fill_color.green [low 0xff ${fill_color.green}]
        set fill_color.blue [low 0xff ${fill_color.blue}]
        set filled [low 0xff $filled]
        return [dict create points $points \
            color [dict create alpha ${color.alpha} red ${color.red} green ${color.green} blue ${color.blue}] \
            fill_color [dict create alpha ${fill_color.alpha} red ${fill_color.red} green ${fill_color.green} blue ${fill_color.blue}] \
            filled $filled]
    } {
        append out [count points [llength [dict get $value points]] 2097149]
        append out [count points [llength [dict get $value points]] 2097149]
        foreach item [dict get $value points] {append out [common::Point2d.write $item]}
        append out [common::Color.write [dict get $value color]]
        append out [common::Color.write [dict get $value fill_color]]
        append out [put uint8 [dict get $value filled]]
        return $out
    }

    # Lines, each between two points. (player_graphics2d_cmd_multiline_t)
    #   points: Start and end of each line, alternating (in m, frame p_SP).
    struct CmdMultiline {
        points common.Point2d[]
        color common.Color
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu points.count
        incr at 4
        set points {}
        for {set points.left [length $body points ${points.count} 16]} {${points.left} > 0} {incr points.left -1} {
            lappend points [common::Point2d.read $body]
        }
        if {[string length $body] - $at < 16} {cut $body $at {4 4 4 4}}
        binary scan $body @${at}IuIuIuIu color.alpha color.red color.green color.blue
        incr at 16
        set color.alpha [low 0xff ${color.alpha}]
        set color.red [low 0xff ${color.red}]
        set color.green [low 0xff ${color.green}]
        set color.blue [low 0xff ${color.blue}]
        return [dict create points $points \
            color [dict create alpha ${color.alpha} red ${color.red} green ${color.green} blue ${color.blue}]]
    } {
        append out [count points [llength [dict get $value points]] 2097149]
        append out [count points [llength [dict get $value points]] 2097149]
        foreach item [dict get $value points] {append out [common::Point2d.write $item]}
        append out [common::Color.write [dict get $value color]]
        return $out
    }

    # Removes all drawn shapes.
    message graphics2d.cmd.clear CMD 1
    # Draws points.
    message graphics2d.cmd.points CMD 2 graphics2d.CmdPoints
    # Draws a line through points.
    message graphics2d.cmd.polyline CMD 3 graphics2d.CmdPolyline
    # Draws a polygon.
    message graphics2d.cmd.polygon CMD 4 graphics2d.CmdPolygon
    # Draws a line for each pair of points.
    message graphics2d.cmd.multiline CMD 5 graphics2d.CmdMultiline
}
