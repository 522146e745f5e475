# Bases, and what drives them to goals.

# What bases in the plane and in space have in common. Closing one while it moves stops it first.
oo::class create ::playhouse::Base {
    superclass ::playhouse::Updating
    variable session opened moving

    constructor {args} {
        set moving 0
        next {*}$args
    }

    method stop {} {my drive 0.0}

    method setMotorPower {on} {
        my request [my interface].req.motor_power [dict create state [truth $on]]
        return
    }

    # Sets the pose estimate to zero.
    method resetOdometry {} {
        my request [my interface].req.reset_odom
        return
    }

    method geometry {} {
        return [my AskGeometry [my interface].req.get_geom]
    }

    method close {} {
        if {$opened && $moving && ![my gone] && [[$session connection] alive]} {my stop}
        next
    }

    method Value {} {return [my state]}
}

# A mobile base.
oo::class create ::playhouse::Position2d {
    superclass ::playhouse::Base
    variable moving

    # The newest state: a pose estimate in the frame of the start pose, or as setOdometry set it (with localization by
    # gps: the world), the velocity, whether the base is blocked, and the time.
    method state {} {
        lassign [my Stamped position2d.data.state] data time
        set velocity [from::pose [dict get $data vel]]
        return [dict create pose [from::pose [dict get $data pos]] velocity $velocity \
            stalled [expr {[dict get $data stall] != 0}] time $time]
    }

    method pose {} {return [dict get [my state] pose]}
    method velocity {} {return [dict get [my state] velocity]}
    method stalled {} {return [dict get [my state] stalled]}

    # Forward and to the left in m/s, turning in rad/s, until the next command.
    method drive {vx {va 0.0} {vy 0.0}} {
        my InsistOnFinite vx $vx va $va vy $vy
        set moving [expr {$vx != 0 || $vy != 0 || $va != 0}]
        my command position2d.cmd.vel [dict create vel [to::pose $vx $vy $va] state 1]
    }

    # For a base with car steering: speed in m/s, and steering angle in rad, positive to the left.
    method driveCar {speed steering} {
        my InsistOnFinite speed $speed steering $steering
        set moving [expr {$speed != 0}]
        my command position2d.cmd.car [dict create velocity $speed angle $steering]
    }

    # Drives to a pose in the frame of the state's pose, by the driver's position control; speed 0: the driver's choice.
    method goTo {x y a {speed 0.0}} {
        my InsistOnFinite x $x y $y a $a speed $speed
        set moving 1
        my command position2d.cmd.pos [dict create pos [to::pose $x $y $a] vel [to::pose $speed 0.0 0.0] state 1]
    }

    # Sets the pose estimate; the robot does not move.
    method setOdometry {x y a} {
        my InsistOnFinite x $x y $y a $a
        my request position2d.req.set_odom [dict create pose [to::pose $x $y $a]]
        return
    }
}

# A mobile base in space.
oo::class create ::playhouse::Position3d {
    superclass ::playhouse::Base
    variable moving

    method state {} {
        lassign [my Stamped position3d.data.state] data time
        return [dict create pose [from::pose3d [dict get $data pos]] velocity [from::pose3d [dict get $data vel]] \
            stalled [expr {[dict get $data stall] != 0}] time $time]
    }

    # Forward, to the left and upwards in m/s, turning in rad/s, until the next command.
    method drive {vx {va 0.0} {vy 0.0} {vz 0.0}} {
        my InsistOnFinite vx $vx va $va vy $vy vz $vz
        set moving [expr {$vx != 0 || $vy != 0 || $vz != 0 || $va != 0}]
        set velocity [to::pose3d [dict create x $vx y $vy z $vz yaw $va]]
        my command position3d.cmd.set_vel [dict create vel $velocity state 1]
    }

    # Moves to a pose3d in the frame of the state's pose, by the driver's position control.
    method goTo {pose} {
        my InsistOnFinite {*}$pose
        set goal [to::pose3d $pose]
        set moving 1
        my command position3d.cmd.set_pos [dict create pos $goal state 1]
    }

    # Sets the pose estimate, a pose3d.
    method setOdometry {pose} {
        my InsistOnFinite {*}$pose
        my request position3d.req.set_odom [dict create pos [to::pose3d $pose]]
        return
    }
}

# Localization of a robot on a map.
oo::class create ::playhouse::Localize {
    superclass ::playhouse::Updating
    variable session

    # Where the robot may be, the most likely first; the weights of all sum to 1.
    method hypotheses {} {
        return [lmap one [dict get [my Newest localize.data.hypoths] hypoths] {
            dict create pose [from::pose [dict get $one mean]] covariance [covariance {*}[dict get $one cov]] \
                weight [dict get $one alpha]
        }]
    }

    # The pose on the map of the most likely hypothesis. An error of kind NODATA also if there is none.
    method pose {} {
        set hypotheses [my hypotheses]
        if {![llength $hypotheses]} {fail NODATA "[$session peer]: [my name] has no hypothesis"}
        return [dict get [lindex $hypotheses 0] pose]
    }

    # Sets the estimate of the pose on the map; the robot does not move. An error of kind REFUSED if the driver takes
    # none of this covariance.
    method setPose {x y a covariance} {
        set covariance [to::complete covariance $covariance]
        my InsistOnFinite x $x y $y a $a {*}$covariance
        my request localize.req.set_pose [dict create mean [to::pose $x $y $a] cov [dict values $covariance]]
        return
    }

    # All particles of the filter; none before its first step.
    method particles {} {
        return [lmap one [dict get [my Ask localize.req.get_particles] particles] {
            dict create pose [from::pose [dict get $one pose]] weight [dict get $one alpha]
        }]
    }

    method Value {} {return [my hypotheses]}
}

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
