# Interface planner, code 44. Plans and follows a path to a goal.
#
# Generated from interfaces/044_planner.toml by codegen; do not edit.

::playhouse::wire::interface planner 44 {
    # Progress of the robot along its path. (player_planner_data_t)
    #   valid: 1 if there is a path to the goal.
    #   done: 1 if the goal is reached.
    #   pos: The robot (in m, m, rad, frame X_MR).
    #   goal: The goal (in m, m, rad, frame X_MG).
    #   waypoint: Current waypoint of the robot (in m, m, rad, frame X_MP).
    #   waypoint_idx: Index of that waypoint in the path; -1 if there is none.
    #   waypoints_count: Number of waypoints of the path.
    struct Data {
        valid uint8
        done uint8
        pos common.Pose2d
        goal common.Pose2d
        waypoint common.Pose2d
        waypoint_idx int32
        waypoints_count uint32
    } {
        if {[string length $body] - $at < 88} {cut $body $at {4 4 8 8 8 8 8 8 8 8 8 4 4}}
        binary scan $body @${at}IuIuQQQQQQQQQIIu valid done pos.px pos.py pos.pa goal.px goal.py goal.pa \
            waypoint.px waypoint.py waypoint.pa waypoint_idx waypoints_count
        incr at 88
        set valid [low 0xff $valid]
        set done [low 0xff $done]
        return [dict create valid $valid done $done \
            pos [dict create px ${pos.px} py ${pos.py} pa ${pos.pa}] \
            goal [dict create px ${goal.px} py ${goal.py} pa ${goal.pa}] \
            waypoint [dict create px ${waypoint.px} py ${waypoint.py} pa ${waypoint.pa}] \
            waypoint_idx $waypoint_idx waypoints_count $waypoints_count]
    } {
        append out [put uint8 [dict get $value valid]]
        append out [put uint8 [dict get $value done]]
        append out [common::Pose2d.write [dict get $value pos]]
        append out [common::Pose2d.write [dict get $value goal]]
        append out [common::Pose2d.write [dict get $value waypoint]]
        append out [put int32 [dict get $value waypoint_idx]]
        append out [put uint32 [dict get $value waypoints_count]]
        return $out
    }

    # A goal. (player_planner_cmd_t)
    #   goal: Goal pose (in m, m, rad, frame X_MG).
    struct Cmd {
        goal common.Pose2d
    } {
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}QQQ goal.px goal.py goal.pa
        incr at 24
        return [dict create goal [dict create px ${goal.px} py ${goal.py} pa ${goal.pa}]]
    } {
        append out [common::Pose2d.write [dict get $value goal]]
        return $out
    }

    # The planned path. (player_planner_waypoints_req_t)
    #   waypoints_distance: Length of the path (in m).
    #   waypoints: From the robot to the goal (in m, m, rad, frame X_MP).
    struct WaypointsReq {
        waypoints_distance float64
        waypoints common.Pose2d[]
    } {
        if {[string length $body] - $at < 12} {cut $body $at {8 4}}
        binary scan $body @${at}QIu waypoints_distance waypoints.count
        incr at 12
        set waypoints {}
        for {set waypoints.left [length $body waypoints ${waypoints.count} 24]} {${waypoints.left} > 0} {incr waypoints.left -1} {
            lappend waypoints [common::Pose2d.read $body]
        }
        return [dict create waypoints_distance $waypoints_distance waypoints $waypoints]
    } {
        append out [put float64 [dict get $value waypoints_distance]]
        append out [count waypoints [llength [dict get $value waypoints]] 1398099]
        append out [count waypoints [llength [dict get $value waypoints]] 1398099]
        foreach item [dict get $value waypoints] {append out [common::Pose2d.write $item]}
        return $out
    }

    # The planner's switch. (player_planner_enable_req_t)
    #   state: 1: may move, 0: stop.
    struct EnableReq {
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

    # Progress of the robot along its path.
    message planner.data.state DATA 1 planner.Data
    # Sets the goal.
    message planner.cmd.goal CMD 1 planner.Cmd
    # Sets the goal and starts to move.
    message planner.cmd.start CMD 2 planner.Cmd
    # Requests the planned path.
    message planner.req.get_waypoints REQ 1 planner.WaypointsReq
    # Enables or stops the robot.
    message planner.req.enable REQ 2 planner.EnableReq
}
