#!/bin/sh
# Drives once around a square of 1.5 m, by odometry: forward, left, and back to where it began.
#
#     square.tcl [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0), for at most SECONDS (0: until it is done)
#
#
# The next lines are for the shell, which starts this with signals caught. \
exec "$(dirname "$0")/launch" "$0" "$@"

source [file join [file dirname [file normalize [info script]]] program.tcl]

set SIDE 1.5 ;# m
set REACHED 0.03 ;# m
set ALIGNED 0.02 ;# rad
set SPEED 0.4 ;# m/s
set TURN 1.0 ;# rad/s

proc square {client index more} {
    global SIDE REACHED ALIGNED SPEED TURN
    set robot [$client position2d $index]
    $robot nextData
    set start [$robot pose]
    set corners [list $SIDE 0.0 $SIDE $SIDE 0.0 $SIDE 0.0 0.0]
    set number 0
    $robot updates state {
        if {[timeIsUp] || ![llength $corners]} break
        set here [seenFrom $start [dict get $state pose]]
        set ahead [expr {[lindex $corners 0] - [dict get $here x]}]
        set left [expr {[lindex $corners 1] - [dict get $here y]}]
        set distance [expr {hypot($ahead, $left)}]
        if {$distance < $REACHED} {
            puts [format "corner %d at (%.2f, %.2f) m" [incr number] [dict get $here x] [dict get $here y]]
            set corners [lrange $corners 2 end]
            $robot stop
            continue
        }
        set aside [normalized [expr {atan2($left, $ahead) - [dict get $here a]}]]
        set speed [expr {abs($aside) > 0.15 ? 0.0 : min($SPEED, max(0.05, $distance))}]
        $robot drive $speed [clamp [expr {2.0 * $aside}] -$TURN $TURN]
    }
    $robot updates state {
        set aside [normalized [expr {[dict get $start a] - [dict get $state pose a]}]]
        if {[timeIsUp] || abs($aside) < $ALIGNED} break
        $robot drive 0.0 [clamp [expr {2.0 * $aside}] -$TURN $TURN]
    }
}

# The same place in the frame of `origin`.
proc seenFrom {origin pose} {
    set dx [expr {[dict get $pose x] - [dict get $origin x]}]
    set dy [expr {[dict get $pose y] - [dict get $origin y]}]
    set c [expr {cos([dict get $origin a])}]
    set s [expr {sin([dict get $origin a])}]
    return [playhouse::pose [expr {$c * $dx + $s * $dy}] [expr {$c * $dy - $s * $dx}] \
        [normalized [expr {[dict get $pose a] - [dict get $origin a]}]]]
}

proc normalized {angle} {
    return [expr {atan2(sin($angle), cos($angle))}]
}

run square "square.tcl \[HOST:PORT \[INDEX \[SECONDS\]\]\]"
