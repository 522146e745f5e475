# Interface map, code 42. Grid and vector maps.
#
# Generated from interfaces/042_map.toml by codegen; do not edit.

::playhouse::wire::interface map 42 {
    # Size, scale and origin of the map. (player_map_info_t)
    #   scale: Cell size (in m/pixel).
    #   width: in px.
    #   height: in px.
    #   origin: Of the lower left corner of cell (0, 0) (in m, m, rad, frame X_WM).
    struct Info {
        scale float32
        width uint32
        height uint32
        origin common.Pose2d
    } {
        if {[string length $body] - $at < 36} {cut $body $at {4 4 4 8 8 8}}
        binary scan $body @${at}RIuIuQQQ scale width height origin.px origin.py origin.pa
        incr at 36
        return [dict create scale $scale width $width height $height \
            origin [dict create px ${origin.px} py ${origin.py} pa ${origin.pa}]]
    } {
        append out [put float32 [dict get $value scale]]
        append out [put uint32 [dict get $value width]]
        append out [put uint32 [dict get $value height]]
        append out [common::Pose2d.write [dict get $value origin]]
        return $out
    }

    # A rectangle of cells. (player_map_data_t)
    #   col: First column, from the left (in px).
    #   row: First row, from the bottom (in px).
    #   width: in px.
    #   height: in px.
    #   data_range: Value of a cell that is certainly occupied; its negative: certainly free, 0: unknown.
    #   data: Rows, concatenated; compressed with zlib in an answer, empty in a request.
    struct Data {
        col uint32
        row uint32
        width uint32
        height uint32
        data_range int8
        data int8[]
    } {
        if {[string length $body] - $at < 24} {cut $body $at {4 4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIuIuI col row width height data.count data_range
        incr at 24
        set data_range [signed 0x80 $data_range]
        set data [opaque $body [length $body data ${data.count} 1]]
        return [dict create col $col row $row width $width height $height data_range $data_range \
            data $data]
    } {
        append out [put uint32 [dict get $value col]]
        append out [put uint32 [dict get $value row]]
        append out [put uint32 [dict get $value width]]
        append out [put uint32 [dict get $value height]]
        append out [count data [string length [dict get $value data]] 33554392]
        append out [put int8 [dict get $value data_range]]
        append out [count data [string length [dict get $value data]] 33554392]
        append out [pad data [dict get $value data]]
        return $out
    }

    # The map as line segments, and its extent. (player_map_data_vector_t)
    #   minx: in m.
    #   maxx: in m.
    #   miny: in m.
    #   maxy: in m.
    #   segments: One per line (in m, frame p_MP).
    struct DataVector {
        minx float32
        maxx float32
        miny float32
        maxy float32
        segments common.Segment[]
    } {
        if {[string length $body] - $at < 20} {cut $body $at {4 4 4 4 4}}
        binary scan $body @${at}RRRRIu minx maxx miny maxy segments.count
        incr at 20
        set segments {}
        for {set segments.left [length $body segments ${segments.count} 32]} {${segments.left} > 0} {incr segments.left -1} {
            lappend segments [common::Segment.read $body]
        }
        return [dict create minx $minx maxx $maxx miny $miny maxy $maxy segments $segments]
    } {
        append out [put float32 [dict get $value minx]]
        append out [put float32 [dict get $value maxx]]
        append out [put float32 [dict get $value miny]]
        append out [put float32 [dict get $value maxy]]
        append out [count segments [llength [dict get $value segments]] 1048574]
        append out [count segments [llength [dict get $value segments]] 1048574]
        foreach item [dict get $value segments] {append out [common::Segment.write $item]}
        return $out
    }

    # Size and scale of the map, sent on change.
    message map.data.info DATA 1 map.Info
    # Requests the size and scale of the map.
    message map.req.get_info REQ 1 map.Info
    # Requests a rectangle of cells; the answer's cells are compressed with zlib.
    message map.req.get_data REQ 2 map.Data
    # Requests the map as lines.
    message map.req.get_vector REQ 3 map.DataVector
}
