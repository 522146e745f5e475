# Interface position1d, code 52. A single prismatic or revolute actuator.
#
# Generated from interfaces/052_position1d.toml by codegen; do not edit.

::playhouse::wire::interface position1d 52 {
    # Bits of Data.status, by number.
    variable STATUS_LIMIT_MIN 0
    variable STATUS_LIMIT_CEN 1
    variable STATUS_LIMIT_MAX 2
    variable STATUS_OC 3
    variable STATUS_TRAJ_COMPLETE 4
    variable STATUS_ENABLED 5

    # Position of the actuator. (player_position1d_data_t)
    #   pos: From its zero (in m or rad).
    #   vel: in m/s or rad/s.
    #   stall: 1 if it is blocked by an obstacle.
    #   status: Limits, current, motion and power, one bit each.
    struct Data {
        pos float32
        vel float32
        stall uint8
        status uint8
    } {
        if {[string length $body] - $at < 16} {cut $body $at {4 4 4 4}}
        binary scan $body @${at}RRIuIu pos vel stall status
        incr at 16
        set stall [low 0xff $stall]
        set status [low 0xff $status]
        return [dict create pos $pos vel $vel stall $stall status $status]
    } {
        append out [put float32 [dict get $value pos]]
        append out [put float32 [dict get $value vel]]
        append out [put uint8 [dict get $value stall]]
        append out [put uint8 [dict get $value status]]
        return $out
    }

    # Commanded velocity. (player_position1d_cmd_vel_t)
    #   vel: in m/s or rad/s.
    #   state: 1: motor on, 0: off.
    struct CmdVel {
        vel float32
        state uint8
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}RIu vel state
        incr at 8
        set state [low 0xff $state]
        return [dict create vel $vel state $state]
    } {
        append out [put float32 [dict get $value vel]]
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # Commanded position. (player_position1d_cmd_pos_t)
    #   pos: From its zero (in m or rad).
    #   vel: Velocity on the way; zero: chosen by the driver (in m/s or rad/s).
    #   state: 1: motor on, 0: off.
    struct CmdPos {
        pos float32
        vel float32
        state uint8
    } {
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}RRIu pos vel state
        incr at 12
        set state [low 0xff $state]
        return [dict create pos $pos vel $vel state $state]
    } {
        append out [put float32 [dict get $value pos]]
        append out [put float32 [dict get $value vel]]
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # Size and pose. (player_position1d_geom_t)
    #   pose: Pose of the actuator on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    #   size: Bounding box of the actuator (in m, m, m).
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

    # The motor's switch. (player_position1d_power_config_t)
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

    # A velocity controller. (player_position1d_velocity_mode_config_t)
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

    # Request to set the current position to zero. (player_position1d_reset_odom_config_t)
    #   value: Without meaning.
    struct ResetOdomConfig {
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

    # A control mode. (player_position1d_position_mode_req_t)
    #   state: 0: velocity, 1: position.
    struct PositionModeReq {
        state uint32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu state
        incr at 4
        return [dict create state $state]
    } {
        append out [put uint32 [dict get $value state]]
        return $out
    }

    # New value of the current position. (player_position1d_set_odom_req_t)
    #   pos: New value of the current position (in m or rad).
    struct SetOdomReq {
        pos float32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}R pos
        incr at 4
        return [dict create pos $pos]
    } {
        append out [put float32 [dict get $value pos]]
        return $out
    }

    # Gains of velocity control. (player_position1d_speed_pid_req_t)
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

    # Gains of position control. (player_position1d_position_pid_req_t)
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

    # Limits of position control. (player_position1d_speed_prof_req_t)
    #   speed: Maximum speed (in m/s or rad/s).
    #   acc: Maximum acceleration (in m/s^2 or rad/s^2).
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

    # Requests size and pose.
    message position1d.req.get_geom REQ 1 position1d.Geom
    # Switches the motor on or off.
    message position1d.req.motor_power REQ 2 position1d.PowerConfig
    # Selects the driver's velocity controller.
    message position1d.req.velocity_mode REQ 3 position1d.VelocityModeConfig
    # Selects between velocity and position control.
    message position1d.req.position_mode REQ 4 position1d.PositionModeReq
    # Sets the reference of the position.
    message position1d.req.set_odom REQ 5 position1d.SetOdomReq
    # Sets the current position to zero.
    message position1d.req.reset_odom REQ 6 position1d.ResetOdomConfig
    # Sets the gains of velocity control.
    message position1d.req.speed_pid REQ 7 position1d.SpeedPidReq
    # Sets the gains of position control.
    message position1d.req.position_pid REQ 8 position1d.PositionPidReq
    # Sets the speed and acceleration limits of position control.
    message position1d.req.speed_prof REQ 9 position1d.SpeedProfReq
    # Position of the actuator.
    message position1d.data.state DATA 1 position1d.Data
    # Size and pose, sent on change.
    message position1d.data.geom DATA 2 position1d.Geom
    # Commanded velocity.
    message position1d.cmd.vel CMD 1 position1d.CmdVel
    # Commanded position.
    message position1d.cmd.pos CMD 2 position1d.CmdPos
}
