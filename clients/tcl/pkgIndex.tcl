package ifneeded playhouse 0.1.0 [list source [file join $dir playhouse.tcl]]
