# Interface opaque, code 51. Opaque bytes, defined by the driver and its clients.
#
# Generated from interfaces/051_opaque.toml by codegen; do not edit.

::playhouse::wire::interface opaque 51 {
    # Subtypes under their older names.
    variable REQ 1
    variable CMD 1

    # Opaque bytes. (player_opaque_data_t)
    struct Data {
        data uint8[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu data.count
        incr at 4
        set data [opaque $body [length $body data ${data.count} 1]]
        return [dict create data $data]
    } {
        append out [count data [string length [dict get $value data]] 33554392]
        append out [count data [string length [dict get $value data]] 33554392]
        append out [pad data [dict get $value data]]
        return $out
    }

    # Bytes from the driver.
    message opaque.data.state DATA 1 opaque.Data
    # Bytes for the driver.
    message opaque.cmd.data CMD 1 opaque.Data
    # Bytes for the driver, which answers with bytes.
    message opaque.req.data REQ 1 opaque.Data
}
