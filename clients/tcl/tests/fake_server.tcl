# A server of a few lines for one client, in the same event loop: a script says what it answers. Tests of sessions are
# made of it by `sessionTest`.

package require Tcl 8.6-
package require tcltest
lappend auto_path [file dirname [file dirname [file normalize [info script]]]]
package require playhouse
source [file join [file dirname [file normalize [info script]]] waiting.tcl]
namespace import tcltest::test

namespace eval fake {
    namespace path {::playhouse ::playhouse::wire}
    variable listener ""
    variable channel ""
    variable port 0
    variable input ""
    variable received {} ;# of the client: header and body of each message
    variable rounds {}
    variable fault ""
}

# Listens on a free port for one client. `script` is evaluated for each message with its code, index, kind, subtype,
# number and body; without -all modes, openings and closings are acknowledged before.
proc fake::start {script {banner "Player v.3.1.1"} {all 0}} {
    variable listener [socket -server [list fake::Accept $banner] -myaddr 127.0.0.1 0]
    variable port [lindex [fconfigure $listener -sockname] 2]
    variable rounds $script
    variable serveAll $all
    variable input ""
    variable received {}
    variable fault ""
    return 127.0.0.1:$port
}

proc fake::stop {} {
    variable listener
    variable fault
    leave
    close $listener
    if {$fault ne ""} {error $fault}
}

# Closes the connection.
proc fake::leave {} {
    variable channel
    if {$channel ne ""} {close $channel}
    set channel ""
}

proc fake::send {bytes} {
    variable channel
    puts -nonewline $channel $bytes
    flush $channel
}

# Sends bytes one by one, each in an event of its own.
proc fake::trickle {bytes} {
    variable channel
    if {$bytes eq "" || $channel eq ""} return
    send [string index $bytes 0]
    after idle [list after 0 [list fake::trickle [string range $bytes 1 end]]]
}

# Answers the message that the script is evaluated for.
proc fake::answer {{kind 4} {body ""} {number ""}} {
    upvar 1 code code index index subtype subtype number own
    say $code $index $kind $subtype $body [expr {$number eq "" ? $own : $number}]
}

proc fake::data {message value {index 0} {time 1.0}} {
    lassign [messageOf $message] code kind subtype struct
    say $code $index $kind $subtype [encode $struct $value] 0 $time
}

# Ends a round, after so many lost messages.
proc fake::synch {{lost ""}} {
    if {$lost eq ""} {say 1 0 5 1 ""} else {say 1 0 5 2 [binary format I $lost]}
}

proc fake::say {code index kind subtype body {number 0} {time 1.0}} {
    send [encodeHeader $code $index $kind $subtype $time $number [string length $body]]$body
}

# The commands received, as values of a message.
proc fake::commands {message} {
    variable received
    lassign [messageOf $message] code kind subtype struct
    set found {}
    foreach entry $received {
        lassign $entry header body
        if {[lindex $header 0] == $code && [lrange $header 2 3] eq [list $kind $subtype]} {
            lappend found [expr {$struct eq "" ? "" : [decode $struct $body]}]
        }
    }
    return $found
}

# The devices that were opened (+) and closed (-), simulation aside.
proc fake::opened {} {
    return [lmap request [commands player.req.dev] {
        set address [dict get $request addr]
        if {[dict get $address interf] == 31} continue
        string cat [expr {[dict get $request access] == 2 ? "-" : "+"}] [dict get $address interf] : [dict get $address index]
    }]
}

proc fake::Accept {banner accepted - -} {
    variable channel $accepted
    fconfigure $channel -blocking 0 -translation binary
    fileevent $channel readable fake::Receive
    if {$banner ne ""} {send [binary format a32 $banner]}
}

proc fake::Receive {} {
    variable channel
    variable input
    variable fault
    if {[catch {read $channel} bytes]} {
        leave
        return
    }
    append input $bytes
    while {$channel ne "" && [string length $input] >= 40} {
        set header [decodeHeader $input]
        set end [expr {40 + [lindex $header 6]}]
        if {[string length $input] < $end} break
        set body [string range $input 40 [expr {$end - 1}]]
        set input [string range $input $end end]
        if {[catch {Serve $header $body} why]} {
            set fault $why
            leave
        }
    }
    if {$channel ne "" && [eof $channel]} leave
}

proc fake::Serve {header body} {
    variable received
    variable rounds
    variable serveAll
    lappend received [list $header $body]
    lassign $header code index kind subtype time number
    if {!$serveAll && $code == 1 && $subtype == 3} {
        answer 4 $body
    } elseif {!$serveAll && $code == 1 && $subtype == 5} {
        answer
    } else {
        eval $rounds
    }
}

# --- tests ------------------------------------------------------------------------------------------------------------

# A test with a `client` of a fake server. Options: -rounds SCRIPT of the server, -all 1 (fake::start), -mode and
# -timeout of the client; then the script and its result, of which each break of a line and the spaces after it are
# one space.
proc sessionTest {name about options body result} {
    regsub -all {\n +} $result " " result
    uplevel 1 [list test $name $about -setup [list setUp $options] -body $body -cleanup tearDown -result $result]
}

proc setUp {options} {
    set options [dict merge {-rounds {answer} -all 0 -mode pull -timeout 5.0} $options]
    set address [fake::start [dict get $options -rounds] "Player v.3.1.1" [dict get $options -all]]
    set ::client [playhouse::connect $address -mode [dict get $options -mode] -timeout [dict get $options -timeout]]
}

proc tearDown {} {
    $::client destroy
    fake::stop
}

# The error of a script: its code without the body of a refusal, and its line without the server's address.
proc errorOf {script} {
    if {![catch {uplevel 1 $script} why options]} {return "no error"}
    set code [dict get $options -errorcode]
    if {[lrange $code 0 1] eq {PLAYHOUSE REFUSED}} {set code [lrange $code 0 1]}
    set names [list 127.0.0.1:$fake::port: HERE: 127.0.0.1:$fake::port ADDRESS $fake::port: PORT:]
    return "[join $code]: [string map $names $why]"
}

# The names of the errors of several scripts if they are all alike, else each.
proc errorsOf {scripts} {
    return [join [lsort -unique [lmap script $scripts {uplevel 1 [list errorOf $script]}]] \n]
}

# A position2d.Data at x.
proc at {x} {
    return [dict create pos [dict create px $x]]
}
