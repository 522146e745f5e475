# Sensors.

# A range finder: a laser scanner, or a ring of sonars. Opening requests its configuration.
oo::class create ::playhouse::Ranger {
    superclass ::playhouse::Updating
    variable configuration geom

    constructor {args} {
        next {*}$args
        set configuration [record ranger.Config]
        set geom [record ranger.Geom]
    }

    # The ranger.Config and the ranger.Geom, in the server's fields.
    method config {} {return $configuration}
    method geom {} {return $geom}

    # In m, in the order of measurement.
    method ranges {} {
        return [dict get [my Newest ranger.data.range] ranges]
    }

    # One per range, in the device's unit. An error of kind NODATA also for a device without intensities.
    method intensities {} {
        return [dict get [my Newest ranger.data.intns] intensities]
    }

    # Ranges with directions: those of the elements if there is one per range, else spread over the field of view.
    method scan {} {
        lassign [my Stamped ranger.data.range] data time
        set ranges [dict get $data ranges]
        set poses [dict get $geom element_poses]
        set maxRange [dict get $configuration max_range]
        if {[llength $poses] == [llength $ranges] && [llength $ranges] > 1} {
            set angles [lmap pose $poses {dict get $pose pyaw}]
            return [dict create ranges $ranges angles $angles maxRange $maxRange time $time]
        }
        return [from::scan $ranges [dict get $configuration min_angle] [dict get $configuration max_angle] $maxRange $time]
    }

    method geometry {} {
        return [from::geometry [dict get $geom pose] [dict get $geom size]]
    }

    method setPower {on} {
        my request ranger.req.power [dict create state [truth $on]]
        return
    }

    # Enables or disables intensities.
    method setIntensities {on} {
        my request ranger.req.intns [dict create state [truth $on]]
        return
    }

    # Requests another ranger.Config; `config` then has the values in effect.
    method setConfig {config} {
        my request ranger.req.set_config $config
        set configuration [my Ask ranger.req.get_config]
        return
    }

    method prepare {} {
        set configuration [my Ask ranger.req.get_config]
        set geom [my Ask ranger.req.get_geom]
    }

    method Value {} {return [my scan]}
}

# A laser scanner; its data include the directions of the beams.
oo::class create ::playhouse::Laser {
    superclass ::playhouse::Updating

    method scan {} {
        lassign [my Stamped laser.data.scan] data time
        return [from::scan [dict get $data ranges] [dict get $data min_angle] [dict get $data max_angle] \
            [dict get $data max_range] $time]
    }

    # In m, from the smallest angle to the largest.
    method ranges {} {
        return [dict get [my Newest laser.data.scan] ranges]
    }

    # One number per range, in the device's unit; none if it measures none.
    method intensities {} {
        binary scan [dict get [my Newest laser.data.scan] intensity] cu* numbers
        return $numbers
    }

    # The laser.Config, in the server's fields.
    method config {} {
        return [my Ask laser.req.get_config]
    }

    method setConfig {config} {
        my request laser.req.set_config $config
        return
    }

    method geometry {} {
        return [my AskGeometry laser.req.get_geom]
    }

    method Value {} {return [my scan]}
}

# A ring of sonars.
oo::class create ::playhouse::Sonar {
    superclass ::playhouse::Device

    # In m, one per sonar, in the order of `poses`.
    method ranges {} {
        return [dict get [my Newest sonar.data.ranges] ranges]
    }

    # The poses (pose3d) of the sonars on the robot.
    method poses {} {
        return [lmap pose [dict get [my Ask sonar.req.get_geom] poses] {from::pose3d $pose}]
    }

    method setPower {on} {
        my request sonar.req.power [dict create state [truth $on]]
        return
    }
}

# A fiducial finder.
oo::class create ::playhouse::Fiducial {
    superclass ::playhouse::Updating

    # The markers in view.
    method markers {} {
        return [lmap item [dict get [my Newest fiducial.data.scan] fiducials] {from::marker $item}]
    }

    # The fiducial.Fov, in the server's fields.
    method fieldOfView {} {
        return [my Ask fiducial.req.get_fov]
    }

    # Ranges in m, the full field of view in rad.
    method setFieldOfView {minRange maxRange viewAngle} {
        my InsistOnFinite minRange $minRange maxRange $maxRange viewAngle $viewAngle
        my request fiducial.req.set_fov [dict create min_range $minRange max_range $maxRange view_angle $viewAngle]
        return
    }

    method geometry {} {
        return [my AskGeometry fiducial.req.get_geom]
    }

    method Value {} {return [my markers]}
}

# Contact switches.
oo::class create ::playhouse::Bumper {
    superclass ::playhouse::Updating

    # Whether each switch is pressed, in the order of `faces`.
    method pressed {} {
        binary scan [dict get [my Newest bumper.data.state] bumpers] cu* states
        return [lmap state $states {expr {$state != 0}}]
    }

    # The faces of the switches on the robot.
    method faces {} {
        return [lmap one [dict get [my Ask bumper.req.get_geom] bumper_def] {
            dict create pose [from::pose3d [dict get $one pose]] length [dict get $one length] radius [dict get $one radius]
        }]
    }

    method Value {} {return [my pressed]}
}

# An inertial unit. `send` selects the data message; initially it is that of `pose`.
oo::class create ::playhouse::Imu {
    superclass ::playhouse::Device

    # One of imu.data.state (pose), imu.data.calib (inertia), imu.data.quat (inertia and quaternion), imu.data.euler
    # (inertia and attitude) and imu.data.fullstate (pose and velocity), for all subscribers of the device.
    method send {message} {
        my request imu.req.set_datatype [dict create value [lindex [messageOf $message] 2]]
        return
    }

    # The estimated pose3d.
    method pose {} {
        return [from::pose3d [dict get [my NewestOf imu.data.state imu.data.fullstate] pose]]
    }

    # The estimated velocity, along and about its own axes, as a pose3d.
    method velocity {} {
        return [from::pose3d [dict get [my Newest imu.data.fullstate] vel]]
    }

    method inertia {} {
        set data [my NewestOf imu.data.calib imu.data.quat imu.data.euler]
        if {[dict exists $data calib_data]} {set data [dict get $data calib_data]}
        return [dict create acceleration [my Axes $data accel] turnRate [my Axes $data gyro] field [my Axes $data magn]]
    }

    # Roll, pitch and yaw, in rad.
    method attitude {} {
        return [dict values [dict get [my Newest imu.data.euler] orientation]]
    }

    # The orientation as four numbers, the real part first.
    method quaternion {} {
        set data [my Newest imu.data.quat]
        return [lmap name {q0 q1 q2 q3} {dict get $data $name}]
    }

    # Makes the current heading, or the whole current orientation, the reference.
    method resetOrientation {{allAxes 0}} {
        my request imu.req.reset_orientation [dict create value [truth $allAxes]]
        return
    }

    # Sets the current orientation, in rad.
    method resetAttitude {roll pitch yaw} {
        my InsistOnFinite roll $roll pitch $pitch yaw $yaw
        my request imu.req.reset_euler [dict create orientation [to::pose3d [pose3d 0.0 0.0 0.0 $roll $pitch $yaw]]]
        return
    }

    method LackOf {message} {
        return [next $message][expr {[my hasData] ? "; send $message selects it" : ""}]
    }

    method Axes {data what} {
        return [lmap axis {x y z} {dict get $data ${what}_$axis}]
    }

    # The newest value of several messages.
    method NewestOf {args} {
        set newest ""
        set at ""
        foreach message $args {
            if {[my latest $message] eq ""} continue
            lassign [my Stamped $message] value time
            if {$at eq "" || $time > $at} {
                set newest $value
                set at $time
            }
        }
        if {$at eq ""} {return [my Newest [lindex $args 0]]}
        return $newest
    }
}

# A satellite receiver.
oo::class create ::playhouse::Gps {
    superclass ::playhouse::Updating

    method fix {} {
        lassign [my Stamped gps.data.state] data time
        return [dict create latitude [expr {[dict get $data latitude] * 1e-7}] \
            longitude [expr {[dict get $data longitude] * 1e-7}] altitude [expr {[dict get $data altitude] * 1e-3}] \
            easting [dict get $data utm_e] northing [dict get $data utm_n] speed [dict get $data speed] \
            course [dict get $data course] quality [dict get $data quality] satellites [dict get $data num_sats] \
            horizontalError [dict get $data err_horz] verticalError [dict get $data err_vert] time $time]
    }

    method Value {} {return [my fix]}
}

# A 3D point cloud, such as that of a lidar with several rings.
oo::class create ::playhouse::PointCloud3d {
    superclass ::playhouse::Updating

    method points {} {
        return [lmap one [dict get [my Newest pointcloud3d.data.state] points] {
            set at [dict get $one point]
            set color [dict get $one color]
            dict create x [dict get $at px] y [dict get $at py] z [dict get $at pz] \
                color [lmap channel {red green blue alpha} {dict get $color $channel}]
        }]
    }

    method Value {} {return [my points]}
}

# Analog inputs and outputs; in Playhouse a custom model: its readings are inputs, its commands outputs.
oo::class create ::playhouse::Aio {
    superclass ::playhouse::Updating

    # One per input, in V.
    method voltages {} {
        return [dict get [my Newest aio.data.state] voltages]
    }

    # Sets one output, in V.
    method set {output voltage} {
        my InsistOnFinite voltage $voltage
        my command aio.cmd.state [dict create id $output voltage $voltage]
    }

    method Value {} {return [my voltages]}
}
