# Interface laser, code 6. A scanning range finder. New drivers use the ranger interface.
#
# Generated from interfaces/006_laser.toml by codegen; do not edit.

::playhouse::wire::interface laser 6 {
    # Largest number of filter parameters.
    variable MAX_FILTER_PARAMS 8

    # Values of SetFilterConfig.filter_type.
    variable FILTER_MEDIAN 1
    variable FILTER_EDGE 2
    variable FILTER_RANGE 3
    variable FILTER_MEAN 4

    # One scan at equal angles. (player_laser_data_t)
    #   min_angle: Of the first beam, counter-clockwise from x (in rad).
    #   max_angle: Of the last beam (in rad).
    #   resolution: Angle between neighbouring beams (in rad).
    #   max_range: Reported range of a beam without a hit (in m).
    #   ranges: From right to left (in m).
    #   intensity: Intensity of the echo per beam; empty if the device has none.
    #   id: Increases from scan to scan, by one or more.
    struct Data {
        min_angle float32
        max_angle float32
        resolution float32
        max_range float32
        ranges float32[]
        intensity uint8[]
        id uint32
    } {
        if {[string length $body] - $at < 20} {cut $body $at {4 4 4 4 4}}
        binary scan $body @${at}RRRRIu min_angle max_angle resolution max_range ranges.count
        incr at 20
        set ranges [numbers $body R 4 [length $body ranges ${ranges.count} 4]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu intensity.count
        incr at 4
        set intensity [opaque $body [length $body intensity ${intensity.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu id
        incr at 4
        return [dict create min_angle $min_angle max_angle $max_angle resolution $resolution \
            max_range $max_range ranges $ranges intensity $intensity id $id]
    } {
        append out [put float32 [dict get $value min_angle]]
        append out [put float32 [dict get $value max_angle]]
        append out [put float32 [dict get $value resolution]]
        append out [put float32 [dict get $value max_range]]
        append out [count ranges [llength [dict get $value ranges]] 8388598]
        append out [count ranges [llength [dict get $value ranges]] 8388598]
        append out [put_list float32 [dict get $value ranges]]
        append out [count intensity [string length [dict get $value intensity]] 33554392]
        append out [count intensity [string length [dict get $value intensity]] 33554392]
        append out [pad intensity [dict get $value intensity]]
        append out [put uint32 [dict get $value id]]
        return $out
    }

    # One scan and the pose at which it was measured. (player_laser_data_scanpose_t)
    #   pose: Of the robot at the time of the scan (in m, m, rad, frame X_OR).
    struct DataScanpose {
        scan laser.Data
        pose common.Pose2d
    } {
        set scan [Data.read $body]
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}QQQ pose.px pose.py pose.pa
        incr at 24
        return [dict create scan $scan pose [dict create px ${pose.px} py ${pose.py} pa ${pose.pa}]]
    } {
        append out [Data.write [dict get $value scan]]
        append out [common::Pose2d.write [dict get $value pose]]
        return $out
    }

    # One scan with an angle per beam. (player_laser_data_scanangle_t)
    #   max_range: Reported range of a beam without a hit (in m).
    #   ranges: One per beam (in m).
    #   angles: One per beam, counter-clockwise from x (in rad).
    #   intensity: Intensity of the echo per beam; empty if the device has none.
    #   id: Increases from scan to scan, by one or more.
    struct DataScanangle {
        max_range float32
        ranges float32[]
        angles float32[]
        intensity uint8[]
        id uint32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}RIu max_range ranges.count
        incr at 8
        set ranges [numbers $body R 4 [length $body ranges ${ranges.count} 4]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu angles.count
        incr at 4
        set angles [numbers $body R 4 [length $body angles ${angles.count} 4]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu intensity.count
        incr at 4
        set intensity [opaque $body [length $body intensity ${intensity.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu id
        incr at 4
        return [dict create max_range $max_range ranges $ranges angles $angles intensity $intensity \
            id $id]
    } {
        append out [put float32 [dict get $value max_range]]
        append out [count ranges [llength [dict get $value ranges]] 8388598]
        append out [count ranges [llength [dict get $value ranges]] 8388598]
        append out [put_list float32 [dict get $value ranges]]
        append out [count angles [llength [dict get $value angles]] 8388598]
        append out [count angles [llength [dict get $value angles]] 8388598]
        append out [put_list float32 [dict get $value angles]]
        append out [count intensity [string length [dict get $value intensity]] 33554392]
        append out [count intensity [string length [dict get $value intensity]] 33554392]
        append out [pad intensity [dict get $value intensity]]
        append out [put uint32 [dict get $value id]]
        return $out
    }

    # The device's size and pose. (player_laser_geom_t)
    #   pose: Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    #   size: Bounding box of the device (in m, m, m).
    struct Geom {
        pose common.Pose3d
        size common.Bbox3d
    } {
        if {[string length $body] - $at < 72} {cut $body $at {8 8 8 8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQQQQ pose.px pose.py pose.pz pose.proll pose.ppitch pose.pyaw size.sw \
            size.sl size.sh
        incr at 72
        return [dict create \
            pose [dict create px ${pose.px} py ${pose.py} pz ${pose.pz} proll ${pose.proll} ppitch ${pose.ppitch} pyaw ${pose.pyaw}] \
            size [dict create sw ${size.sw} sl ${size.sl} sh ${size.sh}]]
    } {
        append out [common::Pose3d.write [dict get $value pose]]
        append out [common::Bbox3d.write [dict get $value size]]
        return $out
    }

    # Angles, resolution and rate. (player_laser_config_t)
    #   min_angle: Of the first beam (in rad).
    #   max_angle: Of the last beam (in rad).
    #   resolution: Angle between neighbouring beams (in rad).
    #   max_range: Maximum range (in m).
    #   range_res: Range resolution (in m).
    #   intensity: 1: send intensities, too.
    #   scanning_frequency: Scans per second (in Hz).
    struct Config {
        min_angle float32
        max_angle float32
        resolution float32
        max_range float32
        range_res float32
        intensity uint8
        scanning_frequency float32
    } {
        if {[string length $body] - $at < 28} {cut $body $at {4 4 4 4 4 4 4}}
        binary scan $body @${at}RRRRRIuR min_angle max_angle resolution max_range range_res intensity \
            scanning_frequency
        incr at 28
        set intensity [low 0xff $intensity]
        return [dict create min_angle $min_angle max_angle $max_angle resolution $resolution \
            max_range $max_range range_res $range_res intensity $intensity \
            scanning_frequency $scanning_frequency]
    } {
        append out [put float32 [dict get $value min_angle]]
        append out [put float32 [dict get $value max_angle]]
        append out [put float32 [dict get $value resolution]]
        append out [put float32 [dict get $value max_range]]
        append out [put float32 [dict get $value range_res]]
        append out [put uint8 [dict get $value intensity]]
        append out [put float32 [dict get $value scanning_frequency]]
        return $out
    }

    # The device's switch. (player_laser_power_config_t)
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

    # A serial number. (player_laser_get_id_config_t)
    #   serial_number: 0 in the request.
    struct GetIdConfig {
        serial_number uint32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu serial_number
        incr at 4
        return [dict create serial_number $serial_number]
    } {
        append out [put uint32 [dict get $value serial_number]]
        return $out
    }

    # A filter. (player_laser_set_filter_config_t)
    #   filter_type: Type of filter.
    #   parameters: Filter-specific.
    struct SetFilterConfig {
        filter_type uint8
        parameters float32[]
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}Iux4 filter_type
        incr at 8
        set filter_type [low 0xff $filter_type]
        set parameters [numbers $body R 4 [length $body parameters 8 4]]
        return [dict create filter_type $filter_type parameters $parameters]
    } {
        append out [put uint8 [dict get $value filter_type]]
        append out [count parameters [llength [dict get $value parameters]] 8]
        append out [count parameters [llength [dict get $value parameters]] 8]
        append out [put_list float32 [dict get $value parameters]]
        return $out
    }

    # One scan at equal angles.
    message laser.data.scan DATA 1 laser.Data
    # One scan and the pose at which it was measured.
    message laser.data.scanpose DATA 2 laser.DataScanpose
    # One scan with an angle per beam.
    message laser.data.scanangle DATA 3 laser.DataScanangle
    # Requests the device's size and pose.
    message laser.req.get_geom REQ 1 laser.Geom
    # Sets angles, resolution and rate; the answer has the values in effect.
    message laser.req.set_config REQ 2 laser.Config
    # Requests angles, resolution and rate.
    message laser.req.get_config REQ 3 laser.Config
    # Switches the device on or off.
    message laser.req.power REQ 4 laser.PowerConfig
    # Requests the serial number.
    message laser.req.get_id REQ 5 laser.GetIdConfig
    # Selects a filter for the ranges.
    message laser.req.set_filter REQ 6 laser.SetFilterConfig
}
