# Interface fiducial, code 10. Detects markers and reports their ids and poses.
#
# Generated from interfaces/010_fiducial.toml by codegen; do not edit.

::playhouse::wire::interface fiducial 10 {
    # One marker in view. (player_fiducial_item_t)
    #   id: Id of the marker; -1 if it cannot be identified, from simulated finders 0.
    #   pose: Pose of the marker (in m, m, m, rad, rad, rad, frame X_ST).
    #   upose: Standard deviation of each component of the pose; 0 if unknown (in m, m, m, rad, rad, rad,
    #     frame X_ST).
    struct Item {
        id int32
        pose common.Pose3d
        upose common.Pose3d
    } {
        if {[string length $body] - $at < 100} {cut $body $at {4 8 8 8 8 8 8 8 8 8 8 8 8}}
        binary scan $body @${at}IQQQQQQQQQQQQ id pose.px pose.py pose.pz pose.proll pose.ppitch pose.pyaw \
            upose.px upose.py upose.pz upose.proll upose.ppitch upose.pyaw
        incr at 100
        return [dict create id $id \
            pose [dict create px ${pose.px} py ${pose.py} pz ${pose.pz} proll ${pose.proll} ppitch ${pose.ppitch} pyaw ${pose.pyaw}] \
            upose [dict create px ${upose.px} py ${upose.py} pz ${upose.pz} proll ${upose.proll} ppitch ${upose.ppitch} pyaw ${upose.pyaw}]]
    } {
        append out [put int32 [dict get $value id]]
        append out [common::Pose3d.write [dict get $value pose]]
        append out [common::Pose3d.write [dict get $value upose]]
        return $out
    }

    # The markers in view. (player_fiducial_data_t)
    struct Data {
        fiducials fiducial.Item[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu fiducials.count
        incr at 4
        set fiducials {}
        for {set fiducials.left [length $body fiducials ${fiducials.count} 100]} {${fiducials.left} > 0} {incr fiducials.left -1} {
            lappend fiducials [Item.read $body]
        }
        return [dict create fiducials $fiducials]
    } {
        append out [count fiducials [llength [dict get $value fiducials]] 335543]
        append out [count fiducials [llength [dict get $value fiducials]] 335543]
        foreach item [dict get $value fiducials] {append out [Item.write $item]}
        return $out
    }

    # Size and pose. (player_fiducial_geom_t)
    #   pose: Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    #   size: Bounding box of the device (in m, m, m).
    #   fiducial_size: Of the markers; 0 if unknown (in m, m).
    struct Geom {
        pose common.Pose3d
        size common.Bbox3d
        fiducial_size common.Bbox2d
    } {
        if {[string length $body] - $at < 88} {cut $body $at {8 8 8 8 8 8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQQQQQQ pose.px pose.py pose.pz pose.proll pose.ppitch pose.pyaw \
            size.sw size.sl size.sh fiducial_size.sw fiducial_size.sl
        incr at 88
        return [dict create \
            pose [dict create px ${pose.px} py ${pose.py} pz ${pose.pz} proll ${pose.proll} ppitch ${pose.ppitch} pyaw ${pose.pyaw}] \
            size [dict create sw ${size.sw} sl ${size.sl} sh ${size.sh}] \
            fiducial_size [dict create sw ${fiducial_size.sw} sl ${fiducial_size.sl}]]
    } {
        append out [common::Pose3d.write [dict get $value pose]]
        append out [common::Bbox3d.write [dict get $value size]]
        append out [common::Bbox2d.write [dict get $value fiducial_size]]
        return $out
    }

    # Range and field of view. (player_fiducial_fov_t)
    #   min_range: in m.
    #   max_range: in m.
    #   view_angle: From the first to the last direction (in rad).
    struct Fov {
        min_range float32
        max_range float32
        view_angle float32
    } {
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}RRR min_range max_range view_angle
        incr at 12
        return [dict create min_range $min_range max_range $max_range view_angle $view_angle]
    } {
        append out [put float32 [dict get $value min_range]]
        append out [put float32 [dict get $value max_range]]
        append out [put float32 [dict get $value view_angle]]
        return $out
    }

    # A marker id. (player_fiducial_id_t)
    struct Id {
        id uint32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu id
        incr at 4
        return [dict create id $id]
    } {
        append out [put uint32 [dict get $value id]]
        return $out
    }

    # The markers in view.
    message fiducial.data.scan DATA 1 fiducial.Data
    # Requests the device's size and pose and the markers' size.
    message fiducial.req.get_geom REQ 1 fiducial.Geom
    # Requests the range and the field of view.
    message fiducial.req.get_fov REQ 2 fiducial.Fov
    # Sets the range and the field of view; the answer has the values in effect.
    message fiducial.req.set_fov REQ 3 fiducial.Fov
    # Requests the robot's own marker id.
    message fiducial.req.get_id REQ 7 fiducial.Id
    # Sets the robot's own marker id.
    message fiducial.req.set_id REQ 8 fiducial.Id
}
