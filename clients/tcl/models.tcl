# The simulator's list of models and their devices: lines of text in a property of the simulation interface.

namespace eval ::playhouse::models {
    namespace path {::playhouse ::playhouse::wire}
}

# All models of a simulation device's world. An error of kind REFUSED if the simulator does not report them.
proc ::playhouse::models::ask {simulator} {
    set found {}
    set index 0
    while 1 {
        set question [dict create name [cString ""] prop [cString models] index $index]
        set answer [$simulator request simulation.req.get_property $question]
        if {[dict size $answer] == 0} {return $found}
        lappend found {*}[parse [text [dict get $answer value]]]
        set next [dict get $answer index]
        if {$next == 0} {return $found}
        if {$next <= $index} {fail WIRE "the list of models goes on at $next after $index"}
        set index $next
    }
}

# The models of one answer, one per line: id, name, type, parent and devices, separated by TABs.
proc ::playhouse::models::parse {lines} {
    return [lmap line [split $lines \n] {
        if {$line eq ""} continue
        ParseLine $line
    }]
}

# For each model, in order: itself and all its descendants, in the order of the list.
proc ::playhouse::models::families {models} {
    set at 0
    foreach model $models {
        set found($at) [list $model]
        set parent [dict get $model parent]
        # Parents come before children; of equal names the last one so far is meant.
        set parents($at) [expr {[info exists places($parent)] ? $places($parent) : ""}]
        set places([dict get $model name]) $at
        for {set above $parents($at)} {$above ne ""} {set above $parents($above)} {lappend found($above) $model}
        incr at
    }
    set families {}
    for {set i 0} {$i < $at} {incr i} {lappend families $found($i)}
    return $families
}

proc ::playhouse::models::ParseLine {line} {
    set fields [split $line \t]
    if {[llength $fields] != 5} {
        fail WIRE "a line of the list of models has [llength $fields] fields instead of 5: '[Printable $line]'"
    }
    lassign $fields id name type parent devices
    if {![IsNumber $id]} {fail WIRE "'[Printable $id]' in the list of models is not an id"}
    lassign [lmap field [list $name $type $parent] {string map {\\\\ \\ \\t \t \\n \n} $field}] name type parent
    set addresses [lmap word [regexp -all -inline {\S+} $devices] {ParseDevice $word $name}]
    scan $id %lld id
    return [dict create name $name type $type parent $parent devices $addresses id $id]
}

proc ::playhouse::models::ParseDevice {word model} {
    lassign [split $word :] port interface index more
    if {![IsNumber $port] || ![IsNumber $index] || $more ne ""} {
        fail WIRE "'[Printable $word]' in the list of models is not PORT:INTERFACE:INDEX"
    }
    return [dict create port [scan $port %d] interface $interface index [scan $index %d] model $model \
        name $interface:[scan $index %d]]
}

proc ::playhouse::models::IsNumber {word} {
    return [regexp {^[0-9]+$} $word]
}
