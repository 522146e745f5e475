# Interface position2d, code 4. A robot that moves in the plane: odometry, velocity and position control.
#
# Generated from interfaces/004_position2d.toml by codegen; do not edit.

::playhouse::wire::interface position2d 4 {
    # Odometry. (player_position2d_data_t)
    #   pos: Pose from odometry (in m, m, rad, frame X_OR).
    #   vel: Velocity: forward, to the left, turning left (in m/s, m/s, rad/s, frame v_OR_R).
    #   stall: 1 if the robot is blocked by an obstacle.
    struct Data {
        pos common.Pose2d
        vel common.Pose2d
        stall uint8
    } {
        if {[string length $body] - $at < 52} {cut $body $at {8 8 8 8 8 8 4}}
        binary scan $body @${at}QQQQQQIu pos.px pos.py pos.pa vel.px vel.py vel.pa stall
        incr at 52
        set stall [low 0xff $stall]
        return [dict create pos [dict create px ${pos.px} py ${pos.py} pa ${pos.pa}] \
            vel [dict create px ${vel.px} py ${vel.py} pa ${vel.pa}] stall $stall]
    } {
        append out [common::Pose2d.write [dict get $value pos]]
        append out [common::Pose2d.write [dict get $value vel]]
        append out [put uint8 [dict get $value stall]]
        return $out
    }

    # Commanded velocity. (player_position2d_cmd_vel_t)
    #   vel: Forward, to the left, turning left; for a simulated car the last part is its steering angle in
    #     rad (in m/s, m/s, rad/s, frame v_OR_R).
    #   state: 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER.
    struct CmdVel {
        vel common.Pose2d
        state uint8
    } {
        if {[string length $body] - $at < 28} {cut $body $at {8 8 8 4}}
        binary scan $body @${at}QQQIu vel.px vel.py vel.pa state
        incr at 28
        set state [low 0xff $state]
        return [dict create vel [dict create px ${vel.px} py ${vel.py} pa ${vel.pa}] state $state]
    } {
        append out [common::Pose2d.write [dict get $value vel]]
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # Commanded pose, and the velocity on the way. (player_position2d_cmd_pos_t)
    #   pos: Goal (in m, m, rad, frame X_OG).
    #   vel: Velocity on the way; zero: chosen by the driver. Simulated robots ignore it (in m/s, m/s, rad/s,
    #     frame v_OR_R).
    #   state: 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER.
    struct CmdPos {
        pos common.Pose2d
        vel common.Pose2d
        state uint8
    } {
        if {[string length $body] - $at < 52} {cut $body $at {8 8 8 8 8 8 4}}
        binary scan $body @${at}QQQQQQIu pos.px pos.py pos.pa vel.px vel.py vel.pa state
        incr at 52
        set state [low 0xff $state]
        return [dict create pos [dict create px ${pos.px} py ${pos.py} pa ${pos.pa}] \
            vel [dict create px ${vel.px} py ${vel.py} pa ${vel.pa}] state $state]
    } {
        append out [common::Pose2d.write [dict get $value pos]]
        append out [common::Pose2d.write [dict get $value vel]]
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # Commanded motion of a car. (player_position2d_cmd_car_t)
    #   velocity: Forward (in m/s).
    #   angle: Steering angle of the front wheels, positive to the left; a simulated robot without them uses
    #     it as turn rate in rad/s (in rad).
    struct CmdCar {
        velocity float64
        angle float64
    } {
        if {[string length $body] - $at < 16} {cut $body $at {8 8}}
        binary scan $body @${at}QQ velocity angle
        incr at 16
        return [dict create velocity $velocity angle $angle]
    } {
        append out [put float64 [dict get $value velocity]]
        append out [put float64 [dict get $value angle]]
        return $out
    }

    # Commanded speed and heading. (player_position2d_cmd_vel_head_t)
    #   velocity: Forward (in m/s).
    #   angle: Heading in the odometry frame (in rad).
    struct CmdVelHead {
        velocity float64
        angle float64
    } {
        if {[string length $body] - $at < 16} {cut $body $at {8 8}}
        binary scan $body @${at}QQ velocity angle
        incr at 16
        return [dict create velocity $velocity angle $angle]
    } {
        append out [put float64 [dict get $value velocity]]
        append out [put float64 [dict get $value angle]]
        return $out
    }

    # The robot's size and centre of rotation. (player_position2d_geom_t)
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

    # The motors' switch. (player_position2d_power_config_t)
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

    # A velocity controller. (player_position2d_velocity_mode_config_t)
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

    # A control mode. (player_position2d_position_mode_req_t)
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

    # A new odometric pose. (player_position2d_set_odom_req_t)
    #   pose: New odometric pose (in m, m, rad, frame X_OR).
    struct SetOdomReq {
        pose common.Pose2d
    } {
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}QQQ pose.px pose.py pose.pa
        incr at 24
        return [dict create pose [dict create px ${pose.px} py ${pose.py} pa ${pose.pa}]]
    } {
        append out [common::Pose2d.write [dict get $value pose]]
        return $out
    }

    # Gains of velocity control. (player_position2d_speed_pid_req_t)
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

    # Gains of position control. (player_position2d_position_pid_req_t)
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

    # Limits of position control. (player_position2d_speed_prof_req_t)
    #   speed: Maximum speed (in m/s).
    #   acc: Maximum acceleration (in m/s^2).
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

    # Requests the robot's size and centre of rotation.
    message position2d.req.get_geom REQ 1 position2d.Geom
    # Switches the motors on or off.
    message position2d.req.motor_power REQ 2 position2d.PowerConfig
    # Selects the driver's velocity controller.
    message position2d.req.velocity_mode REQ 3 position2d.VelocityModeConfig
    # Selects between velocity and position control.
    message position2d.req.position_mode REQ 4 position2d.PositionModeReq
    # Sets the odometric pose.
    message position2d.req.set_odom REQ 5 position2d.SetOdomReq
    # Sets the odometric pose to zero.
    message position2d.req.reset_odom REQ 6
    # Sets the gains of velocity control.
    message position2d.req.speed_pid REQ 7 position2d.SpeedPidReq
    # Sets the gains of position control.
    message position2d.req.position_pid REQ 8 position2d.PositionPidReq
    # Sets the speed and acceleration limits of position control.
    message position2d.req.speed_prof REQ 9 position2d.SpeedProfReq
    # Odometry.
    message position2d.data.state DATA 1 position2d.Data
    # The robot's size, sent on change.
    message position2d.data.geom DATA 2 position2d.Geom
    # Commanded velocity.
    message position2d.cmd.vel CMD 1 position2d.CmdVel
    # Commanded pose in the odometry frame.
    message position2d.cmd.pos CMD 2 position2d.CmdPos
    # Commanded speed and steering angle of a car.
    message position2d.cmd.car CMD 3 position2d.CmdCar
    # Commanded speed and heading.
    message position2d.cmd.vel_head CMD 4 position2d.CmdVelHead
}
