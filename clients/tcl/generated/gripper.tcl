# Interface gripper, code 3. A two-finger gripper, with break beams between the fingers and optionally a
# store for objects.
#
# Generated from interfaces/003_gripper.toml by codegen; do not edit.

::playhouse::wire::interface gripper 3 {
    # Values of Data.state.
    variable STATE_OPEN 1
    variable STATE_CLOSED 2
    variable STATE_MOVING 3
    variable STATE_ERROR 4

    # State of the fingers and of the break beams. (player_gripper_data_t)
    #   state: Open, closed, moving or faulty.
    #   beams: One bit per break beam, set if it is interrupted.
    #   stored: Number of stored objects.
    struct Data {
        state uint8
        beams uint32
        stored uint8
    } {
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}IuIuIu state beams stored
        incr at 12
        set state [low 0xff $state]
        set stored [low 0xff $stored]
        return [dict create state $state beams $beams stored $stored]
    } {
        append out [put uint8 [dict get $value state]]
        append out [put uint32 [dict get $value beams]]
        append out [put uint8 [dict get $value stored]]
        return $out
    }

    # The gripper's size and pose. (player_gripper_geom_t)
    #   pose: Pose of the gripper on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    #   outer_size: Around the fingers (in m, m, m).
    #   inner_size: Of the gap between the open fingers (in m, m, m).
    #   num_beams: Number of break beams.
    #   capacity: Capacity of the store, in objects.
    struct Geom {
        pose common.Pose3d
        outer_size common.Bbox3d
        inner_size common.Bbox3d
        num_beams uint8
        capacity uint8
    } {
        if {[string length $body] - $at < 104} {cut $body $at {8 8 8 8 8 8 8 8 8 8 8 8 4 4}}
        binary scan $body @${at}QQQQQQQQQQQQIuIu pose.px pose.py pose.pz pose.proll pose.ppitch pose.pyaw \
            outer_size.sw outer_size.sl outer_size.sh inner_size.sw inner_size.sl inner_size.sh num_beams \
            capacity
        incr at 104
        set num_beams [low 0xff $num_beams]
        set capacity [low 0xff $capacity]
        return [dict create \
            pose [dict create px ${pose.px} py ${pose.py} pz ${pose.pz} proll ${pose.proll} ppitch ${pose.ppitch} pyaw ${pose.pyaw}] \
            outer_size [dict create sw ${outer_size.sw} sl ${outer_size.sl} sh ${outer_size.sh}] \
            inner_size [dict create sw ${inner_size.sw} sl ${inner_size.sl} sh ${inner_size.sh}] \
            num_beams $num_beams capacity $capacity]
    } {
        append out [common::Pose3d.write [dict get $value pose]]
        append out [common::Bbox3d.write [dict get $value outer_size]]
        append out [common::Bbox3d.write [dict get $value inner_size]]
        append out [put uint8 [dict get $value num_beams]]
        append out [put uint8 [dict get $value capacity]]
        return $out
    }

    # State of the fingers and of the break beams.
    message gripper.data.state DATA 1 gripper.Data
    # Requests the gripper's size and pose.
    message gripper.req.get_geom REQ 1 gripper.Geom
    # Opens the fingers.
    message gripper.cmd.open CMD 1
    # Closes the fingers.
    message gripper.cmd.close CMD 2
    # Stops the fingers at their current position.
    message gripper.cmd.stop CMD 3
    # Moves the held object into the store.
    message gripper.cmd.store CMD 4
    # Moves the object stored last between the fingers.
    message gripper.cmd.retrieve CMD 5
}
