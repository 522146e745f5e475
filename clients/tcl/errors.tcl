# Errors of this package. Each has one line of text and an error code that begins with PLAYHOUSE, for `try ... trap`:
#
#     PLAYHOUSE LOST           the server is unreachable, has disconnected, or sent bytes that violate the protocol
#     PLAYHOUSE LOST ENDED     the server closed the connection: the run has ended, or the server was killed
#     PLAYHOUSE TIMEOUT        no answer, or no data, before the time-out; the connection remains usable
#     PLAYHOUSE REFUSED BODY   the server answered NACK, whose undecoded body is BODY, or has no device or model of that name
#     PLAYHOUSE NODATA         a value was read before the first data of the device; nextData waits for them
#     PLAYHOUSE CLOSED         a device was used after it or its client was closed, or was waited for while one was destroyed
#     PLAYHOUSE GONE           a device was used that the server has retired: its model was removed
#     PLAYHOUSE INVALID        an argument that means nothing, as a speed that is not a finite number; nothing was sent
#     PLAYHOUSE WIRE           bytes that do not decode as the message of their header, or a value that its field cannot hold
#     PLAYHOUSE READING        read was called by a callback or an event handler while data are being read

# Throws an error of a kind, the words of its code after PLAYHOUSE.
proc ::playhouse::fail {kind message} {
    throw [list PLAYHOUSE {*}$kind] $message
}

# A time-out in seconds: 0 or more, Inf included.
proc ::playhouse::checkedSeconds {seconds} {
    if {![string is double -strict $seconds] || [isNan $seconds] || $seconds < 0} {
        fail INVALID "invalid time-out of $seconds s: 0 or more is valid"
    }
    return $seconds
}

# 1 or 0 for a boolean of any spelling.
proc ::playhouse::truth {value} {
    if {![string is boolean -strict $value]} {fail INVALID "invalid boolean $value"}
    return [expr {bool($value)}]
}

# Whether a number is NaN, which is equal to nothing.
proc ::playhouse::isNan {number} {
    return [expr {$number != $number}]
}

# Whether a value is a finite number.
proc ::playhouse::isFinite {value} {
    return [expr {[string is double -strict $value] && ![isNan $value] && abs($value) <= 1.7976931348623157e308}]
}

# ` (did you mean "laser"?)` for the nearest of the known words, empty if none is near.
proc ::playhouse::didYouMean {word known} {
    set near ""
    set best 0.6
    foreach each $known {
        set likeness [likeness $each $word]
        if {$likeness > $best || ($likeness == $best && $each > $near)} {
            set best $likeness
            set near $each
        }
    }
    return [expr {$near eq "" ? "" : " (did you mean \"$near\"?)"}]
}

# How alike two words are, from 0 to 1: the share of their letters in common runs, the longest first.
proc ::playhouse::likeness {one other} {
    set letters [expr {[string length $one] + [string length $other]}]
    return [expr {$letters == 0 ? 1.0 : 2.0 * [lettersInCommon $one $other] / $letters}]
}

proc ::playhouse::lettersInCommon {one other} {
    for {set size [string length $one]} {$size > 0} {incr size -1} {
        for {set from 0} {$from + $size <= [string length $one]} {incr from} {
            set at [string first [string range $one $from [expr {$from + $size - 1}]] $other]
            if {$at < 0} continue
            set before [lettersInCommon [string range $one 0 [expr {$from - 1}]] [string range $other 0 [expr {$at - 1}]]]
            set after [lettersInCommon [string range $one [expr {$from + $size}] end] [string range $other [expr {$at + $size}] end]]
            return [expr {$before + $size + $after}]
        }
    }
    return 0
}
