# How tests wait: for what they need, never for a time. The one place of theirs that waits for a time and reads a clock
# (tools/waits.py).

# Handles events until a condition holds.
proc waitUntil {condition} {
    set end [expr {[clock seconds] + 60}]
    while {![uplevel 1 [list expr $condition]]} {
        if {[clock seconds] > $end} {error "never: $condition"}
        after 1
        update
    }
}

# Handles what is under way within this process: what was sent arrives, and what follows from that.
proc settle {} {
    for {set turn 0} {$turn < 20} {incr turn} {update}
}

# Keeps the event loop for so many milliseconds, as a handler that computes.
proc hog {milliseconds} {
    after $milliseconds
}
