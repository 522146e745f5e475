# Interface player, code 1. The server itself: lists, opens and closes devices, and selects the delivery
# of data. Always open as player:0.
#
# Generated from interfaces/001_player.toml by codegen; do not edit.

::playhouse::wire::interface player 1 {
    # Values of DeviceReq.access.
    variable OPEN_MODE 1
    variable CLOSE_MODE 2
    variable ERROR_MODE 3

    # Values of DeviceDatamodeReq.mode.
    variable DATAMODE_PUSH 1
    variable DATAMODE_PULL 2

    # Values of AddReplaceRuleReq.replace.
    variable MSG_REPLACE_RULE_ACCEPT 0
    variable MSG_REPLACE_RULE_REPLACE 1
    variable MSG_REPLACE_RULE_IGNORE 2

    # The devices of a server. (player_device_devlist_t)
    #   devices: In the order of creation, without player:0.
    struct DeviceDevlist {
        devices common.Devaddr[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        incr at 4
        set devices {}
        for {set devices.left [length $body devices 4096 16]} {${devices.left} > 0} {incr devices.left -1} {
            lappend devices [common::Devaddr.read $body]
        }
        return [dict create devices $devices]
    } {
        append out [count devices [llength [dict get $value devices]] 4096]
        append out [count devices [llength [dict get $value devices]] 4096]
        foreach item [dict get $value devices] {append out [common::Devaddr.write $item]}
        return $out
    }

    # A device and the driver behind it. (player_device_driverinfo_t)
    #   addr: The queried device.
    #   driver_name: NUL-terminated; empty in the request.
    struct DeviceDriverinfo {
        addr common.Devaddr
        driver_name char[]
    } {
        if {[string length $body] - $at < 20} {cut $body $at {4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIux4 addr.host addr.robot addr.interf addr.index
        incr at 20
        set addr.interf [low 0xffff ${addr.interf}]
        set addr.index [low 0xffff ${addr.index}]
        set driver_name [opaque $body [length $body driver_name 64 1]]
        return [dict create \
            addr [dict create host ${addr.host} robot ${addr.robot} interf ${addr.interf} index ${addr.index}] \
            driver_name $driver_name]
    } {
        append out [common::Devaddr.write [dict get $value addr]]
        append out [count driver_name [string length [dict get $value driver_name]] 64]
        append out [count driver_name [string length [dict get $value driver_name]] 64]
        append out [pad driver_name [dict get $value driver_name]]
        return $out
    }

    # Request to open or close a device, and its answer. (player_device_req_t)
    #   addr: The device; in the answer, completed with host and robot.
    #   access: Requested or granted access.
    #   driver_name: NUL-terminated; empty in the request.
    struct DeviceReq {
        addr common.Devaddr
        access uint8
        driver_name char[]
    } {
        if {[string length $body] - $at < 24} {cut $body $at {4 4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIuIux4 addr.host addr.robot addr.interf addr.index access
        incr at 24
        set addr.interf [low 0xffff ${addr.interf}]
        set addr.index [low 0xffff ${addr.index}]
        set access [low 0xff $access]
        set driver_name [opaque $body [length $body driver_name 64 1]]
        return [dict create \
            addr [dict create host ${addr.host} robot ${addr.robot} interf ${addr.interf} index ${addr.index}] \
            access $access driver_name $driver_name]
    } {
        append out [common::Devaddr.write [dict get $value addr]]
        append out [put uint8 [dict get $value access]]
        append out [count driver_name [string length [dict get $value driver_name]] 64]
        append out [count driver_name [string length [dict get $value driver_name]] 64]
        append out [pad driver_name [dict get $value driver_name]]
        return $out
    }

    # A delivery mode. (player_device_datamode_req_t)
    #   mode: Push or pull.
    struct DeviceDatamodeReq {
        mode uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu mode
        incr at 4
        set mode [low 0xff $mode]
        return [dict create mode $mode]
    } {
        append out [put uint8 [dict get $value mode]]
        return $out
    }

    # A key. (player_device_auth_req_t)
    struct DeviceAuthReq {
        auth_key uint8[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        incr at 4
        set auth_key [opaque $body [length $body auth_key 32 1]]
        return [dict create auth_key $auth_key]
    } {
        append out [count auth_key [string length [dict get $value auth_key]] 32]
        append out [count auth_key [string length [dict get $value auth_key]] 32]
        append out [pad auth_key [dict get $value auth_key]]
        return $out
    }

    # A robot's name and its port. (player_device_nameservice_req_t)
    #   port: 0 in the request.
    struct DeviceNameserviceReq {
        name uint8[]
        port uint16
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        incr at 4
        set name [opaque $body [length $body name 64 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu port
        incr at 4
        set port [low 0xffff $port]
        return [dict create name $name port $port]
    } {
        append out [count name [string length [dict get $value name]] 64]
        append out [count name [string length [dict get $value name]] 64]
        append out [pad name [dict get $value name]]
        append out [put uint16 [dict get $value port]]
        return $out
    }

    # Messages to which a rule applies, and its effect; -1 matches anything. (player_add_replace_rule_req_t)
    #   interf: Interface code, or -1.
    #   index: Device index, or -1.
    #   type: Message type, or -1.
    #   subtype: Message subtype, or -1.
    #   replace: Keep all, keep the newest, or drop.
    struct AddReplaceRuleReq {
        interf int32
        index int32
        type int32
        subtype int32
        replace int32
    } {
        if {[string length $body] - $at < 20} {cut $body $at {4 4 4 4 4}}
        binary scan $body @${at}IIIII interf index type subtype replace
        incr at 20
        return [dict create interf $interf index $index type $type subtype $subtype replace $replace]
    } {
        append out [put int32 [dict get $value interf]]
        append out [put int32 [dict get $value index]]
        append out [put int32 [dict get $value type]]
        append out [put int32 [dict get $value subtype]]
        append out [put int32 [dict get $value replace]]
        return $out
    }

    # Lists the devices that this connection can open.
    message player.req.devlist REQ 1 player.DeviceDevlist
    # Requests the name of the driver behind a device.
    message player.req.driverinfo REQ 2 player.DeviceDriverinfo
    # Opens or closes a device; the answer has the granted access.
    message player.req.dev REQ 3 player.DeviceReq
    # Requests one round of data, in pull mode; a synch ends the round.
    message player.req.data REQ 4
    # Selects the delivery mode: immediately (push) or on request (pull).
    message player.req.datamode REQ 5 player.DeviceDatamodeReq
    # Sends an authentication key: a guest's token, of a run with access control (docs/guests.md); NACK if it
    # admits nobody.
    message player.req.auth REQ 7 player.DeviceAuthReq
    # Requests the port of a named robot; unused, answered by NACK.
    message player.req.nameservice REQ 8 player.DeviceNameserviceReq
    # Adds a replace rule: which queued messages a newer one replaces.
    message player.req.add_replace_rule REQ 10 player.AddReplaceRuleReq
    # Ends a round of data; no message was dropped since the previous one.
    message player.synch.ok SYNCH 1
    # Ends a round of data; the body is the number of messages dropped since the previous one.
    message player.synch.overflow SYNCH 2 common.Uint32
}
