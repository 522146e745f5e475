#!/bin/sh
# Sends a robot to two places on the map of worlds/navigate.cfg, one after the other.
#
#     navigate.tcl [HOST:PORT [INDEX [SECONDS]]]      planner INDEX (0), for at most SECONDS (0: until it is done)
#
#
# The next lines are for the shell, which starts this with signals caught. \
exec "$(dirname "$0")/launch" "$0" "$@"

source [file join [file dirname [file normalize [info script]]] program.tcl]

set PLACES {{6.0 4.0 1.5} {-5.8 5.0 3.0}} ;# m, m, rad

proc navigate {client index more} {
    set planner [$client planner $index]
    foreach place $::PLACES {
        $planner goTo {*}$place
        $planner updates state {
            if {[timeIsUp]} return
            if {[$planner arrived]} {
                puts [format "arrived at (%.2f, %.2f) m" [dict get $state pose x] [dict get $state pose y]]
                flush stdout
                break
            }
        }
    }
}

run navigate "navigate.tcl \[HOST:PORT \[INDEX \[SECONDS\]\]\]"
