#!/bin/sh
# Tells the other robots by radio where it is, twice a second, and prints what it receives of them.
#
#     talk.tcl [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0) with radio INDEX, for SECONDS (0: until Ctrl-C)
#
# Start it once for each robot that is to send: it only reads the robot's data, and another program may drive it.
#
# The next lines are for the shell, which starts this with signals caught. \
exec "$(dirname "$0")/launch" "$0" "$@"

source [file join [file dirname [file normalize [info script]]] program.tcl]

set PERIOD 0.5 ;# s, simulated

proc talk {client index more} {
    global PERIOD
    set robot [$client position2d $index read]
    set radio [$client opaque $index]
    set nextTime 0.0
    $robot updates state {
        if {[timeIsUp]} break
        foreach message [$radio takeMessages] {
            puts [format "%.1f s: %s" [dict get $state time] [encoding convertfrom utf-8 $message]]
            flush stdout
        }
        if {[dict get $state time] >= $nextTime} {
            set pose [dict get $state pose]
            $radio send [format "robot %d is at %.2f %.2f" $index [dict get $pose x] [dict get $pose y]]
            set nextTime [expr {[dict get $state time] + $PERIOD}]
        }
    }
}

run talk "talk.tcl \[HOST:PORT \[INDEX \[SECONDS\]\]\]"
