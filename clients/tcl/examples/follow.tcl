#!/bin/sh
# Follows a marker and keeps a metre away from it.
#
#     follow.tcl [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]
#
# Robot INDEX (0), for SECONDS (0: until Ctrl-C), after the marker of number MARKER (the nearest of any number), seen by
# the fiducial finder FINDER (INDEX).
#
# The next lines are for the shell, which starts this with signals caught. \
exec "$(dirname "$0")/launch" "$0" "$@"

source [file join [file dirname [file normalize [info script]]] program.tcl]

set DISTANCE 1.0 ;# m
set SPEED 0.5 ;# m/s
set TURN 1.0 ;# rad/s

proc follow {client index more} {
    global DISTANCE SPEED TURN
    lassign $more wanted finderIndex
    set robot [$client position2d $index]
    set finder [$client fiducial [expr {$finderIndex eq "" ? $index : $finderIndex}]]
    set side 1 ;# where the marker was last seen: 1 to the left, -1 to the right
    $finder updates markers {
        if {[timeIsUp]} break
        set marker [choose $markers $wanted]
        if {$marker eq ""} {
            # Marker lost: search, turning first to the side where it was last seen.
            $robot drive 0.0 [expr {$side * $TURN / 2}]
            continue
        }
        set bearing [dict get $marker bearing]
        set side [expr {$bearing > 0 ? 1 : -1}]
        set speed [clamp [expr {[dict get $marker distance] - $DISTANCE}] -$SPEED $SPEED]
        $robot drive [expr {abs($bearing) < 1.0 ? $speed : 0.0}] [clamp [expr {2.0 * $bearing}] -$TURN $TURN]
    }
}

# The nearest marker of the wanted number, of any if that is empty; empty if there is none.
proc choose {markers wanted} {
    set nearest ""
    foreach marker $markers {
        if {$wanted ne "" && [dict get $marker id] != $wanted} continue
        if {$nearest eq "" || [dict get $marker distance] < [dict get $nearest distance]} {set nearest $marker}
    }
    return $nearest
}

run follow "follow.tcl \[HOST:PORT \[INDEX \[SECONDS \[MARKER \[FINDER\]\]\]\]\]"
