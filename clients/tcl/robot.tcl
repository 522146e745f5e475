# A robot by its name in the world file, with its devices and those of its descendants: given by the client's `robot`
# and `robots`.
#
# `position2d`, `laser` and so on are its first device of that interface, `position2ds`, `lasers` (of gps: `gpses`, of
# speech: `speeches`) a list of all of them, opened on first use. `close` closes the devices opened here; a moving
# robot is stopped first.
oo::class create ::playhouse::Robot {
    variable client models port opened

    # `thePort` is that of the connected server, as reported by the server.
    constructor {aClient theModels thePort} {
        namespace path [list {*}[namespace path] ::playhouse]
        set client $aClient
        set models $theModels
        set port $thePort
        set opened {} ;# address -> device, in the order of opening
    }

    method name {} {return [dict get [lindex $models 0] name]}
    method type {} {return [dict get [lindex $models 0] type]}
    # The model itself and its descendants.
    method models {} {return $models}

    # The addresses of all their devices: port, interface, index, model and name.
    method devices {} {
        set devices {}
        foreach model $models {lappend devices {*}[dict get $model devices]}
        return $devices
    }

    # The robot's device of an interface at index `nth`, from 0.
    method device {interface {nth 0}} {
        set here [my Reachable $interface]
        if {$nth < 0 || $nth >= [llength $here]} {
            set number [expr {$nth ? " number $nth" : ""}]
            fail REFUSED "robot \"[my name]\" has no $interface$number [my Elsewhere $interface]"
        }
        return [my Open [lindex $here $nth]]
    }

    # Closes devices opened here, in reverse order of opening. They reopen on use.
    method close {} {
        foreach device [lreverse [dict values $opened]] {
            if {[info object isa object $device]} {$device close}
        }
        set opened {}
    }

    method All {interface} {
        return [lmap address [my Reachable $interface] {my Open $address}]
    }

    # A connection reaches the devices of its own port only.
    method Reachable {interface} {
        return [lmap at [my devices] {
            if {[dict get $at interface] ne $interface || [dict get $at port] != $port} continue
            set at
        }]
    }

    # Text: other ports with devices of this interface, or else the existing devices.
    method Elsewhere {interface} {
        set others [lmap at [my devices] {
            if {[dict get $at interface] ne $interface || [dict get $at port] == $port} continue
            string cat "[dict get $at name] at port [dict get $at port]"
        }]
        if {[llength $others]} {return "at port $port, but [join $others {, }]: connect there"}
        set names [lmap at [my devices] {dict get $at name}]
        return "(it has [expr {[llength $names] ? [join $names {, }] : "no devices"}])"
    }

    method Open {address} {
        if {[dict exists $opened $address]} {
            set device [dict get $opened $address]
            if {[info object isa object $device] && [$device isOpen]} {return $device}
            dict unset opened $address
        }
        set device [$client device [dict get $address interface] [dict get $address index]]
        dict set opened $address $device
        return $device
    }
}
