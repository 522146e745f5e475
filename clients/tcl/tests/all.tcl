# Runs all tests of this folder; ends with 1 if one fails.

package require Tcl 8.6-
package require tcltest
tcltest::configure -testdir [file dirname [file normalize [info script]]] {*}$argv
exit [tcltest::runAllTests]
