# Interface position3d, code 30. A robot that moves in 3D.
#
# Generated from interfaces/030_position3d.toml by codegen; do not edit.

::playhouse::wire::interface position3d 30 {
    # Odometry. (player_position3d_data_t)
    #   pos: Pose from odometry (in m, m, m, rad, rad, rad, frame X_OR).
    #   vel: Velocity along and about x, y and z (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R).
    #   stall: 1 if the robot is blocked by an obstacle.
    struct Data {
        pos common.Pose3d
        vel common.Pose3d
        stall uint8
    } {
        if {[string length $body] - $at < 100} {cut $body $at {8 8 8 8 8 8 8 8 8 8 8 8 4}}
        binary scan $body @${at}QQQQQQQQQQQQIu pos.px pos.py pos.pz pos.proll pos.ppitch pos.pyaw vel.px \
            vel.py vel.pz vel.proll vel.ppitch vel.pyaw stall
        incr at 100
        set stall [low 0xff $stall]
        return [dict create \
            pos [dict create px ${pos.px} py ${pos.py} pz ${pos.pz} proll ${pos.proll} ppitch ${pos.ppitch} pyaw ${pos.pyaw}] \
            vel [dict create px ${vel.px} py ${vel.py} pz ${vel.pz} proll ${vel.proll} ppitch ${vel.ppitch} pyaw ${vel.pyaw}] \
            stall $stall]
    } {
        append out [common::Pose3d.write [dict get $value pos]]
        append out [common::Pose3d.write [dict get $value vel]]
        append out [put uint8 [dict get $value stall]]
        return $out
    }

    # Commanded pose, and the velocity on the way. (player_position3d_cmd_pos_t)
    #   pos: Goal (in m, m, m, rad, rad, rad, frame X_OG).
    #   vel: Velocity on the way; zero: chosen by the driver (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame
    #     v_OR_R).
    #   state: 1: motors on, 0: off.
    struct CmdPos {
        pos common.Pose3d
        vel common.Pose3d
        state uint8
    } {
        if {[string length $body] - $at < 100} {cut $body $at {8 8 8 8 8 8 8 8 8 8 8 8 4}}
        binary scan $body @${at}QQQQQQQQQQQQIu pos.px pos.py pos.pz pos.proll pos.ppitch pos.pyaw vel.px \
            vel.py vel.pz vel.proll vel.ppitch vel.pyaw state
        incr at 100
        set state [low 0xff $state]
        return [dict create \
            pos [dict create px ${pos.px} py ${pos.py} pz ${pos.pz} proll ${pos.proll} ppitch ${pos.ppitch} pyaw ${pos.pyaw}] \
            vel [dict create px ${vel.px} py ${vel.py} pz ${vel.pz} proll ${vel.proll} ppitch ${vel.ppitch} pyaw ${vel.pyaw}] \
            state $state]
    } {
        append out [common::Pose3d.write [dict get $value pos]]
        append out [common::Pose3d.write [dict get $value vel]]
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # Commanded velocity. (player_position3d_cmd_vel_t)
    #   vel: Along and about x, y and z (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R).
    #   state: 1: motors on, 0: off.
    struct CmdVel {
        vel common.Pose3d
        state uint8
    } {
        if {[string length $body] - $at < 52} {cut $body $at {8 8 8 8 8 8 4}}
        binary scan $body @${at}QQQQQQIu vel.px vel.py vel.pz vel.proll vel.ppitch vel.pyaw state
        incr at 52
        set state [low 0xff $state]
        return [dict create \
            vel [dict create px ${vel.px} py ${vel.py} pz ${vel.pz} proll ${vel.proll} ppitch ${vel.ppitch} pyaw ${vel.pyaw}] \
            state $state]
    } {
        append out [common::Pose3d.write [dict get $value vel]]
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # The robot's size and centre of rotation. (player_position3d_geom_t)
    #   pose: Centre of the bounding box relative to the centre of rotation (in m, m, m, rad, rad, rad, frame
    #     X_RS).
    #   size: Bounding box of the robot (in m, m, m).
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

    # The motors' switch. (player_position3d_power_config_t)
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

    # A control mode. (player_position3d_position_mode_req_t)
    #   value: 0: velocity, 1: position.
    struct PositionModeReq {
        value uint32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu value
        incr at 4
        return [dict create value $value]
    } {
        append out [put uint32 [dict get $value value]]
        return $out
    }

    # A velocity controller. (player_position3d_velocity_mode_config_t)
    #   value: Driver-specific.
    struct VelocityModeConfig {
        value uint32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu value
        incr at 4
        return [dict create value $value]
    } {
        append out [put uint32 [dict get $value value]]
        return $out
    }

    # A new odometric pose. (player_position3d_set_odom_req_t)
    #   pos: New odometric pose (in m, m, m, rad, rad, rad, frame X_OR).
    struct SetOdomReq {
        pos common.Pose3d
    } {
        if {[string length $body] - $at < 48} {cut $body $at {8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQ pos.px pos.py pos.pz pos.proll pos.ppitch pos.pyaw
        incr at 48
        return [dict create \
            pos [dict create px ${pos.px} py ${pos.py} pz ${pos.pz} proll ${pos.proll} ppitch ${pos.ppitch} pyaw ${pos.pyaw}]]
    } {
        append out [common::Pose3d.write [dict get $value pos]]
        return $out
    }

    # Gains of velocity control. (player_position3d_speed_pid_req_t)
    #   kp: Proportional.
    #   ki: Integral.
    #   kd: Derivative.
    struct SpeedPidReq {
        kp float32
        ki float32
        kd float32
    } {
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}RRR kp ki kd
        incr at 12
        return [dict create kp $kp ki $ki kd $kd]
    } {
        append out [put float32 [dict get $value kp]]
        append out [put float32 [dict get $value ki]]
        append out [put float32 [dict get $value kd]]
        return $out
    }

    # Gains of position control. (player_position3d_position_pid_req_t)
    #   kp: Proportional.
    #   ki: Integral.
    #   kd: Derivative.
    struct PositionPidReq {
        kp float32
        ki float32
        kd float32
    } {
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}RRR kp ki kd
        incr at 12
        return [dict create kp $kp ki $ki kd $kd]
    } {
        append out [put float32 [dict get $value kp]]
        append out [put float32 [dict get $value ki]]
        append out [put float32 [dict get $value kd]]
        return $out
    }

    # Limits of position control. (player_position3d_speed_prof_req_t)
    #   speed: Maximum turn rate (in rad/s).
    #   acc: Maximum angular acceleration (in rad/s^2).
    struct SpeedProfReq {
        speed float32
        acc float32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}RR speed acc
        incr at 8
        return [dict create speed $speed acc $acc]
    } {
        append out [put float32 [dict get $value speed]]
        append out [put float32 [dict get $value acc]]
        return $out
    }

    # Odometry.
    message position3d.data.state DATA 1 position3d.Data
    # The robot's size, sent on change.
    message position3d.data.geometry DATA 2 position3d.Geom
    # Commanded velocity.
    message position3d.cmd.set_vel CMD 1 position3d.CmdVel
    # Commanded pose in the odometry frame.
    message position3d.cmd.set_pos CMD 2 position3d.CmdPos
    # Requests the robot's size and centre of rotation.
    message position3d.req.get_geom REQ 1 position3d.Geom
    # Switches the motors on or off.
    message position3d.req.motor_power REQ 2 position3d.PowerConfig
    # Selects the driver's velocity controller.
    message position3d.req.velocity_mode REQ 3 position3d.VelocityModeConfig
    # Selects between velocity and position control.
    message position3d.req.position_mode REQ 4 position3d.PositionModeReq
    # Sets the odometric pose to zero.
    message position3d.req.reset_odom REQ 5
    # Sets the odometric pose.
    message position3d.req.set_odom REQ 6 position3d.SetOdomReq
    # Sets the gains of velocity control.
    message position3d.req.speed_pid REQ 7 position3d.SpeedPidReq
    # Sets the gains of position control.
    message position3d.req.position_pid REQ 8 position3d.PositionPidReq
    # Sets the turn rate and angular acceleration limits of position control.
    message position3d.req.speed_prof REQ 9 position3d.SpeedProfReq
}
