# A Tcl client of Playhouse and of any Player 3 server, in plain Tcl 8.6. README.md tells how to use it.
#
#     package require playhouse
#     set client [playhouse::connect 127.0.0.1:6665]
#     set robot [$client position2d 0]
#     $robot drive 0.2
#     $robot updates state {puts [dict get $state pose]}

package require Tcl 8.6-
package require TclOO

namespace eval ::playhouse {
    variable version 0.2.0
}

apply {{folder} {
    if {![file exists [file join $folder generated]]} {
        error "$folder/generated is missing: python3 -m codegen, in the source tree, makes it"
    }
    foreach name {errors wire values connection session device models robot generated/proxies/index client} {
        source -encoding utf-8 [file join $folder $name.tcl]
    }
    foreach pattern {proxies/*.tcl generated/*.tcl generated/proxies/*.tcl} {
        foreach file [lsort [glob -directory $folder $pattern]] {source -encoding utf-8 $file}
    }
}} [file dirname [file normalize [info script]]]

package provide playhouse $::playhouse::version
