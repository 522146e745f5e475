# Interface power, code 2. Battery and charger of a robot.
#
# Generated from interfaces/002_power.toml by codegen; do not edit.

::playhouse::wire::interface power 2 {
    # Bits of Data.valid: valid fields.
    variable MASK_VOLTS 1
    variable MASK_WATTS 2
    variable MASK_JOULES 4
    variable MASK_PERCENT 8
    variable MASK_CHARGING 16

    # State of charge; only the fields flagged in `valid` apply. (player_power_data_t)
    #   valid: Bits of the valid fields.
    #   volts: in V.
    #   percent: Percentage of a full charge, 0 to 100 (in %).
    #   joules: Remaining energy (in J).
    #   watts: Power drawn from the battery; negative while charging (in W).
    #   charging: 1 charging, 0 not, -1 charging is impossible.
    struct Data {
        valid uint32
        volts float32
        percent float32
        joules float32
        watts float32
        charging int32
    } {
        if {[string length $body] - $at < 24} {cut $body $at {4 4 4 4 4 4}}
        binary scan $body @${at}IuRRRRI valid volts percent joules watts charging
        incr at 24
        return [dict create valid $valid volts $volts percent $percent joules $joules watts $watts \
            charging $charging]
    } {
        append out [put uint32 [dict get $value valid]]
        append out [put float32 [dict get $value volts]]
        append out [put float32 [dict get $value percent]]
        append out [put float32 [dict get $value joules]]
        append out [put float32 [dict get $value watts]]
        append out [put int32 [dict get $value charging]]
        return $out
    }

    # Enabled flows of power. (player_power_chargepolicy_config_t)
    #   enable_input: 1: the battery may be charged.
    #   enable_output: 1: the battery may supply others.
    struct ChargepolicyConfig {
        enable_input uint8
        enable_output uint8
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuIu enable_input enable_output
        incr at 8
        set enable_input [low 0xff $enable_input]
        set enable_output [low 0xff $enable_output]
        return [dict create enable_input $enable_input enable_output $enable_output]
    } {
        append out [put uint8 [dict get $value enable_input]]
        append out [put uint8 [dict get $value enable_output]]
        return $out
    }

    # State of charge.
    message power.data.state DATA 1 power.Data
    # Enables or disables charging and discharging of the battery.
    message power.req.set_charging_policy REQ 1 power.ChargepolicyConfig
}
