# Prints every message of a recorded stream as a line of JSON: its name, its value in the format of the server and
# `playhouse watch`, and the bytes that the value encodes to. dump FILE; clients/python/tests/test_conformance.py
# compares the lines with the values decoded in Python.

source [file join [file dirname [file normalize [info script]]] program.tcl]
namespace path {::playhouse ::playhouse::wire}

# A value of a type, as fields tells it.
proc json {type value} {
    if {[regexp {^(.*)\[\d*\]$} $type - element]} {
        switch -- $element {
            char {return [jsonText [text $value]]}
            int8 {binary scan $value c* value}
            uint8 {
                if {[string length $value] > 64} {return "{\"base64\":\"[binary encode base64 $value]\"}"}
                binary scan $value cu* value
            }
        }
        return "\[[join [lmap each $value {json $element $each}] ,]\]"
    }
    if {[string first . $type] < 0} {return [expr {[isFinite $value] ? $value : "null"}]}
    set parts {}
    foreach {field fieldType} [fields $type] {
        lappend parts "\"$field\":[json $fieldType [dict get $value $field]]"
    }
    return "{[join $parts ,]}"
}

proc jsonText {text} {
    set out ""
    foreach character [split $text ""] {
        scan $character %c number
        append out [expr {$number < 32 || $number > 126 || $character in {\" \\} ? [format \\u%04x $number] : $character}]
    }
    return "\"$out\""
}

proc line {header body} {
    lassign $header code - kind subtype
    set name [findMessage $code $kind $subtype]
    set struct [expr {$name eq "" ? "" : [lindex [messageOf $name] 3]}]
    set value null
    set again ""
    if {$struct ne "" && $body ne ""} {
        try {
            set decoded [decode $struct $body]
            set value [json $struct $decoded]
            set again [binary encode hex [encode $struct $decoded]]
        } trap {PLAYHOUSE WIRE} {} {}
    }
    return "{\"name\":\"$name\",\"value\":$value,\"again\":\"$again\"}"
}

if {$argc != 1} {exit 2}
set file [open [lindex $argv 0] rb]
set data [read $file]
set at [expr {[string match *.s2c [lindex $argv 0]] ? 32 : 0}]
while {$at + 40 <= [string length $data]} {
    set header [decodeHeader $data $at]
    set end [expr {$at + 40 + [lindex $header 6]}]
    if {$end > [string length $data]} break
    puts [line $header [string range $data [expr {$at + 40}] [expr {$end - 1}]]]
    set at $end
}
