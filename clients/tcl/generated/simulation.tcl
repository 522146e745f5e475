# Interface simulation, code 31. A simulator: reads and moves its models, pauses and resets it.
#
# Generated from interfaces/031_simulation.toml by codegen; do not edit.

::playhouse::wire::interface simulation 31 {
    # Not sent by any message. (player_simulation_data_t)
    #   data: Without meaning.
    struct Data {
        data uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu data
        incr at 4
        set data [low 0xff $data]
        return [dict create data $data]
    } {
        append out [put uint8 [dict get $value data]]
        return $out
    }

    # Not sent by any message. (player_simulation_cmd_t)
    #   cmd: Without meaning.
    struct Cmd {
        cmd uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu cmd
        incr at 4
        set cmd [low 0xff $cmd]
        return [dict create cmd $cmd]
    } {
        append out [put uint8 [dict get $value cmd]]
        return $out
    }

    # A model and its pose. (player_simulation_pose2d_req_t)
    #   name: Of the model, NUL-terminated.
    #   pose: Pose of the model in its parent (the world for a top-level model); ignored in a request (in m,
    #     m, rad, frame X_PT).
    struct Pose2dReq {
        name char[]
        pose common.Pose2d
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu name.count
        incr at 4
        set name [opaque $body [length $body name ${name.count} 1]]
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}QQQ pose.px pose.py pose.pa
        incr at 24
        return [dict create name $name pose [dict create px ${pose.px} py ${pose.py} pa ${pose.pa}]]
    } {
        append out [count name [string length [dict get $value name]] 33554392]
        append out [count name [string length [dict get $value name]] 33554392]
        append out [pad name [dict get $value name]]
        append out [common::Pose2d.write [dict get $value pose]]
        return $out
    }

    # A model, its pose and the time. (player_simulation_pose3d_req_t)
    #   name: Of the model, NUL-terminated.
    #   pose: Pose of the model in its parent (the world for a top-level model); ignored in a request (in m,
    #     m, m, rad, rad, rad, frame X_PT).
    #   simtime: Simulated time of the pose, as counted by Stage; set in answers only (in us).
    struct Pose3dReq {
        name char[]
        pose common.Pose3d
        simtime float64
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu name.count
        incr at 4
        set name [opaque $body [length $body name ${name.count} 1]]
        if {[string length $body] - $at < 56} {cut $body $at {8 8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQQ pose.px pose.py pose.pz pose.proll pose.ppitch pose.pyaw simtime
        incr at 56
        return [dict create name $name \
            pose [dict create px ${pose.px} py ${pose.py} pz ${pose.pz} proll ${pose.proll} ppitch ${pose.ppitch} pyaw ${pose.pyaw}] \
            simtime $simtime]
    } {
        append out [count name [string length [dict get $value name]] 33554392]
        append out [count name [string length [dict get $value name]] 33554392]
        append out [pad name [dict get $value name]]
        append out [common::Pose3d.write [dict get $value pose]]
        append out [put float64 [dict get $value simtime]]
        return $out
    }

    # A property of a model. (player_simulation_property_req_t)
    #   name: Name of the model, NUL-terminated; empty for a property of the world.
    #   prop: Name of the property, NUL-terminated.
    #   index: Element of a list property: in a request the first one requested, in an answer the first of the
    #     next request, 0 at the end of the list.
    #   value: Bytes of the property, in a simulator-specific format; empty in a request.
    struct PropertyReq {
        name char[]
        prop char[]
        index uint32
        value char[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu name.count
        incr at 4
        set name [opaque $body [length $body name ${name.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu prop.count
        incr at 4
        set prop [opaque $body [length $body prop ${prop.count} 1]]
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuIu index value.count
        incr at 8
        set value [opaque $body [length $body value ${value.count} 1]]
        return [dict create name $name prop $prop index $index value $value]
    } {
        append out [count name [string length [dict get $value name]] 33554392]
        append out [count name [string length [dict get $value name]] 33554392]
        append out [pad name [dict get $value name]]
        append out [count prop [string length [dict get $value prop]] 33554392]
        append out [count prop [string length [dict get $value prop]] 33554392]
        append out [pad prop [dict get $value prop]]
        append out [put uint32 [dict get $value index]]
        append out [count value [string length [dict get $value value]] 33554392]
        append out [count value [string length [dict get $value value]] 33554392]
        append out [pad value [dict get $value value]]
        return $out
    }

    # Requests the pose of a model by name.
    message simulation.req.get_pose2d REQ 1 simulation.Pose2dReq
    # Moves a model by name.
    message simulation.req.set_pose2d REQ 2 simulation.Pose2dReq
    # Requests the pose of a model by name, and the time.
    message simulation.req.get_pose3d REQ 3 simulation.Pose3dReq
    # Moves a model by name.
    message simulation.req.set_pose3d REQ 4 simulation.Pose3dReq
    # Requests a property of a model by name; without a name, for "models", the list of all with their devices
    # (docs/drivers.md).
    message simulation.req.get_property REQ 5 simulation.PropertyReq
    # Sets a property of a model by name.
    message simulation.req.set_property REQ 6 simulation.PropertyReq
    # Pauses or resumes the simulated clock.
    message simulation.cmd.pause CMD 1
    # Resets the world to its start.
    message simulation.cmd.reset CMD 2
    # Saves the current world.
    message simulation.cmd.save CMD 3
}
