# A connection to a Player server, and requests to the server itself.

namespace eval ::playhouse {
    variable DEFAULT_HOST 127.0.0.1 ;# not localhost: a machine without /etc/hosts cannot resolve it
    variable DEFAULT_PORT 6665
    variable CLOSING_SECONDS 1.0
    variable TOKEN_BYTES 32

    variable modes {push 1 pull 2}
    variable rules {accept 0 replace 1 ignore 2}
}

# Connects to "HOST", "HOST:PORT", ":PORT" or "[::1]:PORT"; the defaults are 127.0.0.1 and 6665. Options: -mode pull
# (the default) or push; -timeout SECONDS (5) for connecting, for every request, and for every read without a time-out
# of its own; -token TOKEN of a guest, for a run with --guests; -gather 1: commands are sent with the next read,
# request, flush or close, for programs that always come to one soon. Without that, a read or request right after a
# command takes up to 40 ms longer, because Tcl 8.6 cannot switch off Nagle's algorithm. Returns a Client.
proc ::playhouse::connect {args} {
    set address $::playhouse::DEFAULT_HOST
    if {[llength $args] && ![string match -* [lindex $args 0]]} {set args [lassign $args address]}
    if {[string match {\[*} $address]} {
        regexp {^\[([^\]]*)\]?(.?)(.*)$} $address - host colon port
        if {$colon eq ""} {set port $::playhouse::DEFAULT_PORT}
    } elseif {![regexp {^(.*):(.*)$} $address - host port]} {
        set host $address
        set port $::playhouse::DEFAULT_PORT
    }
    if {![regexp {^[0-9]+$} $port] || [scan $port %lld] < 1 || [scan $port %lld] > 65535} {
        fail LOST "\"$address\" is not HOST or HOST:PORT"
    }
    if {[string match -* $host]} {fail LOST "\"$address\" is not HOST or HOST:PORT: a host begins with no \"-\""}
    if {$host eq ""} {set host $::playhouse::DEFAULT_HOST}
    return [Client new $host [scan $port %d] {*}$args]
}

# One connection. `close` closes its devices and the connection; `destroy` does too, and frees it, its devices and
# robots. While a method waits, the event loop runs.
oo::class create ::playhouse::Client {
    variable connection session mode devices made families robots reading listener sofar discarding

    constructor {host port args} {
        namespace path [list {*}[namespace path] ::playhouse ::playhouse::wire]
        set options [my Options {-mode pull -timeout 5.0 -gather 0 -token ""} $args]
        set wanted [my Word mode $::playhouse::modes [dict get $options -mode]]
        set devices {} ;# code and index -> open devices, in the order of opening
        set made {} ;# all devices and robots, closed ones too
        set robots {} ;# name and addresses -> Robot
        set families {} ;# as of the last query
        set reading 0
        set listener ""
        set sofar 0
        set discarding ""
        set seconds [checkedSeconds [dict get $options -timeout]]
        set gather [truth [dict get $options -gather]]
        set connection [Connection new $host $port $seconds]
        set session [Session new $connection $seconds [namespace code {my Retire}]]
        $session gather option $gather
        set mode push ;# initial mode of a server
        try {
            if {[dict get $options -token] ne ""} {my Authenticate [dict get $options -token]}
            if {$wanted ne "push"} {my setMode $wanted}
        } on error {why options} {
            my close
            my Free
            return -options $options $why
        }
    }

    method Authenticate {token} {
        set key [encoding convertto utf-8 $token]
        if {[string length $key] > $::playhouse::TOKEN_BYTES} {
            fail INVALID "a token has $::playhouse::TOKEN_BYTES letters at most, not [string length $key]"
        }
        try {
            $session request 1 0 player.req.auth [dict create auth_key $key]
        } trap {PLAYHOUSE REFUSED} {} {
            fail REFUSED "[$session peer]: the token is refused; a run without --guests needs none"
        }
    }

    destructor {
        if {![info exists session]} return
        catch {my close}
        foreach object $made {catch {$object destroy}}
        after cancel $discarding
        my Free
    }

    # The server's banner, for instance "Player v.3.1".
    method banner {} {return [$connection banner]}
    method connected {} {return [$connection alive]}
    method mode {} {return $mode}

    # Data messages dropped because they were not read in time, here or in the server.
    method overflowCount {} {return [$session overflowCount]}
    # Messages without a recipient, and invalid messages.
    method skippedCount {} {return [$session skippedCount]}

    # Queries the number of data messages lost on the way to this client, in any mode: the server's count plus those not
    # read here in time. An error of kind REFUSED if the server does not report it.
    method lostCount {} {
        set body [$session request 1 0 universal.req.get_intprop [dict create key [cString lost]]]
        return [expr {[dict get [decode common.IntpropReq $body] value] + [$session unreadCount]}]
    }

    # The devices of the server, in its own order. Each: interface (a name, or a number if it has no known name),
    # index, name, driver, and the full name of the model behind the device and that of its top-level model (robot),
    # both empty if the server does not report them.
    method devices {} {
        set listed [dict get [decode player.DeviceDevlist [$session request 1 0 player.req.devlist]] devices]
        set owners {}
        foreach address $listed {
            if {[dict get $address interf] == $::playhouse::simulation::CODE} {
                set owners [my FindOwners]
                break
            }
        }
        return [lmap address $listed {my Describe $address $owners}]
    }

    # push: the server sends data immediately; pull: in rounds requested by the client.
    method setMode {word} {
        my Word mode $::playhouse::modes $word
        $session request 1 0 player.req.datamode [dict create mode [dict get $::playhouse::modes $word]]
        set mode $word
        return
    }

    # Sets the server's rule for messages queued for this client, while an older one of the same type is queued: accept,
    # replace or ignore. Options -interface, -index, -kind and -subtype: -1, the default, matches any.
    method setReplaceRule {rule args} {
        set options [my Options {-interface -1 -index -1 -kind -1 -subtype -1} $args]
        my Word rule $::playhouse::rules $rule
        $session request 1 0 player.req.add_replace_rule [dict create \
            interf [dict get $options -interface] index [dict get $options -index] type [dict get $options -kind] \
            subtype [dict get $options -subtype] replace [dict get $::playhouse::rules $rule]]
        return
    }

    # Waits for data and delivers them to the devices; returns the number of messages.
    #
    # In pull mode this is one round: everything the server has queued for this client. In push mode it is what has
    # arrived, at least one message, or none if a device was retired before (see a device's `gone`). An error of kind
    # TIMEOUT without data; the next read continues to wait. If the server disconnects, data it had sent are delivered
    # first; the next read is an error of kind LOST.
    method read {{seconds ""}} {
        if {$listener ne ""} {fail READING "read was called although listen delivers the data"}
        if {$reading} {fail READING "read was called from a callback that read itself is running"}
        set deadline [expr {[now] + [$session timeoutOrOwn $seconds]}]
        set reading 1
        $session told 0
        try {
            if {$mode eq "push"} {
                $connection flush
                return [my Receive $deadline]
            }
            $session beginRound
            set delivered [my Receive $deadline]
            if {[$session roundRefused] && !$delivered} {fail REFUSED "[$session peer]: the server refuses to send data"}
            return $delivered
        } finally {
            set reading 0
        }
    }

    # For programs with an event loop, as of Tk: from now on data are delivered to the devices as they arrive. After
    # each delivery, in pull mode of a whole round, the command is called with the number of messages, and with 0 if a
    # device was retired before. If the connection ends, it is called a last time with 0, the error's line and its code.
    # Empty: ends this; `read` can be called again.
    method listen {command} {
        if {$listener eq ""} {set sofar 0}
        set listener $command
        $session gather listen [expr {$command ne ""}]
        if {$command eq ""} {catch {$connection flush}}
        $connection listen [expr {$command eq "" ? "" : [namespace code {my Pump}]}]
        return
    }

    # Sends commands that are held (-gather, or in lock-step).
    method flush {} {$connection flush}

    # Opens a device of any interface, as the proxy of that interface if there is one. Access: all, read or write.
    method device {interface {index 0} {access all}} {
        set class Device
        if {[dict exists $::playhouse::proxies $interface]} {set class [dict get $::playhouse::proxies $interface]}
        set device [$class new [self] $session $interface $index $access]
        set place [list [$device code] $index]
        if {[dict exists $devices $place]} {
            foreach each [dict get $devices $place] {
                if {[$each gone]} {
                    $session dropWaiting {*}$place
                    break
                }
            }
        }
        dict lappend devices $place $device
        lappend made $device
        try {
            $device prepare
        } trap {PLAYHOUSE REFUSED} {} {
            # It works without the results of prepare.
        } on error {why options} {
            catch {$device destroy}
            return -options $options $why
        }
        return $device
    }

    # All models in the simulated world now, with their devices, parents before children. An error of kind REFUSED if
    # the server does not report models (not every simulator does, and no real robot).
    method models {} {
        return [lmap family [my ListFamilies] {lindex $family 0}]
    }

    # The Robot, or any other model, of this name, with the devices of all its descendants. It is looked up in the
    # last list of models or robots, and if it is not there, in a new list. The same name gives the same object while
    # its devices are the same; of several models with one name it is the last. An error of kind REFUSED if there is
    # none, and as of models.
    method robot {name} {
        set named [my Named $name]
        if {$named eq ""} {
            my ListFamilies
            set named [my Named $name]
        }
        if {$named eq ""} {
            set near [didYouMean $name [lmap family $families {dict get [lindex $family 0] name}]]
            fail REFUSED "there is no robot \"$name\" at [$session peer]$near"
        }
        return [my RobotOf $named]
    }

    # The top-level models with devices on this connection, of their own or of descendants, in the order of the world
    # file, as a list of Robots. An error of kind REFUSED as of models.
    method robots {} {
        set port [$session serverPort]
        return [lmap family [my ListFamilies] {
            if {[dict get [lindex $family 0] parent] ne ""} continue
            set robot [my RobotOf $family]
            if {$port ni [lmap device [$robot devices] {dict get $device port}]} continue
            set robot
        }]
    }

    # Closes all devices in reverse order of opening, and waits until the server has read everything.
    method close {} {
        my listen ""
        foreach device [lreverse [concat {*}[dict values $devices]]] {
            try {
                $device close
            } trap PLAYHOUSE {} {
                # Closing the connection closes it as well.
            }
        }
        $connection close $::playhouse::CLOSING_SECONDS
    }

    # Closes and frees it. In a callback or event handler that a method of it runs it is closed at once, what waits is an
    # error of kind CLOSED, and the event loop frees it later.
    method destroy {} {
        if {[info exists session] && ($reading || [$connection waits])} {
            $connection condemn
            catch {my close}
            my DiscardLater 0
            return
        }
        next
    }

    method DiscardLater {milliseconds} {
        after cancel $discarding
        set discarding [after $milliseconds [namespace code {my Discard}]]
    }

    method Discard {} {
        if {$reading || [$connection waits]} {
            my DiscardLater 1000 ;# a method of it has not returned yet
        } else {
            my destroy
        }
    }

    # In push mode, delivers data that have arrived to the devices, without waiting for more. Called by step.
    method deliverPushed {} {
        if {$mode ne "push" || $reading} return
        set reading 1
        try {
            my Deliver
        } finally {
            set reading 0
        }
    }

    # Drops all data received so far: the run that they are of is over. Called at the answer to a reset with a seed.
    method forgetRun {} {
        $session dropAllWaiting
        my ForgetLater -Inf
    }

    # Removes a closed device from the open ones; called by it.
    method closed {device} {
        set place [list [$device code] [$device index]]
        if {![dict exists $devices $place]} return
        set same [lsearch -all -inline -not -exact [dict get $devices $place] $device]
        if {[llength $same]} {
            dict set devices $place $same
        } else {
            dict unset devices $place
            if {[$device gone]} {$session dropWaiting {*}$place}
        }
    }

    # Removes a destroyed device; called by it.
    method forget {device} {
        set made [lsearch -all -inline -not -exact $made $device]
    }

    # --- reading ---

    # Delivers queued messages, and new ones until the round ends, in push mode all that are here and at least one;
    # returns their number. A disconnection after data is left to the next call, so that the data are delivered first.
    method Receive {deadline} {
        set end ""
        set delivered [my Deliver]
        while {[my Unfinished $delivered] && ($delivered || ![$session told])} {
            try {
                $session sortNext $deadline end
            } trap {PLAYHOUSE LOST} {why options} {
                if {$delivered} break
                return -options $options $why
            } trap {PLAYHOUSE TIMEOUT} {} {
                if {$delivered} break
                fail TIMEOUT "[$session peer]: no data in time"
            }
            incr delivered [my Deliver]
        }
        return $delivered
    }

    method Unfinished {delivered} {
        if {$mode eq "pull"} {return [$session roundOpen]}
        return [expr {!$delivered || [$connection buffered]}]
    }

    method Deliver {} {
        set count 0
        while {[llength [set message [$session nextData]]]} {
            lassign $message header body
            lassign $header code index - subtype time
            set name [findMessage $code 1 $subtype]
            set struct [expr {$name eq "" ? "" : [lindex [messageOf $name] 3]}]
            if {$struct eq "" || ![dict exists $devices [list $code $index]]} {
                $session skip
                continue
            }
            try {
                set value [decode $struct $body]
            } trap {PLAYHOUSE WIRE} {} {
                $session skip
                continue
            }
            set takers [dict get $devices [list $code $index]]
            foreach device $takers {
                # Another client restarted or rewound the run.
                if {[$device goesBack $name $time]} {my ForgetLater $time}
            }
            # The last data of a retired device belong to it, unless a new device has its address.
            set living [lmap device $takers {if {[$device gone]} continue; set device}]
            foreach device [expr {[llength $living] ? $living : $takers}] {
                if {[info object isa object $device]} {$device take $name $value $time} ;# a callback may destroy others
            }
            incr count
        }
        return $count
    }

    # Drops the data of devices whose last are later than this time: of a run that is over when time goes back.
    method ForgetLater {time} {
        foreach device [concat {*}[dict values $devices]] {
            if {[$device timestamp] > $time} {$device forgetData}
        }
    }

    # Delivers what has arrived, for listen; called by the event loop.
    method Pump {} {
        if {$listener eq "" || $reading} return
        set reading 1
        set ended {}
        try {
            if {$mode eq "pull"} {$session beginRound}
            $connection flush
            incr sofar [my Deliver]
            while {[$connection buffered] || [$connection takeArrived]} {
                if {![$connection buffered]} continue
                $session sortArrived
                incr sofar [my Deliver]
                if {$mode eq "pull" && ![$session roundOpen]} break
            }
            if {[$session roundRefused]} {fail REFUSED "[$session peer]: the server refuses to send data"}
        } trap PLAYHOUSE {why options} {
            set ended [list $why [dict get $options -errorcode]]
        } finally {
            set reading 0
        }
        if {$listener eq ""} return ;# a callback ended it, or closed or destroyed the client
        if {[llength $ended]} {
            set command $listener
            set here [self]
            if {$sofar} {my Tell}
            if {![info object isa object $here]} return ;# the command destroyed it
            my listen ""
            uplevel #0 [list {*}$command 0 {*}$ended]
        } elseif {[$session told] || ($sofar && ($mode eq "push" || ![$session roundOpen]))} {
            my Tell
        } elseif {$mode eq "pull" && ![$session roundOpen]} {
            $connection wakeListener ;# nothing in this round was for an open device
        }
    }

    method Tell {} {
        set count $sofar
        set sofar 0
        $session told 0
        $connection wakeListener ;# for the next round, and for what the command's requests leave in the queue
        uplevel #0 [list {*}$listener $count]
    }

    method Retire {code index port} {
        if {![dict exists $devices [list $code $index]]} return
        foreach device [dict get $devices [list $code $index]] {$device retire $port}
    }

    # --- models ---

    method Describe {address owners} {
        set code [dict get $address interf]
        set index [dict get $address index]
        try {
            set body [$session request 1 0 player.req.driverinfo \
                [dict create addr [dict create interf $code index $index]]]
            set driver [text [dict get [decode player.DeviceDriverinfo $body] driver_name]]
        } trap {PLAYHOUSE REFUSED} {} - trap {PLAYHOUSE WIRE} {} {
            set driver ""
        }
        set interface [interfaceName $code]
        set place [list [dict get $address robot] $interface $index]
        lassign {} model robot
        if {[dict exists $owners $place]} {lassign [dict get $owners $place] model robot}
        return [dict create interface $interface index $index name $interface:$index driver $driver \
            model $model robot $robot]
    }

    # {port interface index} of each device -> its model and the top-level model of that; empty if the server does not
    # report models.
    method FindOwners {} {
        set owners {}
        try {
            my ListFamilies
        } trap {PLAYHOUSE REFUSED} {} {
            return {}
        }
        foreach family $families {
            set top [lindex $family 0]
            if {[dict get $top parent] ne ""} continue
            foreach model $family {
                foreach device [dict get $model devices] {
                    set place [list [dict get $device port] [dict get $device interface] [dict get $device index]]
                    dict set owners $place [list [dict get $model name] [dict get $top name]]
                }
            }
        }
        return $owners
    }

    # All current models, each with its descendants.
    method ListFamilies {} {
        try {
            set simulator [my device simulation 0]
            try {
                set families [models::families [models::ask $simulator]]
            } finally {
                $simulator close
                $simulator destroy
            }
        } trap {PLAYHOUSE REFUSED} {} {
            fail REFUSED "[$session peer]: this server does not tell the names of models; open devices by number"
        }
        return $families
    }

    # The last family of this name.
    method Named {name} {
        foreach family [lreverse $families] {
            if {[dict get [lindex $family 0] name] eq $name} {return $family}
        }
    }

    method RobotOf {family} {
        set key [list [dict get [lindex $family 0] name] [lmap model $family {dict get $model devices}]]
        if {![dict exists $robots $key]} {
            set robot [Robot new [self] $family [$session serverPort]]
            dict set robots $key $robot
            lappend made $robot
        }
        return [dict get $robots $key]
    }

    # --- arguments ---

    # Options with their defaults; another option is an error.
    method Options {defaults given} {
        foreach {option value} $given {
            if {![dict exists $defaults $option]} {
                fail INVALID "there is no option $option, but [join [dict keys $defaults] {, }]"
            }
        }
        if {[llength $given] % 2} {fail INVALID "the option [lindex $given end] has no value"}
        dict for {option value} $given {
            dict set defaults $option $value
        }
        return $defaults
    }

    method Word {what known word} {
        if {![dict exists $known $word]} {fail INVALID "there is no $what \"$word\", but [join [dict keys $known] {, }]"}
        return $word
    }

    method Free {} {
        foreach object [list $session $connection] {catch {$object destroy}}
    }
}

# The methods that open a device by its interface: of a client with index and access, of a robot its first, and all.
apply {{} {
    foreach interface [dict keys $::playhouse::proxies] {
        oo::define ::playhouse::Client method $interface {{index 0} {access all}} \
            "return \[my device $interface \$index \$access\]"
    }
    dict for {interface several} $::playhouse::plurals {
        oo::define ::playhouse::Robot method $interface {} "return \[my device $interface\]"
        oo::define ::playhouse::Robot method $several {} "return \[my All $interface\]"
    }
}}
