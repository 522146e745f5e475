# An open device of any interface, base of the proxies for specific interfaces.

namespace eval ::playhouse {
    # Access to a device -> its number on the wire; letters are those of Player's first servers.
    variable access {all 1 read 114 write 119}
    # Kind of a property -> the messages that get and set it.
    variable properties {
        bool {universal.req.get_boolprop universal.req.set_boolprop}
        int {universal.req.get_intprop universal.req.set_intprop}
        double {universal.req.get_dblprop universal.req.set_dblprop}
        string {universal.req.get_strprop universal.req.set_strprop}
    }
}

# Opened by a method of Client or Robot. `close` closes it; `destroy` does too, and frees the object.
oo::class create ::playhouse::Device {
    variable client session interface code index access driver opened gone fresh timestamp newest callback uses doomed discarding

    constructor {aClient aSession anInterface anIndex {mode all}} {
        namespace path [list {*}[namespace path] ::playhouse ::playhouse::wire]
        set client $aClient
        set session $aSession
        set interface $anInterface
        set index $anIndex
        set opened 0
        set uses 0 ;# methods that wait, during which event handlers run
        set doomed 0 ;# destroyed during one
        set discarding ""
        set gone "" ;# why requests are refused
        set fresh 0
        set timestamp 0.0
        set newest {} ;# message -> its value and the server's time
        set callback ""
        set code [codeOf $interface]
        if {![string is entier -strict $index] || $index < 0 || $index > 65535} {
            fail INVALID "there is no $interface:$index: indices are 0 to 65535"
        }
        if {![dict exists $::playhouse::access $mode]} {
            fail INVALID "an access is all, read or write, and not \"$mode\""
        }
        set access $mode
        set driver [my SetAccess [dict get $::playhouse::access $mode]]
        set opened 1
    }

    destructor {
        if {![info exists opened]} return
        if {$opened} {catch {my close}}
        after cancel $discarding
        catch {$client forget [self]}
    }

    # "position2d:0"
    method name {} {return [deviceName $code $index]}
    method interface {} {return $interface}
    method code {} {return $code}
    method index {} {return $index}
    # all, read or write.
    method access {} {return $access}
    # The name of the driver behind the device.
    method driver {} {return $driver}
    # False after close, of the device or of its client.
    method isOpen {} {return $opened}

    # Whether a read has received the notice that the server retired the device. From then on its use is an error of
    # kind GONE, its last data remain, and close has no effect. Before, the server refuses requests and drops
    # commands.
    method gone {} {return [expr {$gone ne ""}]}

    # Whether any data have arrived since this device was opened, and since the run was restarted.
    method hasData {} {return [expr {[dict size $newest] > 0}]}
    # Whether data have arrived since the last nextData.
    method fresh {} {return $fresh}
    # The server's time (s) of the last data; 0 before the first.
    method timestamp {} {return $timestamp}

    # Sends a request, as position2d.req.get_geom, with a value of its struct, and waits for the answer: its value,
    # empty if it has no body. Errors of kind REFUSED or TIMEOUT. `acknowledged`, if any, is a command that is called at
    # the ACK, before any later message is dispatched.
    method request {message {payload ""} {seconds ""} {acknowledged ""}} {
        my InsistOnOpen
        set body [my Use {$session request $code $index $message $payload $seconds $acknowledged}]
        set struct [lindex [messageOf $message] 3]
        if {$struct eq "" || [string length $body] == 0} return
        return [decode $struct $body]
    }

    # Sends a command, as position2d.cmd.vel, with a value of its struct; commands have no answer.
    method command {message {payload ""}} {
        my InsistOnOpen
        $session send $code $index $message $payload
    }

    # The newest value of a data message, as position2d.data.state; empty before the first.
    method latest {message} {
        messageOf $message
        if {[dict exists $newest $message]} {return [lindex [dict get $newest $message] 0]}
    }

    # Sets a command that is called, while data are read, with the message, value and server's time of all data of this
    # device; empty: none.
    method onData {command} {
        set callback $command
    }

    # Waits for data newer than those of the last call, at most so many seconds; then an error of kind TIMEOUT.
    method nextData {{seconds ""}} {
        set seconds [$session timeoutOrOwn $seconds]
        set deadline [expr {[now] + $seconds}]
        set late "[$session peer]: no data of [my name] in [format %g $seconds] s"
        while {!$fresh} {
            my InsistOnOpen
            try {
                my Use {$client read [expr {max($deadline - [now], 0.0)}]}
            } trap {PLAYHOUSE TIMEOUT} {} {
                fail TIMEOUT $late
            }
            if {!$fresh && [now] >= $deadline} {fail TIMEOUT $late} ;# data of other devices only
        }
        set fresh 0
    }

    # A property by its key and kind: bool, int, double or string. An error of kind REFUSED if there is none.
    method getProperty {key kind} {
        set message [lindex [my PropertyMessages $kind] 0]
        set answer ""
        try {
            set answer [my request $message [dict create key [cString $key]]]
        } trap {PLAYHOUSE REFUSED} {} {}
        if {$answer eq ""} {fail REFUSED "[$session peer]: [my name] has no $kind property \"$key\""}
        set value [dict get $answer value]
        return [switch -- $kind {string {text $value} bool {expr {$value != 0}} default {set value}}]
    }

    # Why the driver of a position2d or planner does not drive to the goal that it was given last, as its log says; empty if
    # it does, has arrived, has not planned yet, or gives no reasons.
    method whyRefused {} {
        try {
            return [my getProperty refusal string]
        } trap {PLAYHOUSE REFUSED} {} {
            return ""
        }
    }

    method setProperty {key kind value} {
        set message [lindex [my PropertyMessages $kind] 1]
        set said $value
        switch -- $kind {
            string {
                set said '$value'
                set value [cString $value]
            }
            bool {set value [truth $value]}
        }
        try {
            my request $message [dict create key [cString $key] value $value]
        } trap {PLAYHOUSE REFUSED} {} {
            fail REFUSED "[$session peer]: [my name] refuses $said as \"$key\""
        }
        return
    }

    # Whether the driver reports that it supports a message. Many drivers never do.
    method hasCapability {message} {
        lassign [messageOf $message] - kind subtype
        try {
            my request universal.req.capabilities [dict create type $kind subtype $subtype]
        } trap {PLAYHOUSE REFUSED} {} {
            return 0
        }
        return 1
    }

    # Closes the device; a second call has no effect.
    method close {} {
        if {!$opened} return
        set opened 0
        $client closed [self]
        if {[[$session connection] alive] && $gone eq ""} {
            my Use {my SetAccess $::playhouse::player::CLOSE_MODE}
        }
        return
    }

    # Closes and frees it. In an event handler that a method of it runs while it waits, it is closed at once, that method
    # ends with an error of kind CLOSED, and the event loop frees it later.
    method destroy {} {
        if {[info exists uses] && $uses} {
            set doomed 1
            catch {my close}
            return
        }
        next
    }

    # Requests constant data for a proxy. Called after opening.
    method prepare {} {}

    # Evaluates a script of the caller, which waits.
    method Use {script} {
        incr uses
        try {
            set result [uplevel 1 $script]
        } on error {why options} {
            if {!$doomed} {return -options $options $why}
        } finally {
            incr uses -1
            if {$doomed && !$uses} {
                after cancel $discarding
                set discarding [after 0 [namespace code {my Discard}]]
            }
        }
        if {$doomed} {my Closed}
        return $result
    }

    method Discard {} {
        if {!$uses} {my destroy} ;# else Use does it
    }

    method Closed {} {fail CLOSED "[$session peer]: [my name] is closed"}

    # Receives data from the client's read.
    method take {message value time} {
        dict set newest $message [list $value $time]
        set timestamp $time
        set fresh 1
        if {$callback ne ""} {uplevel #0 [list {*}$callback $message $value $time]}
    }

    # Whether data of this time are earlier than the last of their kind: the simulated time went back.
    method goesBack {message time} {
        return [expr {[dict exists $newest $message] && $time < [lindex [dict get $newest $message] 1]}]
    }

    # Drops all data, as before the first: the run that they are of is over.
    method forgetData {} {
        set newest {}
        set timestamp 0.0
        set fresh 0
    }

    # Marks the device as retired by the server, whose own port number is `port`.
    method retire {port} {
        if {$gone eq ""} {set gone "$port:[my name] is gone: the server retired it"}
    }

    method InsistOnOpen {} {
        if {!$opened} {my Closed}
        if {$gone ne ""} {fail GONE $gone}
    }

    # Checks named numbers: name value ...
    method InsistOnFinite {args} {
        foreach {name value} $args {
            if {![isFinite $value]} {fail INVALID "[my name]: $name is $value, not a finite number"}
        }
    }

    method InsistOnWhole {name value least most} {
        if {![string is entier -strict $value] || $value < $least || $value > $most} {
            fail INVALID "[my name]: $name is $value, not a whole number from $least to $most"
        }
    }

    # The newest value of a data message. An error of kind NODATA before the first.
    method Newest {message} {
        return [lindex [my Stamped $message] 0]
    }

    # The same and its server time (s).
    method Stamped {message} {
        if {![dict exists $newest $message]} {fail NODATA "[$session peer]: [my name] [my LackOf $message]"}
        return [dict get $newest $message]
    }

    # The newest value of several messages.
    method NewestOf {args} {
        set found ""
        set at ""
        foreach message $args {
            if {![dict exists $newest $message]} continue
            lassign [dict get $newest $message] value time
            if {$at eq "" || $time > $at} {
                set found $value
                set at $time
            }
        }
        if {$at eq ""} {return [my Newest [lindex $args 0]]}
        return $found
    }

    # The first value of a list. An error of kind NODATA without one.
    method FirstOf {values what} {
        if {![llength $values]} {fail NODATA "[$session peer]: [my name] has no $what"}
        return [lindex $values 0]
    }

    # Why there is no value of a data message.
    method LackOf {message} {
        if {![my hasData]} {return "has sent no data yet; nextData waits for them"}
        return "sends [join [dict keys $newest] {, }], not $message"
    }

    # The answer to a request that must have contents.
    method Ask {message {payload ""}} {
        set answer [my request $message $payload]
        if {[dict size $answer] == 0} {fail WIRE "an answer came without its contents"}
        return $answer
    }

    method PropertyMessages {kind} {
        if {![dict exists $::playhouse::properties $kind]} {
            fail INVALID "a property is a bool, an int, a double or a string, not $kind"
        }
        return [dict get $::playhouse::properties $kind]
    }

    # Opens or closes the device; returns the name of its driver.
    method SetAccess {number} {
        set verb [expr {$number == $::playhouse::player::CLOSE_MODE ? "close" : "open"}]
        set peer [$session peer]
        set request [dict create addr [dict create interf $code index $index] access $number]
        try {
            set body [$session request 1 0 player.req.dev $request]
        } trap {PLAYHOUSE REFUSED} {} {
            fail REFUSED "$peer: there is no [my name] to $verb"
        } trap {PLAYHOUSE TIMEOUT} {} {
            fail TIMEOUT "$peer: no answer in time: $verb [my name]"
        }
        set granted [decode player.DeviceReq $body]
        if {[dict get $granted access] == $::playhouse::player::ERROR_MODE} {fail REFUSED "$peer: cannot $verb [my name]"}
        return [text [dict get $granted driver_name]]
    }
}

# Base of the proxies whose data are one value: `Value` makes it of the newest message.
oo::class create ::playhouse::Updating {
    superclass ::playhouse::Device
    variable session doomed

    # Reads for ever: sets a variable to each new value and evaluates a script, as foreach does; break ends it. An
    # error of kind TIMEOUT if there is no new value within so many seconds.
    method updates {variable script {seconds ""}} {
        upvar 1 $variable value
        set here [self]
        set closed "[$session peer]: [my name] is closed"
        while 1 {
            set value [my Next $seconds]
            switch -- [catch {uplevel 1 $script} result options] {
                0 - 4 {
                    # If the script has destroyed the device, its namespace and so `my` and `fail` are gone.
                    if {![info object isa object $here] || $doomed} {::playhouse::fail CLOSED $closed}
                }
                2 {return -options [dict incr options -level] $result}
                3 {return}
                default {return -options $options $result}
            }
        }
    }

    method Next {seconds} {
        my nextData $seconds
        return [my Value]
    }
}

# Base of devices whose messages are queued until the program takes them; `Meaning` makes what is queued of a value.
oo::class create ::playhouse::Keeping {
    superclass ::playhouse::Updating
    variable kept

    constructor {args} {
        set kept {}
        next {*}$args
    }

    method take {message value time} {
        lappend kept [my Meaning $value]
        if {[llength $kept] > 1024} {set kept [lrange $kept end-1023 end]} ;# the oldest are dropped
        next $message $value $time
    }

    method forgetData {} {
        set kept {}
        next
    }

    method Next {seconds} {
        while {![llength $kept]} {my nextData $seconds}
        set first [lindex $kept 0]
        set kept [lreplace $kept[set kept {}] 0 0]
        return $first
    }

    method TakeKept {} {
        set taken $kept
        set kept {}
        return $taken
    }
}

# Base of devices that move. Closing one while it moves stops it first.
oo::class create ::playhouse::Mobile {
    superclass ::playhouse::Updating
    variable session opened moving

    constructor {args} {
        set moving 0
        next {*}$args
    }

    method stop {} {my drive 0.0}

    method close {} {
        if {$opened && $moving && ![my gone] && [[$session connection] alive]} {my stop}
        next
    }
}

# Base of devices that send one of several data messages.
oo::class create ::playhouse::Selecting {
    superclass ::playhouse::Device

    # One of imu.data.state (pose), imu.data.calib (inertia), imu.data.quat (inertia and quaternion), imu.data.euler
    # (inertia and attitude) and imu.data.fullstate (pose and velocity), for all subscribers of the device.
    method send {message} {
        my request imu.req.set_datatype [dict create value [lindex [messageOf $message] 2]]
        return
    }

    method LackOf {message} {
        return [next $message][expr {[my hasData] ? "; send $message selects it" : ""}]
    }
}
