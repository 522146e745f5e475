package ifneeded playhouse 0.2.0 [list source [file join $dir playhouse.tcl]]
