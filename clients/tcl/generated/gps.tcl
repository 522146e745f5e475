# Interface gps, code 13. A satellite receiver.
#
# Generated from interfaces/013_gps.toml by codegen; do not edit.

::playhouse::wire::interface gps 13 {
    # A fix. (player_gps_data_t)
    #   time_sec: Time of the fix since 1970: whole seconds (in s).
    #   time_usec: Time of the fix: microseconds of the second (in us).
    #   latitude: Positive north, WGS84 (in 1e-7 deg).
    #   longitude: Positive east, WGS84 (in 1e-7 deg).
    #   altitude: Above the ellipsoid (in mm).
    #   speed: Over ground (in m/s).
    #   course: Direction of travel, clockwise from north (in rad).
    #   utm_e: UTM easting (in m).
    #   utm_n: UTM northing (in m).
    #   quality: 0: no fix, 1: plain, 2: differential.
    #   num_sats: Satellites used.
    #   hdop: Horizontal dilution of precision (in 0.1).
    #   vdop: Vertical dilution of precision (in 0.1).
    #   err_horz: Expected horizontal error (in m).
    #   err_vert: Expected vertical error (in m).
    struct Data {
        time_sec uint32
        time_usec uint32
        latitude int32
        longitude int32
        altitude int32
        speed float64
        course float64
        utm_e float64
        utm_n float64
        quality uint32
        num_sats uint32
        hdop uint32
        vdop uint32
        err_horz float64
        err_vert float64
    } {
        if {[string length $body] - $at < 84} {cut $body $at {4 4 4 4 4 8 8 8 8 4 4 4 4 8 8}}
        binary scan $body @${at}IuIuIIIQQQQIuIuIuIuQQ time_sec time_usec latitude longitude altitude speed \
            course utm_e utm_n quality num_sats hdop vdop err_horz err_vert
        incr at 84
        return [dict create time_sec $time_sec time_usec $time_usec latitude $latitude \
            longitude $longitude altitude $altitude speed $speed course $course utm_e $utm_e \
            utm_n $utm_n quality $quality num_sats $num_sats hdop $hdop vdop $vdop err_horz $err_horz \
            err_vert $err_vert]
    } {
        append out [put uint32 [dict get $value time_sec]]
        append out [put uint32 [dict get $value time_usec]]
        append out [put int32 [dict get $value latitude]]
        append out [put int32 [dict get $value longitude]]
        append out [put int32 [dict get $value altitude]]
        append out [put float64 [dict get $value speed]]
        append out [put float64 [dict get $value course]]
        append out [put float64 [dict get $value utm_e]]
        append out [put float64 [dict get $value utm_n]]
        append out [put uint32 [dict get $value quality]]
        append out [put uint32 [dict get $value num_sats]]
        append out [put uint32 [dict get $value hdop]]
        append out [put uint32 [dict get $value vdop]]
        append out [put float64 [dict get $value err_horz]]
        append out [put float64 [dict get $value err_vert]]
        return $out
    }

    # The newest fix.
    message gps.data.state DATA 1 gps.Data
}
