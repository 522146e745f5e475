# Interface vectormap, code 63. Maps of points, lines and areas in layers.
#
# Generated from interfaces/063_vectormap.toml by codegen; do not edit.

::playhouse::wire::interface vectormap 63 {
    # One feature. (player_vectormap_feature_data_t)
    #   wkb: Its shape, as OGC well-known binary, in map coordinates.
    #   attrib: Free text.
    struct FeatureData {
        name char[]
        wkb uint8[]
        attrib char[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu name.count
        incr at 4
        set name [opaque $body [length $body name ${name.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu wkb.count
        incr at 4
        set wkb [opaque $body [length $body wkb ${wkb.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu attrib.count
        incr at 4
        set attrib [opaque $body [length $body attrib ${attrib.count} 1]]
        return [dict create name $name wkb $wkb attrib $attrib]
    } {
        append out [count name [string length [dict get $value name]] 33554392]
        append out [count name [string length [dict get $value name]] 33554392]
        append out [pad name [dict get $value name]]
        append out [count wkb [string length [dict get $value wkb]] 33554392]
        append out [count wkb [string length [dict get $value wkb]] 33554392]
        append out [pad wkb [dict get $value wkb]]
        append out [count attrib [string length [dict get $value attrib]] 33554392]
        append out [count attrib [string length [dict get $value attrib]] 33554392]
        append out [pad attrib [dict get $value attrib]]
        return $out
    }

    # Description of a layer. (player_vectormap_layer_info_t)
    #   extent: Bounding box of all its features (in m, frame p_MP).
    struct LayerInfo {
        name char[]
        extent common.Extent2d
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu name.count
        incr at 4
        set name [opaque $body [length $body name ${name.count} 1]]
        if {[string length $body] - $at < 32} {cut $body $at {8 8 8 8}}
        binary scan $body @${at}QQQQ extent.x0 extent.y0 extent.x1 extent.y1
        incr at 32
        return [dict create name $name \
            extent [dict create x0 ${extent.x0} y0 ${extent.y0} x1 ${extent.x1} y1 ${extent.y1}]]
    } {
        append out [count name [string length [dict get $value name]] 33554392]
        append out [count name [string length [dict get $value name]] 33554392]
        append out [pad name [dict get $value name]]
        append out [common::Extent2d.write [dict get $value extent]]
        return $out
    }

    # A layer's features. (player_vectormap_layer_data_t)
    struct LayerData {
        name char[]
        features vectormap.FeatureData[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu name.count
        incr at 4
        set name [opaque $body [length $body name ${name.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu features.count
        incr at 4
        set features {}
        for {set features.left [length $body features ${features.count} 24]} {${features.left} > 0} {incr features.left -1} {
            lappend features [FeatureData.read $body]
        }
        return [dict create name $name features $features]
    } {
        append out [count name [string length [dict get $value name]] 33554392]
        append out [count name [string length [dict get $value name]] 33554392]
        append out [pad name [dict get $value name]]
        append out [count features [llength [dict get $value features]] 1398099]
        append out [count features [llength [dict get $value features]] 1398099]
        foreach item [dict get $value features] {append out [FeatureData.write $item]}
        return $out
    }

    # List of layers. (player_vectormap_info_t)
    #   srid: Id of the spatial reference system; 0: none.
    #   extent: Bounding box of all layers (in m, frame p_MP).
    struct Info {
        srid uint32
        layers vectormap.LayerInfo[]
        extent common.Extent2d
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuIu srid layers.count
        incr at 8
        set layers {}
        for {set layers.left [length $body layers ${layers.count} 40]} {${layers.left} > 0} {incr layers.left -1} {
            lappend layers [LayerInfo.read $body]
        }
        if {[string length $body] - $at < 32} {cut $body $at {8 8 8 8}}
        binary scan $body @${at}QQQQ extent.x0 extent.y0 extent.x1 extent.y1
        incr at 32
        return [dict create srid $srid layers $layers \
            extent [dict create x0 ${extent.x0} y0 ${extent.y0} x1 ${extent.x1} y1 ${extent.y1}]]
    } {
        append out [put uint32 [dict get $value srid]]
        append out [count layers [llength [dict get $value layers]] 838859]
        append out [count layers [llength [dict get $value layers]] 838859]
        foreach item [dict get $value layers] {append out [LayerInfo.write $item]}
        append out [common::Extent2d.write [dict get $value extent]]
        return $out
    }

    # Requests the list of layers.
    message vectormap.req.get_map_info REQ 1 vectormap.Info
    # Requests the features of a layer.
    message vectormap.req.get_layer_data REQ 3 vectormap.LayerData
    # Replaces the features of a layer.
    message vectormap.req.write_layer REQ 4 vectormap.LayerData
}
