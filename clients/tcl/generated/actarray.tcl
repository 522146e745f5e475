# Interface actarray, code 53. A chain of prismatic or revolute joints, such as an arm.
#
# Generated from interfaces/053_actarray.toml by codegen; do not edit.

::playhouse::wire::interface actarray 53 {
    # Values of Actuator.state.
    variable ACTSTATE_IDLE 1
    variable ACTSTATE_MOVING 2
    variable ACTSTATE_BRAKED 4
    variable ACTSTATE_STALLED 8

    # Values of Actuatorgeom.type.
    variable TYPE_LINEAR 1
    variable TYPE_ROTARY 2

    # State of one joint. (player_actarray_actuator_t)
    #   position: in m or rad.
    #   speed: in m/s or rad/s.
    #   acceleration: in m/s^2 or rad/s^2.
    #   current: Of its motor; -1 if unknown (in A).
    #   state: Idle, moving, braked or stalled.
    struct Actuator {
        position float32
        speed float32
        acceleration float32
        current float32
        state uint8
    } {
        if {[string length $body] - $at < 20} {cut $body $at {4 4 4 4 4}}
        binary scan $body @${at}RRRRIu position speed acceleration current state
        incr at 20
        set state [low 0xff $state]
        return [dict create position $position speed $speed acceleration $acceleration current $current \
            state $state]
    } {
        append out [put float32 [dict get $value position]]
        append out [put float32 [dict get $value speed]]
        append out [put float32 [dict get $value acceleration]]
        append out [put float32 [dict get $value current]]
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # State of each joint. (player_actarray_data_t)
    #   motor_state: 1: motors on, 0: off.
    struct Data {
        actuators actarray.Actuator[]
        motor_state uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu actuators.count
        incr at 4
        set actuators {}
        for {set actuators.left [length $body actuators ${actuators.count} 20]} {${actuators.left} > 0} {incr actuators.left -1} {
            lappend actuators [Actuator.read $body]
        }
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu motor_state
        incr at 4
        set motor_state [low 0xff $motor_state]
        return [dict create actuators $actuators motor_state $motor_state]
    } {
        append out [count actuators [llength [dict get $value actuators]] 1677719]
        append out [count actuators [llength [dict get $value actuators]] 1677719]
        foreach item [dict get $value actuators] {append out [Actuator.write $item]}
        append out [put uint8 [dict get $value motor_state]]
        return $out
    }

    # Description of a joint. (player_actarray_actuatorgeom_t)
    #   type: Prismatic or revolute.
    #   length: To the next joint (in m).
    #   orientation: Orientation of the joint at rest, relative to the previous joint (in rad, rad, rad, frame
    #     R_BJ).
    #   axis: Unit vector of the axis of translation or rotation (frame n_J).
    #   min: Lowest position (in m or rad).
    #   centre: Centre position (in m or rad).
    #   max: Highest position (in m or rad).
    #   home: Position after CMD HOME (in m or rad).
    #   config_speed: Speed in position control (in m/s or rad/s).
    #   hasbrakes: 1 if it has brakes.
    struct Actuatorgeom {
        type uint8
        length float32
        orientation common.Orientation3d
        axis common.Point3d
        min float32
        centre float32
        max float32
        home float32
        config_speed float32
        hasbrakes uint8
    } {
        if {[string length $body] - $at < 80} {cut $body $at {4 4 8 8 8 8 8 8 4 4 4 4 4 4}}
        binary scan $body @${at}IuRQQQQQQRRRRRIu type length orientation.proll orientation.ppitch \
            orientation.pyaw axis.px axis.py axis.pz min centre max home config_speed hasbrakes
        incr at 80
        set type [low 0xff $type]
        set hasbrakes [low 0xff $hasbrakes]
        return [dict create type $type length $length \
            orientation [dict create proll ${orientation.proll} ppitch ${orientation.ppitch} pyaw ${orientation.pyaw}] \
            axis [dict create px ${axis.px} py ${axis.py} pz ${axis.pz}] min $min centre $centre \
            max $max home $home config_speed $config_speed hasbrakes $hasbrakes]
    } {
        append out [put uint8 [dict get $value type]]
        append out [put float32 [dict get $value length]]
        append out [common::Orientation3d.write [dict get $value orientation]]
        append out [common::Point3d.write [dict get $value axis]]
        append out [put float32 [dict get $value min]]
        append out [put float32 [dict get $value centre]]
        append out [put float32 [dict get $value max]]
        append out [put float32 [dict get $value home]]
        append out [put float32 [dict get $value config_speed]]
        append out [put uint8 [dict get $value hasbrakes]]
        return $out
    }

    # Joints and base pose of the chain. (player_actarray_geom_t)
    #   base_pos: Position of the base of the chain on the robot (in m, frame p_RB).
    #   base_orientation: Orientation of the base of the chain on the robot (in rad, frame R_RB).
    struct Geom {
        actuators actarray.Actuatorgeom[]
        base_pos common.Point3d
        base_orientation common.Orientation3d
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu actuators.count
        incr at 4
        set actuators {}
        for {set actuators.left [length $body actuators ${actuators.count} 80]} {${actuators.left} > 0} {incr actuators.left -1} {
            lappend actuators [Actuatorgeom.read $body]
        }
        if {[string length $body] - $at < 48} {cut $body $at {8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQ base_pos.px base_pos.py base_pos.pz base_orientation.proll \
            base_orientation.ppitch base_orientation.pyaw
        incr at 48
        return [dict create actuators $actuators \
            base_pos [dict create px ${base_pos.px} py ${base_pos.py} pz ${base_pos.pz}] \
            base_orientation [dict create proll ${base_orientation.proll} ppitch ${base_orientation.ppitch} pyaw ${base_orientation.pyaw}]]
    } {
        append out [count actuators [llength [dict get $value actuators]] 419429]
        append out [count actuators [llength [dict get $value actuators]] 419429]
        foreach item [dict get $value actuators] {append out [Actuatorgeom.write $item]}
        append out [common::Point3d.write [dict get $value base_pos]]
        append out [common::Orientation3d.write [dict get $value base_orientation]]
        return $out
    }

    # Commanded position of one joint. (player_actarray_position_cmd_t)
    #   joint: Index of the joint, from 0.
    #   position: in m or rad.
    struct PositionCmd {
        joint int32
        position float32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IR joint position
        incr at 8
        return [dict create joint $joint position $position]
    } {
        append out [put int32 [dict get $value joint]]
        append out [put float32 [dict get $value position]]
        return $out
    }

    # Commanded positions of all joints. (player_actarray_multi_position_cmd_t)
    #   positions: in m or rad.
    struct MultiPositionCmd {
        positions float32[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu positions.count
        incr at 4
        set positions [numbers $body R 4 [length $body positions ${positions.count} 4]]
        return [dict create positions $positions]
    } {
        append out [count positions [llength [dict get $value positions]] 8388598]
        append out [count positions [llength [dict get $value positions]] 8388598]
        append out [put_list float32 [dict get $value positions]]
        return $out
    }

    # Commanded speed of one joint. (player_actarray_speed_cmd_t)
    #   joint: Index of the joint, from 0.
    #   speed: in m/s or rad/s.
    struct SpeedCmd {
        joint int32
        speed float32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IR joint speed
        incr at 8
        return [dict create joint $joint speed $speed]
    } {
        append out [put int32 [dict get $value joint]]
        append out [put float32 [dict get $value speed]]
        return $out
    }

    # Commanded speeds of all joints. (player_actarray_multi_speed_cmd_t)
    #   speeds: in m/s or rad/s.
    struct MultiSpeedCmd {
        speeds float32[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu speeds.count
        incr at 4
        set speeds [numbers $body R 4 [length $body speeds ${speeds.count} 4]]
        return [dict create speeds $speeds]
    } {
        append out [count speeds [llength [dict get $value speeds]] 8388598]
        append out [count speeds [llength [dict get $value speeds]] 8388598]
        append out [put_list float32 [dict get $value speeds]]
        return $out
    }

    # A joint to move to its home position. (player_actarray_home_cmd_t)
    #   joint: Index of the joint; -1: all.
    struct HomeCmd {
        joint int32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}I joint
        incr at 4
        return [dict create joint $joint]
    } {
        append out [put int32 [dict get $value joint]]
        return $out
    }

    # Commanded current of one joint. (player_actarray_current_cmd_t)
    #   joint: Index of the joint, from 0.
    #   current: in A.
    struct CurrentCmd {
        joint int32
        current float32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IR joint current
        incr at 8
        return [dict create joint $joint current $current]
    } {
        append out [put int32 [dict get $value joint]]
        append out [put float32 [dict get $value current]]
        return $out
    }

    # Commanded currents of all joints. (player_actarray_multi_current_cmd_t)
    #   currents: in A.
    struct MultiCurrentCmd {
        currents float32[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu currents.count
        incr at 4
        set currents [numbers $body R 4 [length $body currents ${currents.count} 4]]
        return [dict create currents $currents]
    } {
        append out [count currents [llength [dict get $value currents]] 8388598]
        append out [count currents [llength [dict get $value currents]] 8388598]
        append out [put_list float32 [dict get $value currents]]
        return $out
    }

    # The motors' switch. (player_actarray_power_config_t)
    #   value: 1: on, 0: off.
    struct PowerConfig {
        value uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu value
        incr at 4
        set value [low 0xff $value]
        return [dict create value $value]
    } {
        append out [put uint8 [dict get $value value]]
        return $out
    }

    # The brakes' switch. (player_actarray_brakes_config_t)
    #   value: 1: braked, 0: released.
    struct BrakesConfig {
        value uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu value
        incr at 4
        set value [low 0xff $value]
        return [dict create value $value]
    } {
        append out [put uint8 [dict get $value value]]
        return $out
    }

    # Speed of one joint. (player_actarray_speed_config_t)
    #   joint: Index of the joint; -1: all.
    #   speed: in m/s or rad/s.
    struct SpeedConfig {
        joint int32
        speed float32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IR joint speed
        incr at 8
        return [dict create joint $joint speed $speed]
    } {
        append out [put int32 [dict get $value joint]]
        append out [put float32 [dict get $value speed]]
        return $out
    }

    # Acceleration of one joint. (player_actarray_accel_config_t)
    #   joint: Index of the joint; -1: all.
    #   accel: in m/s^2 or rad/s^2.
    struct AccelConfig {
        joint int32
        accel float32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IR joint accel
        incr at 8
        return [dict create joint $joint accel $accel]
    } {
        append out [put int32 [dict get $value joint]]
        append out [put float32 [dict get $value accel]]
        return $out
    }

    # Switches the motors on or off.
    message actarray.req.power REQ 1 actarray.PowerConfig
    # Sets or releases the brakes.
    message actarray.req.brakes REQ 2 actarray.BrakesConfig
    # Requests the joints and the base pose of the chain.
    message actarray.req.get_geom REQ 3 actarray.Geom
    # Sets a joint's speed in position control.
    message actarray.req.speed REQ 4 actarray.SpeedConfig
    # Sets a joint's acceleration in position control.
    message actarray.req.accel REQ 5 actarray.AccelConfig
    # Commanded position of one joint.
    message actarray.cmd.pos CMD 1 actarray.PositionCmd
    # Commanded positions of all joints.
    message actarray.cmd.multi_pos CMD 2 actarray.MultiPositionCmd
    # Commanded speed of one joint.
    message actarray.cmd.speed CMD 3 actarray.SpeedCmd
    # Commanded speeds of all joints.
    message actarray.cmd.multi_speed CMD 4 actarray.MultiSpeedCmd
    # Moves one joint, or all, to the home position.
    message actarray.cmd.home CMD 5 actarray.HomeCmd
    # Commanded current of one joint.
    message actarray.cmd.current CMD 6 actarray.CurrentCmd
    # Commanded currents of all joints.
    message actarray.cmd.multi_current CMD 7 actarray.MultiCurrentCmd
    # State of each joint.
    message actarray.data.state DATA 1 actarray.Data
}
