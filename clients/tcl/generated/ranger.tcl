# Interface ranger, code 62. Range finders of any type: lasers, sonars, infrared, single or in arrays.
#
# Generated from interfaces/062_ranger.toml by codegen; do not edit.

::playhouse::wire::interface ranger 62 {
    # Angles, ranges and rate. (player_ranger_config_t)
    #   min_angle: Of the first beam, counter-clockwise from x (in rad).
    #   max_angle: Of the last beam (in rad).
    #   angular_res: Angle between neighbouring beams (in rad).
    #   min_range: Minimum range (in m).
    #   max_range: Maximum range, and reported range of a beam without a hit (in m).
    #   range_res: Range resolution (in m).
    #   frequency: Scans per second (in Hz).
    struct Config {
        min_angle float64
        max_angle float64
        angular_res float64
        min_range float64
        max_range float64
        range_res float64
        frequency float64
    } {
        if {[string length $body] - $at < 56} {cut $body $at {8 8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQQ min_angle max_angle angular_res min_range max_range range_res \
            frequency
        incr at 56
        return [dict create min_angle $min_angle max_angle $max_angle angular_res $angular_res \
            min_range $min_range max_range $max_range range_res $range_res frequency $frequency]
    } {
        append out [put float64 [dict get $value min_angle]]
        append out [put float64 [dict get $value max_angle]]
        append out [put float64 [dict get $value angular_res]]
        append out [put float64 [dict get $value min_range]]
        append out [put float64 [dict get $value max_range]]
        append out [put float64 [dict get $value range_res]]
        append out [put float64 [dict get $value frequency]]
        return $out
    }

    # Size and pose of the device and its elements. (player_ranger_geom_t)
    #   pose: Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    #   size: Bounding box of the device (in m, m, m).
    #   element_poses: One per element; x points along its beam, or along the middle of its scan (in m, m, m,
    #     rad, rad, rad, frame X_SE).
    #   element_sizes: One per element (in m, m, m).
    struct Geom {
        pose common.Pose3d
        size common.Bbox3d
        element_poses common.Pose3d[]
        element_sizes common.Bbox3d[]
    } {
        if {[string length $body] - $at < 76} {cut $body $at {8 8 8 8 8 8 8 8 8 4}}
        binary scan $body @${at}QQQQQQQQQIu pose.px pose.py pose.pz pose.proll pose.ppitch pose.pyaw \
            size.sw size.sl size.sh element_poses.count
        incr at 76
        set element_poses {}
        for {set element_poses.left [length $body element_poses ${element_poses.count} 48]} {${element_poses.left} > 0} {incr element_poses.left -1} {
            lappend element_poses [common::Pose3d.read $body]
        }
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu element_sizes.count
        incr at 4
        set element_sizes {}
        for {set element_sizes.left [length $body element_sizes ${element_sizes.count} 24]} {${element_sizes.left} > 0} {incr element_sizes.left -1} {
            lappend element_sizes [common::Bbox3d.read $body]
        }
        return [dict create \
            pose [dict create px ${pose.px} py ${pose.py} pz ${pose.pz} proll ${pose.proll} ppitch ${pose.ppitch} pyaw ${pose.pyaw}] \
            size [dict create sw ${size.sw} sl ${size.sl} sh ${size.sh}] element_poses $element_poses \
            element_sizes $element_sizes]
    } {
        append out [common::Pose3d.write [dict get $value pose]]
        append out [common::Bbox3d.write [dict get $value size]]
        append out [count element_poses [llength [dict get $value element_poses]] 699049]
        append out [count element_poses [llength [dict get $value element_poses]] 699049]
        foreach item [dict get $value element_poses] {append out [common::Pose3d.write $item]}
        append out [count element_sizes [llength [dict get $value element_sizes]] 1398099]
        append out [count element_sizes [llength [dict get $value element_sizes]] 1398099]
        foreach item [dict get $value element_sizes] {append out [common::Bbox3d.write $item]}
        return $out
    }

    # Ranges. (player_ranger_data_range_t)
    #   ranges: Beam by beam from right to left, element by element (in m).
    struct DataRange {
        ranges float64[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu ranges.count
        incr at 4
        set ranges [numbers $body Q 8 [length $body ranges ${ranges.count} 8]]
        return [dict create ranges $ranges]
    } {
        append out [count ranges [llength [dict get $value ranges]] 4194299]
        append out [count ranges [llength [dict get $value ranges]] 4194299]
        append out [put_list float64 [dict get $value ranges]]
        return $out
    }

    # Ranges with geometry and configuration. (player_ranger_data_rangestamped_t)
    #   have_geom: 1 if `geom` is valid.
    #   have_config: 1 if `config` is valid.
    struct DataRangestamped {
        data ranger.DataRange
        have_geom uint8
        geom ranger.Geom
        have_config uint8
        config ranger.Config
    } {
        set data [DataRange.read $body]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu have_geom
        incr at 4
        set have_geom [low 0xff $have_geom]
        set geom [Geom.read $body]
        if {[string length $body] - $at < 60} {cut $body $at {4 8 8 8 8 8 8 8}}
        binary scan $body @${at}IuQQQQQQQ have_config config.min_angle config.max_angle config.angular_res \
            config.min_range config.max_range config.range_res config.frequency
        incr at 60
        set have_config [low 0xff $have_config]
        return [dict create data $data have_geom $have_geom geom $geom have_config $have_config \
            config [dict create min_angle ${config.min_angle} max_angle ${config.max_angle} angular_res ${config.angular_res} min_range ${config.min_range} max_range ${config.max_range} range_res ${config.range_res} frequency ${config.frequency}]]
    } {
        append out [DataRange.write [dict get $value data]]
        append out [put uint8 [dict get $value have_geom]]
        append out [Geom.write [dict get $value geom]]
        append out [put uint8 [dict get $value have_config]]
        append out [Config.write [dict get $value config]]
        return $out
    }

    # Intensities. (player_ranger_data_intns_t)
    #   intensities: In the order of the ranges; driver-specific scale.
    struct DataIntns {
        intensities float64[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu intensities.count
        incr at 4
        set intensities [numbers $body Q 8 [length $body intensities ${intensities.count} 8]]
        return [dict create intensities $intensities]
    } {
        append out [count intensities [llength [dict get $value intensities]] 4194299]
        append out [count intensities [llength [dict get $value intensities]] 4194299]
        append out [put_list float64 [dict get $value intensities]]
        return $out
    }

    # Intensities with geometry and configuration. (player_ranger_data_intnsstamped_t)
    #   have_geom: 1 if `geom` is valid.
    #   have_config: 1 if `config` is valid.
    struct DataIntnsstamped {
        data ranger.DataIntns
        have_geom uint8
        geom ranger.Geom
        have_config uint8
        config ranger.Config
    } {
        set data [DataIntns.read $body]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu have_geom
        incr at 4
        set have_geom [low 0xff $have_geom]
        set geom [Geom.read $body]
        if {[string length $body] - $at < 60} {cut $body $at {4 8 8 8 8 8 8 8}}
        binary scan $body @${at}IuQQQQQQQ have_config config.min_angle config.max_angle config.angular_res \
            config.min_range config.max_range config.range_res config.frequency
        incr at 60
        set have_config [low 0xff $have_config]
        return [dict create data $data have_geom $have_geom geom $geom have_config $have_config \
            config [dict create min_angle ${config.min_angle} max_angle ${config.max_angle} angular_res ${config.angular_res} min_range ${config.min_range} max_range ${config.max_range} range_res ${config.range_res} frequency ${config.frequency}]]
    } {
        append out [DataIntns.write [dict get $value data]]
        append out [put uint8 [dict get $value have_geom]]
        append out [Geom.write [dict get $value geom]]
        append out [put uint8 [dict get $value have_config]]
        append out [Config.write [dict get $value config]]
        return $out
    }

    # The device's switch. (player_ranger_power_config_t)
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

    # The switch of intensities. (player_ranger_intns_config_t)
    #   state: 1: on, 0: off.
    struct IntnsConfig {
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

    # Ranges.
    message ranger.data.range DATA 1 ranger.DataRange
    # Ranges with the geometry and configuration of the measurement.
    message ranger.data.rangestamped DATA 2 ranger.DataRangestamped
    # Intensities.
    message ranger.data.intns DATA 3 ranger.DataIntns
    # Intensities with the geometry and configuration of the measurement.
    message ranger.data.intnsstamped DATA 4 ranger.DataIntnsstamped
    # Size and pose, sent on change.
    message ranger.data.geom DATA 5 ranger.Geom
    # Requests size and pose.
    message ranger.req.get_geom REQ 1 ranger.Geom
    # Switches the device on or off.
    message ranger.req.power REQ 2 ranger.PowerConfig
    # Switches intensities on or off.
    message ranger.req.intns REQ 3 ranger.IntnsConfig
    # Sets angles, ranges and rate; the answer has the values in effect.
    message ranger.req.set_config REQ 4 ranger.Config
    # Requests angles, ranges and rate.
    message ranger.req.get_config REQ 5 ranger.Config
}
