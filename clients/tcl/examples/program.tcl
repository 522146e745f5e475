# The command line that the examples share: PROGRAM [HOST:PORT [INDEX [SECONDS ...]]].

lappend auto_path [file dirname [file dirname [file normalize [info script]]]] ;# runs in place, without an installation
package require playhouse

# Whether the program may go on, for so many seconds after `run`; 0 seconds: for ever.
proc timeIsUp {} {
    update ;# notices a signal even if data never have to be waited for
    return [expr {[playhouse::now] >= $::end}]
}

# A whole number up to 65535.
proc isWhole {word} {
    return [expr {[regexp {^[0-9]{1,9}$} $word] && [scan $word %d] <= 65535}]
}

proc isDuration {word} {
    return [expr {[playhouse::isFinite $word] && $word >= 0}]
}

# Stops the robot and ends as soon as the standard input closes: so `launch` tells of a signal, and gives the exit code.
proc watchForSignals {} {
    if {![info exists ::env(PLAYHOUSE_LAUNCHED)]} return
    fconfigure stdin -blocking 0
    fileevent stdin readable {
        read stdin
        if {[eof stdin]} {
            fileevent stdin readable {}
            foreach client [info class instances playhouse::Client] {catch {$client close}}
            exit
        }
    }
}

# Connects, calls a command with the client, the index and the numbers after SECONDS, and ends with 0 when done, 1 on an
# error, 2 on wrong arguments.
proc run {behave usage} {
    set words [lrange $::argv 0 end]
    foreach default [lrange {127.0.0.1:6665 0 0} [llength $words] end] {lappend words $default}
    set more [lassign $words address index seconds]
    foreach word [list $index {*}$more] {
        if {![isWhole $word]} {set wrong 1}
    }
    if {[info exists wrong] || ![isDuration $seconds]} {
        puts stderr "usage: $usage"
        exit 2
    }
    watchForSignals
    try {
        set client [playhouse::connect $address -gather 1] ;# each command is followed by a read
        set ::end [expr {$seconds > 0 ? [playhouse::now] + $seconds : Inf}]
        try {
            $behave $client [scan $index %d] [lmap word $more {scan $word %d}]
        } finally {
            $client destroy ;# closes it, and frees it and its devices
        }
    } trap PLAYHOUSE {why} {
        puts stderr $why
        exit 1
    }
}

proc clamp {value low high} {
    return [expr {max($low, min($high, $value))}]
}
