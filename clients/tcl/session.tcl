# One session with a server: matches answers to requests, queues data, and tracks rounds of data.

namespace eval ::playhouse {
    variable LATE_SECONDS 0.1 ;# for messages that have arrived before a deadline and are read after it
}

# For instance "position2d:0"; with a number if the interface has no known name.
proc ::playhouse::deviceName {code index} {
    return [wire::interfaceName $code]:$index
}

# Dispatches received messages: answers to the requests that wait, data to the queue; others are skipped. A request may
# wait while an event handler makes another: each message is dispatched to its recipient, whichever of them received it.
oo::class create ::playhouse::Session {
    variable connection timeout retire queue roundOpen roundRefused roundWaits told overflow unread skipped serverPort \
        abandoned sequence requests pending answers gathering

    # `aRetire` is a command that is called with the interface code, the index and the port of a device that the server
    # has retired.
    constructor {aConnection seconds aRetire} {
        namespace path [list {*}[namespace path] ::playhouse ::playhouse::wire]
        set connection $aConnection
        set timeout [checkedSeconds $seconds]
        set retire $aRetire
        set queue {}
        set roundOpen 0
        set roundRefused 0
        set roundWaits 0 ;# the round ended during a request: its data are queued
        set told 0 ;# a device was retired
        set overflow 0
        set unread 0 ;# those of them lost here
        set skipped 0
        set serverPort 0
        set abandoned {} ;# keys of requests that timed out and have no answer yet
        set sequence 0
        set requests 0
        # Number of a request that waits -> its key, its sequence, whether it settled an abandoned one, what to call at its ACK.
        set pending {}
        set answers {} ;# number of a request -> its answer
        set gathering {} ;# reason to hold commands -> whether it holds
    }

    method connection {} {return $connection}
    method peer {} {return [$connection peer]}
    method timeout {} {return $timeout}
    method roundOpen {} {return $roundOpen}
    method roundRefused {} {return $roundRefused}
    method told {{value ""}} {if {$value eq ""} {return $told}; set told $value}
    method overflowCount {} {return $overflow}
    method unreadCount {} {return $unread}
    method skippedCount {} {return $skipped}
    method skip {} {incr skipped}

    # The time-out (s) of the caller, or the session's own if it is empty.
    method timeoutOrOwn {seconds} {
        return [expr {$seconds eq "" ? $timeout : [checkedSeconds $seconds]}]
    }

    # The server's port as reported in its answers; the connected port may be that of a forwarder.
    method serverPort {} {
        return [expr {$serverPort ? $serverPort : [$connection port]}]
    }

    # Whether, for one of several reasons, commands are sent with the next request or read, or at the next turn of a
    # listening event loop. The two are then one packet, which Nagle's algorithm does not delay; Tcl 8.6 cannot switch that
    # off.
    method gather {reason on} {dict set gathering $reason $on}

    method send {code index message payload} {
        lassign [messageOf $message] - kind subtype struct
        set body ""
        if {[catch {dict size $payload} size] || $size} {set body [encode $struct $payload]}
        # As in libplayerc: the port in messages to a device, 0 in messages to the server.
        set robot [expr {$code == 1 ? 0 : [$connection port]}]
        set number [expr {$kind == 3 ? $sequence : 0}]
        set header [encodeHeader $code $index $kind $subtype [now] $number [string length $body] $robot]
        $connection send $header $body [expr {$kind == 2 && 1 in [dict values $gathering]}]
    }

    # Sends and waits for the ACK; returns its undecoded body. An error of kind REFUSED on NACK, TIMEOUT on silence.
    # `acknowledged`, if any, is a command that is called at the ACK, before any later message is dispatched.
    method request {code index message {payload ""} {seconds ""} {acknowledged ""}} {
        set seconds [my timeoutOrOwn $seconds]
        my send $code $index $message $payload
        set whose "$message of [deviceName $code $index]"
        set key [list $code $index [lindex [messageOf $message] 2]]
        try {
            lassign [my Answer $key [expr {[now] + $seconds}] $acknowledged] header body
        } trap {PLAYHOUSE TIMEOUT} {} {
            fail TIMEOUT "[my peer]: no answer to $whose in [format %g $seconds] s"
        }
        set serverPort [lindex $header 7]
        if {[lindex $header 2] == 6} {fail [list REFUSED $body] "[my peer]: $whose was refused"}
        return $body
    }

    # Requests a round of data, unless one is open or has ended with its data queued; it ends with the SYNCH that
    # clears roundOpen, or is refused.
    method beginRound {} {
        set here [expr {$roundWaits && [llength $queue]}]
        set roundWaits 0
        if {$roundOpen || $here} return
        set roundOpen 1
        set roundRefused 0
        try {
            my send 1 0 player.req.data ""
        } trap {PLAYHOUSE LOST} {} {
            # Data before the disconnection are still to be received, then the same error.
        }
    }

    # Dispatches the next message if it is here, else takes or awaits bytes of it: callers look again. An error of kind
    # TIMEOUT after the deadline. What had arrived by then is still dispatched, as an event handler may have computed until
    # after it; but for at most LATE_SECONDS, which the variable `endName` of the caller, initially empty, is for: a
    # server that sends faster than this reads does not postpone the time-out.
    method sortNext {deadline endName} {
        upvar 1 $endName end
        set now [now]
        if {$now >= $deadline} {
            if {$end eq ""} {set end [expr {$now + $::playhouse::LATE_SECONDS}]}
            if {$now >= $end} {fail TIMEOUT "[my peer]: no message in time"}
        }
        my sortArrived $deadline
    }

    # The same without that limit.
    method sortArrived {{deadline 0}} {
        if {[$connection buffered]} {
            my Dispatch [$connection receive]
        } else {
            $connection await $deadline
        }
    }

    # {header body} of the oldest message of data, which leaves the queue; empty if there is none.
    method nextData {} {
        if {![llength $queue]} return
        set message [lindex $queue 0]
        set queue [lreplace $queue[set queue {}] 0 0]
        return $message
    }

    # Drops all queued data.
    method dropAllWaiting {} {
        set queue {}
    }

    # Drops queued data of a retired device, so that they are not delivered to a new device at its address.
    method dropWaiting {code index} {
        set kept {}
        foreach message $queue {
            if {[lrange [lindex $message 0] 0 1] eq [list $code $index]} {incr skipped} else {lappend kept $message}
        }
        set queue $kept
    }

    method Answer {key deadline acknowledged} {
        set number [incr requests]
        dict set pending $number [list $key $sequence 0 $acknowledged]
        try {
            set end ""
            while {![dict exists $answers $number]} {my sortNext $deadline end}
            return [dict get $answers $number]
        } on error {why options} {
            # From now on requests are numbered, so that a late answer to this one is not matched to another. If the
            # answer to an abandoned request of this type arrived meanwhile, the number of missing answers is unchanged.
            incr sequence
            if {![lindex [dict get $pending $number] 2]} {lappend abandoned $key}
            return -options $options $why
        } finally {
            dict unset pending $number
            dict unset answers $number
        }
    }

    method Dispatch {message} {
        lassign [lindex $message 0] code index kind subtype - number
        if {$kind == 1} {
            my Queue $message
        } elseif {$kind == 5} {
            my EndRound $subtype [lindex $message 1]
        } elseif {$kind != 4 && $kind != 6} {
            incr skipped
        } elseif {![my TakeNotice $message] && ![my TakeAnswer [list $code $index $subtype] $number $message]} {
            if {$code != 1 || $index != 0 || $subtype != 4} {
                incr skipped
            } elseif {$kind == 6} {
                set roundOpen 0
                set roundRefused 1
            }
        }
    }

    method Queue {message} {
        if {[llength $queue] >= 1024} {
            # A server's queue per client has the same length; the oldest are dropped and counted.
            set queue [lreplace $queue[set queue {}] 0 0]
            incr overflow
            incr unread
        }
        lappend queue $message
    }

    # Whether a message answers a request that waits, the oldest of its type; late answers to others are skipped.
    method TakeAnswer {key number message} {
        set matching 0
        dict for {request entry} $pending {
            lassign $entry wanted own settled acknowledged
            if {$wanted ne $key || [dict exists $answers $request]} continue
            # 0 is the number of requests before the first time-out, and of servers that do not return numbers.
            if {$number ? $number == $own : $key ni $abandoned} {
                dict set answers $request $message
                if {[lindex $message 0 2] == 4} {{*}$acknowledged}
                return 1
            }
            set matching $request
        }
        if {!$matching} {return 0}
        incr skipped
        set late [lsearch -exact $abandoned $key]
        if {$late >= 0} {
            set abandoned [lreplace $abandoned $late $late]
            dict set pending $matching [lreplace [dict get $pending $matching] 2 2 1]
        }
        return 1
    }

    # Processes the notice that a device was retired, an answer to an opening without a request; 0 for any other.
    method TakeNotice {message} {
        lassign $message header body
        lassign $header code index kind subtype
        if {$kind != 4 || $code != 1 || $index != 0 || $subtype != 3} {return 0}
        try {
            set notice [decode player.DeviceReq $body]
        } trap {PLAYHOUSE WIRE} {} {
            return 0
        }
        if {[dict get $notice access] != 101} {return 0} ;# "e"; failed requests to open have ERROR_MODE
        set told 1
        dict with notice addr {{*}$retire $interf $index $robot}
        return 1
    }

    method EndRound {subtype body} {
        set roundOpen 0
        set roundWaits [expr {[llength $queue] > 0}]
        if {$subtype != 2} return ;# SYNCH OVERFLOW
        try {
            set lost [dict get [decode common.Uint32 $body] value]
        } trap {PLAYHOUSE WIRE} {} {
            set lost 0
        }
        incr overflow [expr {max($lost, 1)}]
    }
}
