# A planner, which drives a robot to goals on a map. It continues while any client has it open; wavefront cancels the goal
# when the last one closes it.
oo::class create ::playhouse::Planner {
    superclass ::playhouse::Updating
    variable goal

    # Whether there is a path to the goal (valid), whether the goal is reached (done), the robot's pose, the goal, the
    # waypoint that the robot drives to, its index in the path (-1: none) and the number of waypoints, and the time.
    method state {} {
        lassign [my Stamped planner.data.state] data time
        return [dict create valid [expr {[dict get $data valid] != 0}] done [expr {[dict get $data done] != 0}] \
            pose [from::pose [dict get $data pos]] goal [from::pose [dict get $data goal]] \
            waypoint [from::pose [dict get $data waypoint]] \
            index [dict get $data waypoint_idx] count [dict get $data waypoints_count] time $time]
    }

    # Whether the last data say that the goal of the last goTo is reached; data of another goal do not count.
    method arrived {} {
        set data [my latest planner.data.state]
        if {$data eq "" || ![dict get $data done] || ![info exists goal]} {return 0}
        lassign [dict values [from::pose [dict get $data goal]]] x y a
        if {![isFinite $a] || $x != [dict get $goal x] || $y != [dict get $goal y]} {return 0}
        # Whole turns aside, which drivers drop.
        set turn [expr {$a - [dict get $goal a]}]
        return [expr {abs(atan2(sin($turn), cos($turn))) < 1e-6}]
    }

    # Plans a path to a pose on the map and drives there; after stop, from resume on.
    method goTo {x y a} {
        my InsistOnFinite x $x y $y a $a
        set goal [pose $x $y $a]
        my command planner.cmd.goal [dict create goal [to::pose $x $y $a]]
    }

    # Stops the robot until resume; the planner keeps its goal.
    method stop {} {
        my request planner.req.enable [dict create state 0]
        return
    }

    # Ends stop.
    method resume {} {
        my request planner.req.enable [dict create state 1]
        return
    }

    # The path as it was planned last; without waypoints if there is none.
    method path {} {
        set answer [my Ask planner.req.get_waypoints]
        return [dict create waypoints [lmap one [dict get $answer waypoints] {from::pose $one}] \
            length [dict get $answer waypoints_distance]]
    }

    method Value {} {return [my state]}
}
