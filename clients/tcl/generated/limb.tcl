# Interface limb, code 54. An arm controlled by the pose of its end effector.
#
# Generated from interfaces/054_limb.toml by codegen; do not edit.

::playhouse::wire::interface limb 54 {
    # Values of Data.state.
    variable STATE_IDLE 1
    variable STATE_BRAKED 2
    variable STATE_MOVING 3
    variable STATE_OOR 4
    variable STATE_COLL 5

    # Pose of the end effector. (player_limb_data_t)
    #   position: in m, frame p_BE.
    #   approach: Approach direction, a unit vector (frame n_B).
    #   orientation: Unit vector across the end effector (frame n_B).
    #   state: Idle, braked, moving, out of reach or in contact.
    struct Data {
        position common.Point3d
        approach common.Point3d
        orientation common.Point3d
        state uint8
    } {
        if {[string length $body] - $at < 76} {cut $body $at {8 8 8 8 8 8 8 8 8 4}}
        binary scan $body @${at}QQQQQQQQQIu position.px position.py position.pz approach.px approach.py \
            approach.pz orientation.px orientation.py orientation.pz state
        incr at 76
        set state [low 0xff $state]
        return [dict create position [dict create px ${position.px} py ${position.py} pz ${position.pz}] \
            approach [dict create px ${approach.px} py ${approach.py} pz ${approach.pz}] \
            orientation [dict create px ${orientation.px} py ${orientation.py} pz ${orientation.pz}] \
            state $state]
    } {
        append out [common::Point3d.write [dict get $value position]]
        append out [common::Point3d.write [dict get $value approach]]
        append out [common::Point3d.write [dict get $value orientation]]
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # Commanded pose of the end effector. (player_limb_setpose_cmd_t)
    #   position: in m, frame p_BE.
    #   approach: Commanded approach direction, a unit vector (frame n_B).
    #   orientation: Unit vector across the end effector (frame n_B).
    struct SetposeCmd {
        position common.Point3d
        approach common.Point3d
        orientation common.Point3d
    } {
        if {[string length $body] - $at < 72} {cut $body $at {8 8 8 8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQQQQ position.px position.py position.pz approach.px approach.py \
            approach.pz orientation.px orientation.py orientation.pz
        incr at 72
        return [dict create position [dict create px ${position.px} py ${position.py} pz ${position.pz}] \
            approach [dict create px ${approach.px} py ${approach.py} pz ${approach.pz}] \
            orientation [dict create px ${orientation.px} py ${orientation.py} pz ${orientation.pz}]]
    } {
        append out [common::Point3d.write [dict get $value position]]
        append out [common::Point3d.write [dict get $value approach]]
        append out [common::Point3d.write [dict get $value orientation]]
        return $out
    }

    # Commanded position of the end effector. (player_limb_setposition_cmd_t)
    #   position: in m, frame p_BE.
    struct SetpositionCmd {
        position common.Point3d
    } {
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}QQQ position.px position.py position.pz
        incr at 24
        return [dict create position [dict create px ${position.px} py ${position.py} pz ${position.pz}]]
    } {
        append out [common::Point3d.write [dict get $value position]]
        return $out
    }

    # A straight motion of the end effector. (player_limb_vecmove_cmd_t)
    #   direction: Unit vector of the motion (frame n_B).
    #   length: Distance (in m).
    struct VecmoveCmd {
        direction common.Point3d
        length float32
    } {
        if {[string length $body] - $at < 28} {cut $body $at {8 8 8 4}}
        binary scan $body @${at}QQQR direction.px direction.py direction.pz length
        incr at 28
        return [dict create \
            direction [dict create px ${direction.px} py ${direction.py} pz ${direction.pz}] \
            length $length]
    } {
        append out [common::Point3d.write [dict get $value direction]]
        append out [put float32 [dict get $value length]]
        return $out
    }

    # The motors' switch. (player_limb_power_req_t)
    #   value: 1: on, 0: off.
    struct PowerReq {
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

    # The brakes' switch. (player_limb_brakes_req_t)
    #   value: 1: braked, 0: released.
    struct BrakesReq {
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

    # Pose of the arm's base. (player_limb_geom_req_t)
    #   basePos: Of the arm's base on the robot (in m, frame p_RB).
    struct GeomReq {
        basePos common.Point3d
    } {
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}QQQ basePos.px basePos.py basePos.pz
        incr at 24
        return [dict create basePos [dict create px ${basePos.px} py ${basePos.py} pz ${basePos.pz}]]
    } {
        append out [common::Point3d.write [dict get $value basePos]]
        return $out
    }

    # Speed of the end effector. (player_limb_speed_req_t)
    #   speed: Maximum speed of the end effector (in m/s).
    struct SpeedReq {
        speed float32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}R speed
        incr at 4
        return [dict create speed $speed]
    } {
        append out [put float32 [dict get $value speed]]
        return $out
    }

    # Pose of the end effector.
    message limb.data.state DATA 1 limb.Data
    # Moves the arm to its home position.
    message limb.cmd.home CMD 1
    # Stops the arm at its current position.
    message limb.cmd.stop CMD 2
    # Moves the end effector to a pose.
    message limb.cmd.setpose CMD 3 limb.SetposeCmd
    # Moves the end effector to a position, in any orientation.
    message limb.cmd.setposition CMD 4 limb.SetpositionCmd
    # Moves the end effector along a line from its current position.
    message limb.cmd.vecmove CMD 5 limb.VecmoveCmd
    # Switches the motors on or off.
    message limb.req.power REQ 1 limb.PowerReq
    # Sets or releases the brakes.
    message limb.req.brakes REQ 2 limb.BrakesReq
    # Requests the pose of the arm's base on the robot.
    message limb.req.geom REQ 3 limb.GeomReq
    # Sets the speed of the end effector.
    message limb.req.speed REQ 4 limb.SpeedReq
}
