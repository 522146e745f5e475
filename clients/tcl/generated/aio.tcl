# Interface aio, code 21. Analog inputs and outputs.
#
# Generated from interfaces/021_aio.toml by codegen; do not edit.

::playhouse::wire::interface aio 21 {
    # Voltages of the inputs. (player_aio_data_t)
    #   voltages: in V.
    struct Data {
        voltages float32[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu voltages.count
        incr at 4
        set voltages [numbers $body R 4 [length $body voltages ${voltages.count} 4]]
        return [dict create voltages $voltages]
    } {
        append out [count voltages [llength [dict get $value voltages]] 8388598]
        append out [count voltages [llength [dict get $value voltages]] 8388598]
        append out [put_list float32 [dict get $value voltages]]
        return $out
    }

    # Commanded voltage of one output. (player_aio_cmd_t)
    #   id: Index of the output.
    #   voltage: in V.
    struct Cmd {
        id uint32
        voltage float32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuR id voltage
        incr at 8
        return [dict create id $id voltage $voltage]
    } {
        append out [put uint32 [dict get $value id]]
        append out [put float32 [dict get $value voltage]]
        return $out
    }

    # Commanded voltage of one output.
    message aio.cmd.state CMD 1 aio.Cmd
    # Voltages of the inputs.
    message aio.data.state DATA 1 aio.Data
}
