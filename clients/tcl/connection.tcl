# One TCP connection to a Player server: banner, framing, deadlines. It interprets headers only.
#
# Deadlines are times of `now`. What waits runs the event loop, so that windows remain responsive and timers fire; what an
# event handler does with the same client meanwhile is allowed (session.tcl). If the server disconnects, messages it
# had sent can still be received; then every call throws the reason.

# Seconds of the clock of deadlines. Tcl has no clock that never jumps.
proc ::playhouse::now {} {
    return [expr {[clock microseconds] / 1e6}]
}

oo::class create ::playhouse::Connection {
    variable channel peer port limit buffer at held fault ended condemned banner waiting arrived listener pump

    # Connects and reads the banner, within so many seconds each.
    constructor {aHost aPort seconds} {
        namespace path [list {*}[namespace path] ::playhouse ::playhouse::wire]
        set peer $aHost:$aPort
        set port $aPort
        set limit [expr {min([checkedSeconds $seconds], 1e9)}]
        set buffer ""
        set at 0
        set held 0 ;# something is not flushed
        set channel ""
        set fault ""
        set ended 0
        set condemned 0
        set waiting 0
        set listener ""
        set pump ""
        try {
            my Open $aHost $aPort
            my ReadBanner [expr {[now] + $limit}]
        } trap {PLAYHOUSE TIMEOUT} {} {
            my Drop "cannot connect: no banner in time"
        } trap {PLAYHOUSE} {why options} {
            return -options $options $why
        } on error {why} {
            my Drop "cannot connect: [my Reason $why]"
        }
    }

    destructor {
        after cancel $pump
        if {$channel ne ""} {catch {close $channel}}
    }

    method peer {} {return $peer}
    method port {} {return $port}
    method banner {} {return $banner}

    # Whether a method waits, and so runs the event loop.
    method waits {} {
        return [expr {$waiting > 0}]
    }

    # From now on errors are those of a destroyed client, of kind CLOSED.
    method condemn {} {set condemned 1}

    method alive {} {
        return [expr {$channel ne "" && $fault eq ""}]
    }

    # Sends a whole message: now or, if it is to be held, with the next one that is not, or by `flush`.
    method send {header body {hold 0}} {
        if {[string length $body] > $::playhouse::wire::MAX_BODY_BYTES} {
            fail WIRE "a message of [string length $body] bytes is over the wire's limit of $::playhouse::wire::MAX_BODY_BYTES"
        }
        if {![my alive]} {my Lost}
        set held 1
        if {[catch {puts -nonewline $channel $header$body} why]} {my Broken $why}
        if {!$hold} {
            my flush
        } elseif {$listener ne ""} {
            my Wake
        }
    }

    # Sends what is held.
    method flush {} {
        if {!$held} return
        set held 0
        if {![my alive]} {my Lost}
        if {[catch {my Drain [expr {[now] + $limit}]} why]} {my Broken $why}
    }

    # The next message, if it is `buffered`: {interface index kind subtype timestamp sequence size robot} and its
    # undecoded body.
    method receive {} {
        set header [decodeHeader $buffer $at]
        set size [lindex $header 6]
        if {$size > $::playhouse::wire::MAX_BODY_BYTES} {my Drop "a header announces $size bytes, over the limit"}
        set body [string range $buffer [expr {$at + 40}] [expr {$at + 39 + $size}]]
        my Consume [expr {40 + $size}]
        return [list $header $body]
    }

    # Takes bytes that have arrived, or waits once until some may have; an error of kind TIMEOUT after the deadline.
    # Callers look again whether what they wait for is here: event handlers may have received it.
    method await {deadline} {
        if {[my takeArrived]} return
        if {[now] >= $deadline} {fail TIMEOUT "$peer: no message in time"}
        my Wait readable $deadline
    }

    # Whether a complete message is here, or an invalid header.
    method buffered {} {
        set left [expr {[string length $buffer] - $at}]
        if {$left < 40} {return 0}
        set size [lindex [decodeHeader $buffer $at] 6]
        return [expr {$size > $::playhouse::wire::MAX_BODY_BYTES || $left >= 40 + $size}]
    }

    # Takes bytes that have arrived, without waiting; 0 if there are none. An error of kind LOST at the end.
    method takeArrived {} {
        if {$channel eq ""} {my Lost}
        if {[catch {read $channel 65536} bytes]} {my Drop "the server is gone: [my Reason $bytes]"}
        # Their length is asked for: a comparison would give them a string representation, with which all gets slow.
        if {[string length $bytes]} {
            if {[string length $buffer]} {append buffer $bytes} else {set buffer $bytes}
            return 1
        }
        if {[eof $channel]} {
            set ended [expr {$fault eq ""}]
            my Drop "the run ended: the server closed the connection"
        }
        if {$fault ne ""} {my Drop $fault} ;# after a send error no new data are expected
        return 0
    }

    # A command that the event loop calls soon, when bytes have arrived and no method waits for them, and when something is
    # held; empty: none.
    method listen {command} {
        set listener $command
        after cancel $pump
        if {$channel ne "" && !$waiting} {fileevent $channel readable $listener}
        if {$listener ne ""} {my Wake}
    }

    # Calls the listener once more, soon.
    method wakeListener {} {
        if {$listener ne ""} {my Wake}
    }

    # Shuts down sending and waits up to so many seconds until the server has read everything: closing with unread data
    # makes TCP discard data in transit, such as a last stop command.
    method close {seconds} {
        if {$channel eq ""} return
        my listen ""
        set deadline [expr {[now] + $seconds}]
        catch {
            my flush
            close $channel write
            while {[now] < $deadline} {
                read $channel 65536
                if {[eof $channel]} break
                my Wait readable $deadline
            }
        }
        catch {my Drop "the connection is closed"}
    }

    method Open {aHost aPort} {
        set channel [socket -async $aHost $aPort]
        fconfigure $channel -blocking 0 -translation binary -buffersize 65536
        set deadline [expr {[now] + $limit}]
        while {[fconfigure $channel -connecting]} {
            if {[now] >= $deadline} {error "timed out"}
            my Wait writable $deadline
        }
        set why [fconfigure $channel -error]
        if {$why ne ""} {error $why}
    }

    method ReadBanner {deadline} {
        while {[string length $buffer] < 32} {my await $deadline}
        set banner [string range $buffer 0 31]
        my Consume 32
        if {[string first "Player v." $banner] != 0} {
            my Drop "not a Player server (it says '[Printable $banner]')"
        }
        set banner [string trimright $banner \0]
    }

    method Consume {count} {
        incr at $count
        if {$at == [string length $buffer]} {
            set buffer ""
            set at 0
        } elseif {$at > 65536 && 2 * $at > [string length $buffer]} {
            set buffer [string range $buffer $at end]
            set at 0
        }
    }

    method Drain {deadline} {
        flush $channel
        while {[chan pending output $channel] > 0} {
            if {[now] >= $deadline} {error "timed out"}
            my Wait writable $deadline
            flush $channel
        }
    }

    # A partially sent message cannot be continued.
    method Broken {why} {
        if {$fault eq ""} {set fault "the server is gone: [my Reason $why]"}
        my Lost
    }

    # Runs the event loop until the channel is readable or writable, or until the deadline; sometimes shorter, so
    # callers look again. Handlers that it runs may wait in turn: the last to wait restores the listener.
    method Wait {event deadline} {
        if {$channel eq ""} {my Lost}
        set milliseconds [expr {int(ceil(1000 * min(max($deadline - [now], 0.0), 1e9)))}]
        set wake [list set [my varname arrived] 1]
        set timer [after $milliseconds $wake]
        incr waiting
        try {
            fileevent $channel $event $wake
            vwait [my varname arrived]
        } finally {
            after cancel $timer
            incr waiting -1
            my Rest $event
        }
    }

    method Rest {event} {
        if {$channel eq ""} return
        if {$event eq "writable"} {fileevent $channel writable ""}
        if {$waiting} return
        fileevent $channel readable $listener
        if {$listener ne ""} {my Wake} ;# what others read while they waited are no events any more
    }

    # Calls the listener as soon as the event loop runs.
    method Wake {} {
        after cancel $pump
        set pump [after 0 $listener]
    }

    method Reason {message} {
        return [regsub {^(couldn't open socket|error [a-z]+ "[^"]*"): } $message ""]
    }

    method Lost {} {
        if {$condemned} {fail CLOSED "$peer: the client was destroyed"}
        fail [expr {$ended ? "LOST ENDED" : "LOST"}] "$peer: $fault"
    }

    # Closes the connection and throws the first reason found.
    method Drop {why} {
        if {$fault eq ""} {set fault $why}
        if {$channel ne ""} {
            set closing $channel
            set channel ""
            catch {close $closing}
        }
        set arrived 1 ;# for handlers' callers that wait
        my Lost
    }
}
