# Interface ptz, code 8. A camera mount that pans, tilts and zooms.
#
# Generated from interfaces/008_ptz.toml by codegen; do not edit.

::playhouse::wire::interface ptz 8 {
    # Values of ReqControlMode.mode.
    variable VELOCITY_CONTROL 0
    variable POSITION_CONTROL 1

    # Direction of the mount. (player_ptz_data_t)
    #   pan: Positive to the left (in rad).
    #   tilt: Positive upwards (in rad).
    #   zoom: Field of view (in rad).
    #   panspeed: Positive to the left (in rad/s).
    #   tiltspeed: Positive upwards (in rad/s).
    #   status: Driver-specific.
    struct Data {
        pan float32
        tilt float32
        zoom float32
        panspeed float32
        tiltspeed float32
        status uint32
    } {
        if {[string length $body] - $at < 24} {cut $body $at {4 4 4 4 4 4}}
        binary scan $body @${at}RRRRRIu pan tilt zoom panspeed tiltspeed status
        incr at 24
        return [dict create pan $pan tilt $tilt zoom $zoom panspeed $panspeed tiltspeed $tiltspeed \
            status $status]
    } {
        append out [put float32 [dict get $value pan]]
        append out [put float32 [dict get $value tilt]]
        append out [put float32 [dict get $value zoom]]
        append out [put float32 [dict get $value panspeed]]
        append out [put float32 [dict get $value tiltspeed]]
        append out [put uint32 [dict get $value status]]
        return $out
    }

    # Commanded direction or velocity of the mount. (player_ptz_cmd_t)
    #   pan: Positive to the left (in rad).
    #   tilt: Positive upwards (in rad).
    #   zoom: Field of view (in rad).
    #   panspeed: Used by velocity control (in rad/s).
    #   tiltspeed: Used by velocity control (in rad/s).
    struct Cmd {
        pan float32
        tilt float32
        zoom float32
        panspeed float32
        tiltspeed float32
    } {
        if {[string length $body] - $at < 20} {cut $body $at {4 4 4 4 4}}
        binary scan $body @${at}RRRRR pan tilt zoom panspeed tiltspeed
        incr at 20
        return [dict create pan $pan tilt $tilt zoom $zoom panspeed $panspeed tiltspeed $tiltspeed]
    } {
        append out [put float32 [dict get $value pan]]
        append out [put float32 [dict get $value tilt]]
        append out [put float32 [dict get $value zoom]]
        append out [put float32 [dict get $value panspeed]]
        append out [put float32 [dict get $value tiltspeed]]
        return $out
    }

    # The mount's status. (player_ptz_req_status_t)
    #   status: Driver-specific.
    struct ReqStatus {
        status uint32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu status
        incr at 4
        return [dict create status $status]
    } {
        append out [put uint32 [dict get $value status]]
        return $out
    }

    # The mount's size and pose. (player_ptz_geom_t)
    #   pos: Pose of the mount on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    #   size: Bounding box of the mount (in m, m, m).
    struct Geom {
        pos common.Pose3d
        size common.Bbox3d
    } {
        if {[string length $body] - $at < 72} {cut $body $at {8 8 8 8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQQQQ pos.px pos.py pos.pz pos.proll pos.ppitch pos.pyaw size.sw \
            size.sl size.sh
        incr at 72
        return [dict create \
            pos [dict create px ${pos.px} py ${pos.py} pz ${pos.pz} proll ${pos.proll} ppitch ${pos.ppitch} pyaw ${pos.pyaw}] \
            size [dict create sw ${size.sw} sl ${size.sl} sh ${size.sh}]]
    } {
        append out [common::Pose3d.write [dict get $value pos]]
        append out [common::Bbox3d.write [dict get $value size]]
        return $out
    }

    # Driver-specific words. (player_ptz_req_generic_t)
    #   config: Driver-specific.
    struct ReqGeneric {
        config uint32[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu config.count
        incr at 4
        set config [numbers $body Iu 4 [length $body config ${config.count} 4]]
        return [dict create config $config]
    } {
        append out [count config [llength [dict get $value config]] 8388598]
        append out [count config [llength [dict get $value config]] 8388598]
        append out [put_list uint32 [dict get $value config]]
        return $out
    }

    # A control mode. (player_ptz_req_control_mode_t)
    #   mode: Velocity or position.
    struct ReqControlMode {
        mode uint32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu mode
        incr at 4
        return [dict create mode $mode]
    } {
        append out [put uint32 [dict get $value mode]]
        return $out
    }

    # Exchanges driver-specific words with the mount.
    message ptz.req.generic REQ 1 ptz.ReqGeneric
    # Selects between velocity and position control.
    message ptz.req.control_mode REQ 2 ptz.ReqControlMode
    # Requests size and pose.
    message ptz.req.geom REQ 4 ptz.Geom
    # Requests the mount's status.
    message ptz.req.status REQ 5 ptz.ReqStatus
    # Direction of the mount.
    message ptz.data.state DATA 1 ptz.Data
    # Size and pose, sent on change.
    message ptz.data.geom DATA 2 ptz.Geom
    # Commanded direction of the mount.
    message ptz.cmd.state CMD 1 ptz.Cmd
}
