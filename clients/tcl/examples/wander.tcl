#!/bin/sh
# Wanders about by laser and runs into nothing.
#
#     wander.tcl [HOST:PORT [INDEX [SECONDS]]]      robot and laser INDEX (0), for SECONDS (0: until Ctrl-C)
#
#
# The next lines are for the shell, which starts this with signals caught. \
exec "$(dirname "$0")/launch" "$0" "$@"

source [file join [file dirname [file normalize [info script]]] program.tcl]

set SPEED 0.4 ;# m/s
set TURN 0.8 ;# rad/s
set FRONT 0.5 ;# rad to either side that the robot needs to pass
set NEAR 0.6 ;# m

proc wander {client index more} {
    global SPEED TURN FRONT NEAR
    set robot [$client position2d $index]
    set laser [$client laser $index]
    set turning 0.0
    $laser updates scan {
        if {[timeIsUp]} break
        set ahead [playhouse::nearest $scan -$FRONT $FRONT]
        set left [playhouse::nearest $scan $FRONT 1.5]
        set right [playhouse::nearest $scan -1.5 -$FRONT]
        if {$ahead < $NEAR} {
            # Latched until the way ahead is clear.
            if {$turning == 0} {set turning [expr {$left > $right ? $TURN : -$TURN}]}
            $robot drive 0.0 $turning
        } else {
            set turning 0.0
            set sway [expr {min($left, $right) < $NEAR ? 0.5 * ($left - $right) : 0.0}]
            $robot drive [expr {min($SPEED, $ahead - $NEAR + 0.1)}] [clamp $sway -$TURN $TURN]
        }
    }
}

run wander "wander.tcl \[HOST:PORT \[INDEX \[SECONDS\]\]\]"
