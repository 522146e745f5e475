# Interface localize, code 25. Localization on a map: weighted hypotheses of the robot's pose.
#
# Generated from interfaces/025_localize.toml by codegen; do not edit.

::playhouse::wire::interface localize 25 {
    # A hypothesis. (player_localize_hypoth_t)
    #   mean: Mean of the hypothesis (in m, m, rad, frame X_MR).
    #   cov: Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad).
    #   alpha: Weight; the weights sum to 1.
    struct Hypoth {
        mean common.Pose2d
        cov float64[6]
        alpha float64
    } {
        if {[string length $body] - $at < 80} {cut $body $at {8 8 8 48 8}}
        binary scan $body @${at}QQQQ6Q mean.px mean.py mean.pa cov alpha
        incr at 80
        return [dict create mean [dict create px ${mean.px} py ${mean.py} pa ${mean.pa}] cov $cov \
            alpha $alpha]
    } {
        append out [common::Pose2d.write [dict get $value mean]]
        exactly cov [llength [dict get $value cov]] 6
        append out [put_list float64 [dict get $value cov]]
        append out [put float64 [dict get $value alpha]]
        return $out
    }

    # The hypotheses. (player_localize_data_t)
    #   pending_count: Number of queued sensor readings.
    #   pending_time: Time of the last processed reading (in s).
    struct Data {
        pending_count uint32
        pending_time float64
        hypoths localize.Hypoth[]
    } {
        if {[string length $body] - $at < 16} {cut $body $at {4 8 4}}
        binary scan $body @${at}IuQIu pending_count pending_time hypoths.count
        incr at 16
        set hypoths {}
        for {set hypoths.left [length $body hypoths ${hypoths.count} 80]} {${hypoths.left} > 0} {incr hypoths.left -1} {
            lappend hypoths [Hypoth.read $body]
        }
        return [dict create pending_count $pending_count pending_time $pending_time hypoths $hypoths]
    } {
        append out [put uint32 [dict get $value pending_count]]
        append out [put float64 [dict get $value pending_time]]
        append out [count hypoths [llength [dict get $value hypoths]] 419429]
        append out [count hypoths [llength [dict get $value hypoths]] 419429]
        foreach item [dict get $value hypoths] {append out [Hypoth.write $item]}
        return $out
    }

    # Pose of the robot. (player_localize_set_pose_t)
    #   mean: Mean of the hypothesis (in m, m, rad, frame X_MR).
    #   cov: Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad).
    struct SetPose {
        mean common.Pose2d
        cov float64[6]
    } {
        if {[string length $body] - $at < 72} {cut $body $at {8 8 8 48}}
        binary scan $body @${at}QQQQ6 mean.px mean.py mean.pa cov
        incr at 72
        return [dict create mean [dict create px ${mean.px} py ${mean.py} pa ${mean.pa}] cov $cov]
    } {
        append out [common::Pose2d.write [dict get $value mean]]
        exactly cov [llength [dict get $value cov]] 6
        append out [put_list float64 [dict get $value cov]]
        return $out
    }

    # One particle. (player_localize_particle_t)
    #   pose: The particle's estimate of the robot's pose (in m, m, rad, frame X_MR).
    #   alpha: Weight.
    struct Particle {
        pose common.Pose2d
        alpha float64
    } {
        if {[string length $body] - $at < 32} {cut $body $at {8 8 8 8}}
        binary scan $body @${at}QQQQ pose.px pose.py pose.pa alpha
        incr at 32
        return [dict create pose [dict create px ${pose.px} py ${pose.py} pa ${pose.pa}] alpha $alpha]
    } {
        append out [common::Pose2d.write [dict get $value pose]]
        append out [put float64 [dict get $value alpha]]
        return $out
    }

    # The particles of the filter. (player_localize_get_particles_t)
    #   mean: Of the most likely hypothesis (in m, m, rad, frame X_MR).
    #   variance: Of the most likely hypothesis (in m^2).
    struct GetParticles {
        mean common.Pose2d
        variance float64
        particles localize.Particle[]
    } {
        if {[string length $body] - $at < 36} {cut $body $at {8 8 8 8 4}}
        binary scan $body @${at}QQQQIu mean.px mean.py mean.pa variance particles.count
        incr at 36
        set particles {}
        for {set particles.left [length $body particles ${particles.count} 32]} {${particles.left} > 0} {incr particles.left -1} {
            lappend particles [Particle.read $body]
        }
        return [dict create mean [dict create px ${mean.px} py ${mean.py} pa ${mean.pa}] \
            variance $variance particles $particles]
    } {
        append out [common::Pose2d.write [dict get $value mean]]
        append out [put float64 [dict get $value variance]]
        append out [count particles [llength [dict get $value particles]] 1048574]
        append out [count particles [llength [dict get $value particles]] 1048574]
        foreach item [dict get $value particles] {append out [Particle.write $item]}
        return $out
    }

    # The hypotheses, the most likely first.
    message localize.data.hypoths DATA 1 localize.Data
    # Sets the robot's pose estimate.
    message localize.req.set_pose REQ 1 localize.SetPose
    # Requests the particles of the driver's filter.
    message localize.req.get_particles REQ 2 localize.GetParticles
}
