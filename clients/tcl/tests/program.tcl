# For the test programs: the first failure prints a line and exits with 1.

lappend auto_path [file dirname [file dirname [file normalize [info script]]]]
package require playhouse

proc mustBe {fact what} {
    if {!$fact} {error "it is not true that $what"}
}

# Evaluates a script that the server must refuse.
proc mustRefuse {script} {
    try {
        uplevel 1 $script
    } trap {PLAYHOUSE REFUSED} {} {
        return
    }
    error "the server should have refused this: $script"
}

# Runs the command for the first word of the command line with the second, the address; then closes all clients.
proc runProgram {usage commands} {
    lassign $::argv word address
    if {[llength $::argv] != 2 || ![dict exists $commands $word]} {
        puts stderr $usage
        exit 1
    }
    try {
        [dict get $commands $word] $address
        foreach client [info class instances playhouse::Client] {$client close}
    } on error {why} {
        puts stderr $why
        exit 1
    }
}
