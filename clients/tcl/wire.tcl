# Encoding and decoding of Player's variant of XDR and of its message header; the base of generated/. Everything is
# big-endian and a multiple of four bytes. A list is sent as its count, and again as a length before its elements; the
# rules are in docs/wire.md.

namespace eval ::playhouse::wire {
    namespace path ::playhouse

    variable HEADER_BYTES 40
    variable MAX_BODY_BYTES 33554392
    variable kinds {DATA 1 CMD 2 REQ 3 ACK 4 SYNCH 5 NACK 6}

    # Interface name -> code, and back.
    variable codes {}
    variable interfaces {}
    # Struct, as position2d.CmdVel -> its fields and their types; its value of zeros; its commands.
    variable layouts
    variable zeros
    variable readers
    variable writers
    # Message, as position2d.cmd.vel -> {interface kind subtype payload}; interface,kind,subtype -> its name.
    variable messages
    variable numbers
    array set layouts {}

    # Type -> smallest and largest value.
    variable ranges
    array set ranges {
        char {-128 127} int8 {-128 127} uint8 {0 255} int16 {-32768 32767} uint16 {0 65535}
        int32 {-2147483648 2147483647} uint32 {0 4294967295} int64 {-9223372036854775808 9223372036854775807}
    }
    variable OVER_FLOAT32 3.4028235677973366e38 ;# from here on a number rounds to more than the largest float32
}

# --- what the generated files say ---------------------------------------------------------------------------------

# An interface: its code (0: what every interface shares) and a script with its constants, structs and messages.
proc ::playhouse::wire::interface {name code script} {
    variable codes
    variable interfaces
    if {$code != 0} {
        dict set codes $name $code
        dict set interfaces $code $name
    }
    namespace eval ::playhouse::$name [list variable CODE $code]
    namespace eval ::playhouse::$name {namespace path {::playhouse::wire ::playhouse}}
    namespace eval ::playhouse::$name $script
}

# A struct: its fields with their types, a body that reads it from `body` at byte `at` of the caller, and one that
# makes the bytes of `value`.
proc ::playhouse::wire::struct {name layout read write} {
    variable layouts
    variable readers
    variable writers
    set space [uplevel 1 {namespace current}]
    set struct [namespace tail $space].$name
    set layouts($struct) [list {*}$layout]
    set readers($struct) ${space}::$name.read
    set writers($struct) ${space}::$name.write
    proc $readers($struct) {body} "upvar 1 at at\n$read"
    proc $writers($struct) {value} "set value \[record $struct \$value\]\n$write"
}

# A message: its name, kind, subtype and struct. Messages of interface 0 go to devices of every interface.
proc ::playhouse::wire::message {name kind subtype {payload ""}} {
    variable kinds
    variable messages
    variable numbers
    upvar 1 CODE code
    set number [dict get $kinds $kind]
    set messages($name) [list $code $number $subtype $payload]
    set numbers($code,$number,$subtype) $name
}

# --- values ---------------------------------------------------------------------------------------------------------

# The fields of a struct, as position2d.CmdVel, and their types: uint8, float32[], char[64], common.Pose2d ...
proc ::playhouse::wire::fields {struct} {
    variable layouts
    if {![info exists layouts($struct)]} {
        fail INVALID "there is no struct \"$struct\"[didYouMean $struct [array names layouts]]"
    }
    return $layouts($struct)
}

# A value of a struct: the given fields, and zeros for the others. A field that the struct lacks is an error.
proc ::playhouse::wire::record {struct {given {}}} {
    variable zeros
    if {![info exists zeros($struct)]} {set zeros($struct) [Zeros $struct]}
    if {[catch {dict merge $zeros($struct) $given} value]} {
        fail WIRE "$struct: \"[string range $given 0 60]\" is not a dictionary"
    }
    if {[dict size $value] != [dict size $zeros($struct)]} {
        set known [dict keys $zeros($struct)]
        foreach field [dict keys $given] {
            if {$field ni $known} {fail WIRE "$struct has no field \"$field\"[didYouMean $field $known]"}
        }
    }
    return $value
}

proc ::playhouse::wire::Zeros {struct} {
    set value {}
    foreach {field type} [fields $struct] {
        if {![regexp {^(.*)\[(\d*)\]$} $type - type length]} {
            dict set value $field [Zero $type]
        } elseif {$length eq "" || $type in {char int8 uint8}} {
            dict set value $field {}
        } else {
            dict set value $field [lrepeat $length [Zero $type]]
        }
    }
    return $value
}

proc ::playhouse::wire::Zero {type} {
    return [switch -glob -- $type {*.* {Zeros $type} float* {expr {0.0}} default {expr {0}}}]
}

# The bytes of a value of a struct.
proc ::playhouse::wire::encode {struct {value {}}} {
    variable writers
    fields $struct
    return [$writers($struct) $value]
}

# The value of a struct in these bytes; bytes after it are ignored.
proc ::playhouse::wire::decode {struct body} {
    variable readers
    fields $struct
    set at 0
    if {[catch {$readers($struct) $body} value options]} {
        if {[lrange [dict get $options -errorcode] 0 1] ne {PLAYHOUSE WIRE}} {return -options $options $value}
        fail WIRE "$struct: $value"
    }
    return $value
}

# --- messages -------------------------------------------------------------------------------------------------------

# The code of an interface.
proc ::playhouse::wire::codeOf {interface} {
    variable codes
    if {![dict exists $codes $interface]} {
        fail INVALID "there is no interface \"$interface\"[didYouMean $interface [dict keys $codes]]"
    }
    return [dict get $codes $interface]
}

# The name of an interface; its code if it has no known name.
proc ::playhouse::wire::interfaceName {code} {
    variable interfaces
    return [expr {[dict exists $interfaces $code] ? [dict get $interfaces $code] : $code}]
}

# {interface kind subtype payload} of a message, as position2d.cmd.vel; interface 0: of any.
proc ::playhouse::wire::messageOf {name} {
    variable messages
    if {![info exists messages($name)]} {
        fail INVALID "there is no message \"$name\"[didYouMean $name [array names messages]]"
    }
    return $messages($name)
}

# The name of a message, empty if there is none. Answers have that of their request.
proc ::playhouse::wire::findMessage {interface kind subtype} {
    variable numbers
    if {$kind == 4 || $kind == 6} {set kind 3}
    if {[info exists numbers(0,$kind,$subtype)]} {return $numbers(0,$kind,$subtype)}
    if {[info exists numbers($interface,$kind,$subtype)]} {return $numbers($interface,$kind,$subtype)}
    return ""
}

# The 40 bytes before every body.
proc ::playhouse::wire::encodeHeader {interface index kind subtype timestamp sequence size {robot 0}} {
    return [binary format IIIIIIQII 0 $robot $interface $index $kind $subtype $timestamp $sequence $size]
}

# {interface index kind subtype timestamp sequence size robot} of the 40 bytes at a place; narrow fields keep their low
# bits only, as in every Player receiver.
proc ::playhouse::wire::decodeHeader {data {at 0}} {
    binary scan $data @${at}x4IuIuIuIuIuQIuIu robot interface index kind subtype timestamp sequence size
    return [list [expr {$interface & 0xffff}] [expr {$index & 0xffff}] [expr {$kind & 0xff}] [expr {$subtype & 0xff}] \
        $timestamp $sequence $size $robot]
}

# The text of a text field, up to its first NUL.
proc ::playhouse::wire::text {bytes} {
    set end [string first \0 $bytes]
    if {$end >= 0} {set bytes [string range $bytes 0 [expr {$end - 1}]]}
    return [encoding convertfrom utf-8 $bytes]
}

# The bytes of a text field: UTF-8 with a NUL at its end and none in it.
proc ::playhouse::wire::cString {value} {
    if {[string first \0 $value] >= 0} {
        fail WIRE "'[string map {\0 \\x00} $value]' has a NUL in it, where receivers would end it"
    }
    regsub -all {[\ud800-\udbff][\udc00-\udfff]} $value "" rest
    if {[regexp {[\ud800-\udfff]} $rest]} {
        fail WIRE "'[Printable $value]' cannot be sent as UTF-8: surrogates not allowed"
    }
    return [encoding convertto utf-8 $value]\0
}

proc ::playhouse::wire::Printable {value} {
    set out ""
    foreach character [split $value ""] {
        append out [expr {[string is print $character] ? $character : [format \\u%04x [scan $character %c]]}]
    }
    return $out
}

# --- reading, called by the generated bodies ------------------------------------------------------------------------

# Throws: the parts of these sizes from `at` on are more than the body has.
proc ::playhouse::wire::cut {body at sizes} {
    foreach size $sizes {
        set left [expr {[string length $body] - $at}]
        if {$size > $left} {fail WIRE "byte $at: $size bytes expected, $left are left"}
        incr at $size
    }
}

# The length before the elements of a list: at most `limit`, each element at least `least` bytes. So what is read next
# allocates no more than the body justifies.
proc ::playhouse::wire::length {body name limit least} {
    upvar 1 at at
    set left [expr {[string length $body] - $at}]
    if {$left < 4} {cut $body $at 4}
    binary scan $body @${at}Iu count
    incr at 4
    incr left -4
    if {$count > $limit} {fail WIRE "byte $at: $name has a length of $count, over its limit of $limit"}
    if {$count * $least > $left} {fail WIRE "byte $at: $name claims $count elements, but $left bytes are left"}
    return $count
}

# A list of numbers, each of these letters of `binary scan` and of this size.
proc ::playhouse::wire::numbers {body letters size count} {
    upvar 1 at at
    cut $body $at [expr {$size * $count}]
    binary scan $body @${at}$letters$count values
    incr at [expr {$size * $count}]
    return $values
}

# Raw bytes and the zeros that fill their last word.
proc ::playhouse::wire::opaque {body count} {
    upvar 1 at at
    set padded [expr {($count + 3) & ~3}]
    cut $body $at $padded
    binary scan $body @${at}a$count bytes
    incr at $padded
    return $bytes
}

# The low bits of a word, which are a narrow number without or with a sign; and of the words of a list.
proc ::playhouse::wire::low {mask value} {
    return [expr {$value & $mask}]
}

proc ::playhouse::wire::signed {half value} {
    return [expr {(($value + $half) & (2 * $half - 1)) - $half}]
}

proc ::playhouse::wire::lows {mask values} {
    return [lmap value $values {expr {$value & $mask}}]
}

proc ::playhouse::wire::signeds {half values} {
    return [lmap value $values {expr {(($value + $half) & (2 * $half - 1)) - $half}}]
}

# --- writing, called by the generated bodies ------------------------------------------------------------------------

# One number of a type, as bytes.
proc ::playhouse::wire::put {type value} {
    variable ranges
    if {$type eq "float64"} {
        if {![catch {binary format Q $value} bytes]} {return $bytes}
        return [binary format W [expr {[IsNanWord $value] ? 0x7ff8000000000000 : [NoNumber $value]}]]
    }
    if {$type eq "float32"} {return [PutFloat32 $value]}
    lassign $ranges($type) low high
    if {![string is entier -strict $value]} {NoNumber $value}
    if {$value < $low || $value > $high} {fail WIRE "$value is outside \[$low, $high\]"}
    return [binary format [expr {$type eq "int64" ? "W" : "I"}] $value]
}

# A list of numbers of a type, as bytes. `binary format` turns what is over the range of a float32 into its largest
# number, so lists with that are written one by one.
proc ::playhouse::wire::put_list {type values} {
    switch -- $type {
        float64 {
            if {![catch {binary format Q* $values} bytes]} {return $bytes}
        }
        float32 {
            if {![catch {binary format R* $values} bytes] && [string first \x7f\xff\xff $bytes] < 0} {return $bytes}
        }
    }
    set out ""
    foreach value $values {append out [put $type $value]}
    return $out
}

proc ::playhouse::wire::PutFloat32 {value} {
    variable OVER_FLOAT32
    if {[catch {binary format R $value} bytes]} {
        return [binary format I [expr {[IsNanWord $value] ? 0x7fc00000 : [NoNumber $value]}]]
    }
    if {[string range $bytes 1 3] ne "\x7f\xff\xff"} {return $bytes}
    if {abs($value) == Inf} {return [binary format I [expr {$value > 0 ? 0x7f800000 : 0xff800000}]]}
    if {abs($value) >= $OVER_FLOAT32} {fail WIRE "$value is too large for a float32"}
    return $bytes
}

proc ::playhouse::wire::IsNanWord {value} {
    return [regexp -nocase {^\s*[-+]?nan} $value]
}

proc ::playhouse::wire::NoNumber {value} {
    fail WIRE "\"$value\" is not a number of its field"
}

# A count or length word before a list of at most `limit` elements.
proc ::playhouse::wire::count {name count limit} {
    if {$count > $limit} {fail WIRE "$name has $count elements, over its limit of $limit"}
    return [binary format I $count]
}

# Checks a list of fixed length, which has no length word.
proc ::playhouse::wire::exactly {name count wanted} {
    if {$count != $wanted} {fail WIRE "$name has $count elements instead of $wanted"}
}

# Raw bytes, filled with zeros to a multiple of four, or to `size` bytes first.
proc ::playhouse::wire::pad {name bytes {size ""}} {
    if {[regexp {[^\u0000-\u00ff]} $bytes]} {fail WIRE "$name has characters that are not bytes"}
    set count [string length $bytes]
    if {$size eq ""} {
        set size $count
    } elseif {$count > $size} {
        fail WIRE "$name has $count bytes, over its $size"
    }
    return [binary format a[expr {($size + 3) & ~3}] $bytes]
}
