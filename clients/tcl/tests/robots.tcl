# Uses radio, camera, speech, IMU and drivers on a map of the real server through this library: robots
# radio|camera|voice|inertia|course|guest HOST:PORT, with worlds/radio.world, camera.world, radio.world, outdoor.world or
# navigate.cfg respectively. Prints what fails and exits with 1. Run by clients/python/tests/test_server.py.

source [file join [file dirname [file normalize [info script]]] program.tcl]

# Network address of the radio with the best link to this one.
proc nearestRadio {client} {
    set air [$client device wifi 0]
    $air nextData
    set links [dict get [$air latest wifi.data.state] links]
    mustBe [llength $links] "a radio hears another one"
    set link [lindex $links 0]
    mustBe [expr {[dict get $link level] < 0 && [dict get $link noise] == -100}] "levels are in dBm"
    return [playhouse::wire::text [dict get [lindex $links 0] ip]]
}

# Reads until a condition of the caller holds.
proc readUntil {client condition} {
    while {![uplevel 1 [list expr $condition]]} {$client read}
}

proc hasData {devices} {
    foreach device $devices {
        if {![$device hasData]} {return 0}
    }
    return 1
}

proc useRadios {address} {
    set client [playhouse::connect $address]
    set other [playhouse::connect $address]
    set radio [[$client robot r0] opaque]
    set receiver [[$other robot r1] opaque]
    $radio send "to all"
    $radio sendTo [nearestRadio $client] "\0to one"
    $radio sendTo "" ""
    set heard {}
    while {[llength $heard] < 3} {
        $other read
        lappend heard {*}[$receiver takeMessages]
    }
    mustBe [expr {$heard eq [list "to all" "\0to one" ""]}] "messages come whole and in order"
    mustBe [expr {[$radio takeMessages] eq {}}] "nobody hears itself"
    mustRefuse {$radio sendTo 10.0.9.9 x}
    mustRefuse {$radio sendTo "" [string repeat x 2305]}
}

proc useCameras {address} {
    set client [playhouse::connect $address]
    set robot [$client robot r0]
    lassign [$robot cameras] color depth
    set mount [$robot ptz]
    readUntil $client {[hasData [list $color $depth $mount]]}
    set colors [$color image]
    set distances [$depth image]
    mustBe [expr {[dict get $colors width] == 160 && [dict get $colors height] == 120 && ![dict get $colors isJpeg]}] \
        "the picture is 160 x 120 and raw"
    mustBe [expr {[llength [playhouse::pixel $colors 159 119]] == 3}] "a pixel in colors has three values"
    mustBe [expr {[playhouse::pixel $distances 40 59] > 50}] "the floor before the robot is more than 5 cm away"
    mustBe [catch {playhouse::pixel $distances 80 0}] "there is no pixel beside the picture"
    mustBe [expr {[dict get [$mount geometry] pose x] == 0.12}] "the camera is 12 cm before the robot's middle"
    set before [$mount view]
    set pan [expr {[dict get $before pan] + 0.25}]
    $mount look $pan [dict get $before tilt]
    readUntil $client {abs([dict get [$mount view] pan] - $pan) <= 0.001}
    $mount setVelocityControl 1
    $mount turn -0.5
    readUntil $client {[dict get [$mount view] pan] <= [dict get $before pan]}
    mustBe [expr {[dict get [$mount view] panSpeed] < 0}] "it turns to the right"
    $mount turn 0
}

proc useVoices {address} {
    set client [playhouse::connect $address]
    set other [playhouse::connect $address]
    set voice [[$client robot r0] speech]
    set own [[$other robot r1] speech]
    set ears [[$other robot r1] speech_recognition]
    $own say "my own voice"
    $voice say marco
    $ears nextData
    $voice say sch\u00f6n
    set heard {}
    while {[lindex $heard end] ne "sch\u00f6n"} {
        $other read
        lappend heard {*}[$ears takeTexts]
    }
    mustBe [expr {[llength $heard] <= 2 && "my own voice" ni $heard}] "a robot hears others and not itself"
}

proc useInertia {address} {
    set client [playhouse::connect $address]
    set robot [$client robot r0]
    set base [$robot position3d]
    set unit [$robot imu]
    set receiver [$robot gps]
    set lidar [$robot pointcloud3d]
    foreach value {inertia attitude} {mustBe [catch {$unit $value}] "there are no data before the first"}
    $unit send imu.data.euler
    readUntil $client {[hasData [list $base $receiver $lidar]] && [$unit latest imu.data.euler] ne ""}
    mustBe [expr {abs([lindex [dict get [$unit inertia] acceleration] 2] - 9.81) < 1}] "it feels gravity"
    mustBe [expr {abs([lindex [$unit attitude] 0]) < 0.2}] "it is level"
    foreach value {velocity quaternion} {mustBe [catch {$unit $value}] "of what is not sent there are no data"}
    set fix [$receiver fix]
    mustBe [expr {abs([dict get $fix latitude] - 50.7747) < 0.001 && [dict get $fix quality] > 0}] "it is in Aachen"
    mustBe [expr {[lindex [dict get [lindex [$lidar points] 0] color] 3] == 255}] "points are opaque"
    $base setOdometry [playhouse::pose3d 5 6]
    readUntil $client {abs([dict get [$base state] pose x] - 5) <= 1}
    mustBe [catch {$base drive Inf}] "a number that is not finite is an error"
    $base drive 0.2
    readUntil $client {[dict get [$base state] velocity x] >= 0.1}
    $unit send imu.data.fullstate
    readUntil $client {[$unit latest imu.data.fullstate] ne ""}
    $unit velocity
    $unit resetOrientation
    $base close
}

proc distance {one other} {
    return [expr {hypot([dict get $one x] - [dict get $other x], [dict get $one y] - [dict get $other y])}]
}

proc checkMap {map start} {
    set grid [$map grid]
    set cells [$map cells]
    mustBe [expr {abs([dict get $grid cellSize] - 0.1) < 1e-6}] "cells have sides of 0.1 m"
    mustBe [expr {[llength $cells] == [dict get $grid height]}] "the map has all rows"
    foreach row $cells {mustBe [expr {[llength $row] == [dict get $grid width]}] "a row is whole"}
    set free [playhouse::cellOf $grid [dict get $start x] [dict get $start y]]
    mustBe [expr {[lindex $cells [dict get $free row] [dict get $free column]] == -1}] "a robot stands where nothing else is"
    set rock [playhouse::cellOf $grid -7.9 -7.9]
    mustBe [expr {[lindex $cells [dict get $rock row] [dict get $rock column]] == 1}] "there is rock around the cave"
}

proc useDriversOnAMap {address} {
    set client [playhouse::connect $address]
    set simulation [$client simulation 0]
    set start [$simulation pose r0]
    set goal [playhouse::pose 6.0 4.0 1.5]
    checkMap [$client map 0] $start
    set robot [$client robot r0]
    set place [$robot localize]
    set planner [$robot planner]
    $place setPose {*}[dict values $start] [playhouse::ofDeviations 0.2 0.2 0.1]
    $planner goTo {*}[dict values $goal]
    readUntil $client {[hasData $planner] && [dict get [$planner state] pose x] >= [dict get $start x] + 0.5}
    $planner stop
    set path [$planner path]
    mustBe [expr {[distance [lindex [dict get $path waypoints] end] $goal] == 0
                  && [dict get $path length] > [distance $start $goal]}] "a path leads to the goal"
    mustBe [expr {[dict get [$planner state] valid] && ![$planner arrived]}] "it is on its way"
    mustBe [expr {[distance [$place pose] [$simulation pose r0]] < 0.3}] "it knows where it is"
    mustBe [expr {[llength [$place particles]] >= 100}] "there are particles"
    mustRefuse {$place setPose {*}[dict values $start] [playhouse::covariance -1]}
    $planner resume
    readUntil $client {[$planner arrived]}
    mustBe [expr {[distance [$simulation pose r0] $goal] < 0.6}] "it is at the goal"
    mustBe [expr {[$planner whyRefused] eq ""}] "it was not refused"
    $planner goTo 999.0 0.0 0.0
    readUntil $client {[$planner whyRefused] ne ""}
    mustBe [expr {[$planner whyRefused] eq "no path to (999, 0): the goal is off the map"}] "it says why"
}

proc useToken {address} {
    mustBe [expr {[catch {playhouse::connect $address -token no-such-token} why]
                  && [string match "*the token is refused*" $why]}] "a wrong token is refused"
    set client [playhouse::connect $address -token driver-token-1]
    set robot [$client position2d 0]
    $robot drive 0.3
    readUntil $client {[$robot hasData] && [dict get [$robot velocity] x] > 0.2}
}

runProgram "usage: robots radio|camera|voice|inertia|course|guest HOST:PORT" {
    radio useRadios
    camera useCameras
    voice useVoices
    inertia useInertia
    course useDriversOnAMap
    guest useToken
}
