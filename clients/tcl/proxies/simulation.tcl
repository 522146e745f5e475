# The simulator itself. Poses of models, by name, are relative to the parent, or to the world for a top-level model.
oo::class create ::playhouse::Simulation {
    superclass ::playhouse::Device
    variable session client

    # An error of kind REFUSED if there is no model of that name.
    method pose {model} {
        return [from::pose [dict get [my OfModel $model simulation.req.get_pose2d] pose]]
    }

    method setPose {model x y a} {
        my InsistOnFinite x $x y $y a $a
        my OfModel $model simulation.req.set_pose2d [dict create pose [to::pose $x $y $a]]
        return
    }

    method pose3d {model} {
        return [from::pose3d [dict get [my OfModel $model simulation.req.get_pose3d] pose]]
    }

    method setPose3d {model pose} {
        my InsistOnFinite {*}$pose
        my OfModel $model simulation.req.set_pose3d [dict create pose [to::pose3d $pose]]
        return
    }

    # Pauses or resumes the clock. Commands are sent at once again, until the next step.
    method pause {} {
        $session gather join 0
        my command simulation.cmd.pause
    }

    # Saves the current world to the file of `playhouse run --save-world`; without that option it has no effect.
    method save {} {
        my command simulation.cmd.save
        $client flush
    }

    # Moves everything back to its pose in the world file, while time continues. With a seed the run restarts with
    # that seed: at tick 0, with the initial models and their ids, and devices have no data until new ones arrive. That
    # requires lock-step, else it is an error of kind REFUSED.
    method reset {{seed ""}} {
        if {$seed eq ""} {
            my command simulation.cmd.reset
            $client flush
            return
        }
        my InsistOnWhole seed $seed 0 18446744073709551615
        my OfWorld reset [binary format w $seed] "" "" [list $client forgetRun]
        return
    }

    # Joins a lock-step run as a member of this name until the connection is closed: ticks wait for its steps, and
    # commands are sent with the next step, request or read. Open devices first. An error of kind REFUSED with the
    # reason.
    method join {name} {
        my OfWorld join [cString $name]
        $session gather join 1
        return
    }

    # Runs this number of ticks and waits until they are done, in lock-step until all members have requested them: at
    # most so many seconds, by default without a limit. In push mode all data of the ticks have then been delivered to
    # the devices; in pull mode they are queued for read. Without lock-step a running world refuses: pause first.
    # From the first step on commands are sent as after join: Nagle's algorithm would delay the step after a command.
    method step {{ticks 1} {seconds Inf}} {
        my InsistOnWhole ticks $ticks 1 1048576
        my OfWorld step [binary format i $ticks] "" $seconds
        $session gather join 1
        $client deliverPushed
        return
    }

    # Spawns a robot like the model `like` at a pose in the world (m, m, rad); returns its name.
    method spawn {like x y a {name ""}} {
        my InsistOnFinite x $x y $y a $a
        set value [binary format qqq $x $y $a]
        if {$name ne ""} {append value [cString $name]}
        return [text [dict get [my OfWorld spawn $value $like] value]]
    }

    # Removes a top-level model from the world, with its descendants.
    method remove {model} {
        my OfWorld remove "" $model
        return
    }

    method OfWorld {property value {model ""} {seconds ""} {acknowledged ""}} {
        set request [dict create name [cString $model] prop [cString $property] index 0 value $value]
        try {
            set answer [my request simulation.req.set_property $request $seconds $acknowledged]
            if {[dict size $answer]} {return $answer}
            return $request
        } trap {PLAYHOUSE REFUSED} {- options} {
            set body [lindex [dict get $options -errorcode] 2]
        }
        set why "the server does not do that"
        if {$body ne ""} {set why [text [dict get [decode simulation.PropertyReq $body] value]]}
        if {$why eq "the run has ended"} {fail "LOST ENDED" "[$session peer]: $why"}
        fail REFUSED "[$session peer]: $property was refused: $why"
    }

    method OfModel {model message {payload {}}} {
        try {
            return [my request $message [dict merge [dict create name [cString $model]] $payload]]
        } trap {PLAYHOUSE REFUSED} {} {
            fail REFUSED "[$session peer]: $message of model \"$model\" was refused"
        }
    }
}
