# Interface dio, code 20. Digital inputs and outputs.
#
# Generated from interfaces/020_dio.toml by codegen; do not edit.

::playhouse::wire::interface dio 20 {
    # State of the inputs. (player_dio_data_t)
    #   count: Number of valid bits.
    #   bits: One bit per input, the first in the lowest bit.
    struct Data {
        count uint32
        bits uint32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuIu count bits
        incr at 8
        return [dict create count $count bits $bits]
    } {
        append out [put uint32 [dict get $value count]]
        append out [put uint32 [dict get $value bits]]
        return $out
    }

    # Commanded state of the outputs. (player_dio_cmd_t)
    #   count: Number of valid bits.
    #   digout: One bit per output, the first in the lowest bit.
    struct Cmd {
        count uint32
        digout uint32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuIu count digout
        incr at 8
        return [dict create count $count digout $digout]
    } {
        append out [put uint32 [dict get $value count]]
        append out [put uint32 [dict get $value digout]]
        return $out
    }

    # State of the inputs.
    message dio.data.values DATA 1 dio.Data
    # Commanded state of the outputs.
    message dio.cmd.values CMD 1 dio.Cmd
}
