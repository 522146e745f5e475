# Interface blinkenlight, code 33. Lights that can be switched, colored and made to blink.
#
# Generated from interfaces/033_blinkenlight.toml by codegen; do not edit.

::playhouse::wire::interface blinkenlight 33 {
    # State of the light. (player_blinkenlight_data_t)
    #   enable: 1: on, 0: off.
    #   period: Blinking period; 0: steady light (in s).
    #   dutycycle: Duty cycle: fraction of the period in which the light is on, 0 to 1.
    struct Data {
        enable uint8
        period float32
        dutycycle float32
        color common.Color
    } {
        if {[string length $body] - $at < 28} {cut $body $at {4 4 4 4 4 4 4}}
        binary scan $body @${at}IuRRIuIuIuIu enable period dutycycle color.alpha color.red color.green \
            color.blue
        incr at 28
        set enable [low 0xff $enable]
        set color.alpha [low 0xff ${color.alpha}]
        set color.red [low 0xff ${color.red}]
        set color.green [low 0xff ${color.green}]
        set color.blue [low 0xff ${color.blue}]
        return [dict create enable $enable period $period dutycycle $dutycycle \
            color [dict create alpha ${color.alpha} red ${color.red} green ${color.green} blue ${color.blue}]]
    } {
        append out [put uint8 [dict get $value enable]]
        append out [put float32 [dict get $value period]]
        append out [put float32 [dict get $value dutycycle]]
        append out [common::Color.write [dict get $value color]]
        return $out
    }

    # Commanded state of one light. (player_blinkenlight_cmd_t)
    #   id: Index of the light.
    #   enable: 1: on, 0: off.
    #   period: Blinking period; 0: steady light (in s).
    #   dutycycle: Duty cycle: fraction of the period in which the light is on, 0 to 1.
    struct Cmd {
        id uint16
        enable uint8
        period float32
        dutycycle float32
        color common.Color
    } {
        if {[string length $body] - $at < 32} {cut $body $at {4 4 4 4 4 4 4 4}}
        binary scan $body @${at}IuIuRRIuIuIuIu id enable period dutycycle color.alpha color.red \
            color.green color.blue
        incr at 32
        set id [low 0xffff $id]
        set enable [low 0xff $enable]
        set color.alpha [low 0xff ${color.alpha}]
        set color.red [low 0xff ${color.red}]
        set color.green [low 0xff ${color.green}]
        set color.blue [low 0xff ${color.blue}]
        return [dict create id $id enable $enable period $period dutycycle $dutycycle \
            color [dict create alpha ${color.alpha} red ${color.red} green ${color.green} blue ${color.blue}]]
    } {
        append out [put uint16 [dict get $value id]]
        append out [put uint8 [dict get $value enable]]
        append out [put float32 [dict get $value period]]
        append out [put float32 [dict get $value dutycycle]]
        append out [common::Color.write [dict get $value color]]
        return $out
    }

    # Switch of one light. (player_blinkenlight_cmd_power_t)
    #   id: Index of the light.
    #   enable: 1: on, 0: off.
    struct CmdPower {
        id uint16
        enable uint8
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuIu id enable
        incr at 8
        set id [low 0xffff $id]
        set enable [low 0xff $enable]
        return [dict create id $id enable $enable]
    } {
        append out [put uint16 [dict get $value id]]
        append out [put uint8 [dict get $value enable]]
        return $out
    }

    # Color of one light. (player_blinkenlight_cmd_color_t)
    #   id: Index of the light.
    struct CmdColor {
        id uint16
        color common.Color
    } {
        if {[string length $body] - $at < 20} {cut $body $at {4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIuIu id color.alpha color.red color.green color.blue
        incr at 20
        set id [low 0xffff $id]
        set color.alpha [low 0xff ${color.alpha}]
        set color.red [low 0xff ${color.red}]
        set color.green [low 0xff ${color.green}]
        set color.blue [low 0xff ${color.blue}]
        return [dict create id $id \
            color [dict create alpha ${color.alpha} red ${color.red} green ${color.green} blue ${color.blue}]]
    } {
        append out [put uint16 [dict get $value id]]
        append out [common::Color.write [dict get $value color]]
        return $out
    }

    # Blinking of one light. (player_blinkenlight_cmd_flash_t)
    #   id: Index of the light.
    #   period: Blinking period (in s).
    #   dutycycle: Duty cycle: fraction of the period in which the light is on, 0 to 1.
    struct CmdFlash {
        id uint16
        period float32
        dutycycle float32
    } {
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}IuRR id period dutycycle
        incr at 12
        set id [low 0xffff $id]
        return [dict create id $id period $period dutycycle $dutycycle]
    } {
        append out [put uint16 [dict get $value id]]
        append out [put float32 [dict get $value period]]
        append out [put float32 [dict get $value dutycycle]]
        return $out
    }

    # State of the light.
    message blinkenlight.data.state DATA 1 blinkenlight.Data
    # Sets all properties of one light.
    message blinkenlight.cmd.state CMD 1 blinkenlight.Cmd
    # Switches one light.
    message blinkenlight.cmd.power CMD 2 blinkenlight.CmdPower
    # Colors one light.
    message blinkenlight.cmd.color CMD 3 blinkenlight.CmdColor
    # Makes one light blink.
    message blinkenlight.cmd.flash CMD 4 blinkenlight.CmdFlash
}
