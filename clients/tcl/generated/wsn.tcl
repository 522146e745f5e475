# Interface wsn, code 57. A network of wireless sensor nodes.
#
# Generated from interfaces/057_wsn.toml by codegen; do not edit.

::playhouse::wire::interface wsn 57 {
    # Readings, raw or converted as selected by DATATYPE. (player_wsn_node_data_t)
    #   light: in 1 or lx.
    #   accel_x: in 1 or m/s^2.
    #   accel_y: in 1 or m/s^2.
    #   accel_z: in 1 or m/s^2.
    #   magn_x: in 1 or G.
    #   magn_y: in 1 or G.
    #   magn_z: in 1 or G.
    #   temperature: in 1 or degC.
    #   battery: in 1 or V.
    struct NodeData {
        light float32
        mic float32
        accel_x float32
        accel_y float32
        accel_z float32
        magn_x float32
        magn_y float32
        magn_z float32
        temperature float32
        battery float32
    } {
        if {[string length $body] - $at < 40} {cut $body $at {4 4 4 4 4 4 4 4 4 4}}
        binary scan $body @${at}RRRRRRRRRR light mic accel_x accel_y accel_z magn_x magn_y magn_z \
            temperature battery
        incr at 40
        return [dict create light $light mic $mic accel_x $accel_x accel_y $accel_y accel_z $accel_z \
            magn_x $magn_x magn_y $magn_y magn_z $magn_z temperature $temperature battery $battery]
    } {
        append out [put float32 [dict get $value light]]
        append out [put float32 [dict get $value mic]]
        append out [put float32 [dict get $value accel_x]]
        append out [put float32 [dict get $value accel_y]]
        append out [put float32 [dict get $value accel_z]]
        append out [put float32 [dict get $value magn_x]]
        append out [put float32 [dict get $value magn_y]]
        append out [put float32 [dict get $value magn_z]]
        append out [put float32 [dict get $value temperature]]
        append out [put float32 [dict get $value battery]]
        return $out
    }

    # Readings of one node. (player_wsn_data_t)
    #   node_type: Type of node.
    #   node_id: Id of the node.
    #   node_parent_id: Node that relayed the readings.
    struct Data {
        node_type uint32
        node_id uint32
        node_parent_id uint32
        data_packet wsn.NodeData
    } {
        if {[string length $body] - $at < 52} {cut $body $at {4 4 4 4 4 4 4 4 4 4 4 4 4}}
        binary scan $body @${at}IuIuIuRRRRRRRRRR node_type node_id node_parent_id data_packet.light \
            data_packet.mic data_packet.accel_x data_packet.accel_y data_packet.accel_z data_packet.magn_x \
            data_packet.magn_y data_packet.magn_z data_packet.temperature data_packet.battery
        incr at 52
        return [dict create node_type $node_type node_id $node_id node_parent_id $node_parent_id \
            data_packet [dict create light ${data_packet.light} mic ${data_packet.mic} accel_x ${data_packet.accel_x} accel_y ${data_packet.accel_y} accel_z ${data_packet.accel_z} magn_x ${data_packet.magn_x} magn_y ${data_packet.magn_y} magn_z ${data_packet.magn_z} temperature ${data_packet.temperature} battery ${data_packet.battery}]]
    } {
        append out [put uint32 [dict get $value node_type]]
        append out [put uint32 [dict get $value node_id]]
        append out [put uint32 [dict get $value node_parent_id]]
        append out [NodeData.write [dict get $value data_packet]]
        return $out
    }

    # Switch of an actuator of a node. (player_wsn_cmd_t)
    #   node_id: Id of the node; -1: all.
    #   group_id: Group of the node; -1: all.
    #   device: Actuator, such as a light or a buzzer.
    #   enable: 1: on, 0: off.
    struct Cmd {
        node_id int32
        group_id int32
        device uint32
        enable uint8
    } {
        if {[string length $body] - $at < 16} {cut $body $at {4 4 4 4}}
        binary scan $body @${at}IIIuIu node_id group_id device enable
        incr at 16
        set enable [low 0xff $enable]
        return [dict create node_id $node_id group_id $group_id device $device enable $enable]
    } {
        append out [put int32 [dict get $value node_id]]
        append out [put int32 [dict get $value group_id]]
        append out [put uint32 [dict get $value device]]
        append out [put uint8 [dict get $value enable]]
        return $out
    }

    # Sleep mode of nodes. (player_wsn_power_config_t)
    #   node_id: Id of the node; -1: all.
    #   group_id: Group of the node; -1: all.
    #   value: 0: asleep, 1: awake, 2: driver-specific.
    struct PowerConfig {
        node_id int32
        group_id int32
        value uint8
    } {
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}IIIu node_id group_id value
        incr at 12
        set value [low 0xff $value]
        return [dict create node_id $node_id group_id $group_id value $value]
    } {
        append out [put int32 [dict get $value node_id]]
        append out [put int32 [dict get $value group_id]]
        append out [put uint8 [dict get $value value]]
        return $out
    }

    # Format of readings. (player_wsn_datatype_config_t)
    #   value: 0: raw, 1: converted.
    struct DatatypeConfig {
        value uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu value
        incr at 4
        set value [low 0xff $value]
        return [dict create value $value]
    } {
        append out [put uint8 [dict get $value value]]
        return $out
    }

    # Rate of reports. (player_wsn_datafreq_config_t)
    #   node_id: Id of the node; -1: all.
    #   group_id: Group of the node; -1: all.
    #   frequency: in Hz.
    struct DatafreqConfig {
        node_id int32
        group_id int32
        frequency float64
    } {
        if {[string length $body] - $at < 16} {cut $body $at {4 4 8}}
        binary scan $body @${at}IIQ node_id group_id frequency
        incr at 16
        return [dict create node_id $node_id group_id $group_id frequency $frequency]
    } {
        append out [put int32 [dict get $value node_id]]
        append out [put int32 [dict get $value group_id]]
        append out [put float64 [dict get $value frequency]]
        return $out
    }

    # Readings of one node.
    message wsn.data.state DATA 1 wsn.Data
    # Switches an actuator of a node.
    message wsn.cmd.devstate CMD 1 wsn.Cmd
    # Puts nodes to sleep or wakes them.
    message wsn.req.power REQ 1 wsn.PowerConfig
    # Selects between raw and converted readings.
    message wsn.req.datatype REQ 2 wsn.DatatypeConfig
    # Sets the reporting rate of nodes.
    message wsn.req.datafreq REQ 3 wsn.DatafreqConfig
}
