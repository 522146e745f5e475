# Cameras and their mounts.

oo::class create ::playhouse::Camera {
    superclass ::playhouse::Updating

    # The newest image. `playhouse::pixel` and `playhouse::modelId` look into it.
    method image {} {
        lassign [my Stamped camera.data.state] data time
        return [dict create width [dict get $data width] height [dict get $data height] format [dict get $data format] \
            isJpeg [expr {[dict get $data compression] == $::playhouse::camera::COMPRESS_JPEG}] \
            data [dict get $data image] time $time]
    }

    method Value {} {return [my image]}
}

# A pan-tilt-zoom mount of a camera.
oo::class create ::playhouse::Ptz {
    superclass ::playhouse::Updating

    # The current direction and field of view.
    method view {} {
        set data [my Newest ptz.data.state]
        return [dict create pan [dict get $data pan] tilt [dict get $data tilt] zoom [dict get $data zoom] \
            panSpeed [dict get $data panspeed] tiltSpeed [dict get $data tiltspeed]]
    }

    # Turns to these angles, in position control; a zoom of 0 keeps the field of view.
    method look {pan {tilt 0.0} {zoom 0.0}} {
        my InsistOnFinite pan $pan tilt $tilt zoom $zoom
        my command ptz.cmd.state [dict create pan $pan tilt $tilt zoom $zoom]
    }

    # Turns at these speeds (rad/s); requires setVelocityControl 1.
    method turn {panSpeed {tiltSpeed 0.0}} {
        my InsistOnFinite panSpeed $panSpeed tiltSpeed $tiltSpeed
        my command ptz.cmd.state [dict create panspeed $panSpeed tiltspeed $tiltSpeed]
    }

    # Selects velocity control, or position control.
    method setVelocityControl {on} {
        set mode [expr {[truth $on] ? $::playhouse::ptz::VELOCITY_CONTROL : $::playhouse::ptz::POSITION_CONTROL}]
        my request ptz.req.control_mode [dict create mode $mode]
        return
    }

    method geometry {} {
        return [my AskGeometry ptz.req.geom pos]
    }

    method Value {} {return [my view]}
}
