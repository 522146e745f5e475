# Interface graphics3d, code 58. Draws 3D shapes for display.
#
# Generated from interfaces/058_graphics3d.toml by codegen; do not edit.

::playhouse::wire::interface graphics3d 58 {
    # Values of CmdDraw.draw_mode: primitives made from the points.
    variable DRAW_POINTS 0
    variable DRAW_LINES 1
    variable DRAW_LINE_STRIP 2
    variable DRAW_LINE_LOOP 3
    variable DRAW_TRIANGLES 4
    variable DRAW_TRIANGLE_STRIP 5
    variable DRAW_TRIANGLE_FAN 6
    variable DRAW_QUADS 7
    variable DRAW_QUAD_STRIP 8
    variable DRAW_POLYGON 9

    # Points, lines or faces. (player_graphics3d_cmd_draw_t)
    #   points: in m, frame p_SP.
    struct CmdDraw {
        draw_mode uint32
        points common.Point3d[]
        color common.Color
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuIu draw_mode points.count
        incr at 8
        set points {}
        for {set points.left [length $body points ${points.count} 24]} {${points.left} > 0} {incr points.left -1} {
            lappend points [common::Point3d.read $body]
        }
        if {[string length $body] - $at < 16} {cut $body $at {4 4 4 4}}
        binary scan $body @${at}IuIuIuIu color.alpha color.red color.green color.blue
        incr at 16
        set color.alpha [low 0xff ${color.alpha}]
        set color.red [low 0xff ${color.red}]
        set color.green [low 0xff ${color.green}]
        set color.blue [low 0xff ${color.blue}]
        return [dict create draw_mode $draw_mode points $points \
            color [dict create alpha ${color.alpha} red ${color.red} green ${color.green} blue ${color.blue}]]
    } {
        append out [put uint32 [dict get $value draw_mode]]
        append out [count points [llength [dict get $value points]] 1398099]
        append out [count points [llength [dict get $value points]] 1398099]
        foreach item [dict get $value points] {append out [common::Point3d.write $item]}
        append out [common::Color.write [dict get $value color]]
        return $out
    }

    # A translation of the coordinate frame. (player_graphics3d_cmd_translate_t)
    #   x: in m.
    #   y: in m.
    #   z: in m.
    struct CmdTranslate {
        x float64
        y float64
        z float64
    } {
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}QQQ x y z
        incr at 24
        return [dict create x $x y $y z $z]
    } {
        append out [put float64 [dict get $value x]]
        append out [put float64 [dict get $value y]]
        append out [put float64 [dict get $value z]]
        return $out
    }

    # A rotation of the coordinate frame. (player_graphics3d_cmd_rotate_t)
    #   a: Angle about the vector (x, y, z) (in rad).
    struct CmdRotate {
        a float64
        x float64
        y float64
        z float64
    } {
        if {[string length $body] - $at < 32} {cut $body $at {8 8 8 8}}
        binary scan $body @${at}QQQQ a x y z
        incr at 32
        return [dict create a $a x $x y $y z $z]
    } {
        append out [put float64 [dict get $value a]]
        append out [put float64 [dict get $value x]]
        append out [put float64 [dict get $value y]]
        append out [put float64 [dict get $value z]]
        return $out
    }

    # Removes all drawn shapes.
    message graphics3d.cmd.clear CMD 1
    # Draws points, lines or faces.
    message graphics3d.cmd.draw CMD 2 graphics3d.CmdDraw
    # Translates the coordinate frame of subsequent drawing.
    message graphics3d.cmd.translate CMD 3 graphics3d.CmdTranslate
    # Rotates the coordinate frame of subsequent drawing.
    message graphics3d.cmd.rotate CMD 4 graphics3d.CmdRotate
    # Pushes the current coordinate frame.
    message graphics3d.cmd.push CMD 5
    # Pops the pushed coordinate frame.
    message graphics3d.cmd.pop CMD 6
}
