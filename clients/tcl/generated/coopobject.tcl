# Interface coopobject, code 66. Cooperating objects: fixed and moving sensor nodes and robots that report
# to each other.
#
# Generated from interfaces/066_coopobject.toml by codegen; do not edit.

::playhouse::wire::interface coopobject 66 {
    # Values of Header.origin.
    variable ORIGIN_STATICBASE 0
    variable ORIGIN_MOBILEBASE 1
    variable ORIGIN_MOTE 2
    variable ORIGIN_ROBOT 3

    # Types of messages between nodes.
    variable MSG_NONE -1
    variable MSG_HEALTH 0
    variable MSG_POSITION 1
    variable MSG_RSSI 2
    variable MSG_SENSOR 3
    variable MSG_ALARM 4
    variable MSG_REQUEST 5
    variable MSG_COMMAND 6

    # Values of Sensor.type.
    variable TEMPERATURE 0
    variable HUMIDITY 1
    variable PRESSURE 2
    variable LIGHT_1 3
    variable LIGHT_2 4
    variable ACCEL_X 5
    variable ACCEL_Y 6
    variable ACCEL_Z 7
    variable MAGNETOMETER_X 8
    variable MAGNETOMETER_Y 9
    variable MAGNETOMETER_Z 10
    variable COMPASS 11
    variable CO 12
    variable CO2 13
    variable H2 14
    variable SMOKE 15
    variable OPTSWITCH 16

    # Id of the node. (player_coopobject_header_t)
    #   origin: Type of node.
    #   parent_id: Node that relayed the message.
    struct Header {
        origin uint8
        id uint16
        parent_id uint16
    } {
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}IuIuIu origin id parent_id
        incr at 12
        set origin [low 0xff $origin]
        set id [low 0xffff $id]
        set parent_id [low 0xffff $parent_id]
        return [dict create origin $origin id $id parent_id $parent_id]
    } {
        append out [put uint8 [dict get $value origin]]
        append out [put uint16 [dict get $value id]]
        append out [put uint16 [dict get $value parent_id]]
        return $out
    }

    # Radio signal strength. (player_coopobject_rssi_t)
    #   sender_id: Node that sent the signal.
    #   rssi: As the radio reports it.
    #   stamp: Counter of measurements.
    #   nodeTimeHigh: Clock of the node: upper half.
    #   nodeTimeLow: Clock of the node: lower half.
    #   x: Position of the receiver (in m, frame p_WS).
    #   y: in m, frame p_WS.
    #   z: in m, frame p_WS.
    struct Rssi {
        header coopobject.Header
        sender_id uint16
        rssi uint16
        stamp uint16
        nodeTimeHigh uint32
        nodeTimeLow uint32
        x float32
        y float32
        z float32
    } {
        if {[string length $body] - $at < 44} {cut $body $at {4 4 4 4 4 4 4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIuIuIuIuIuRRR header.origin header.id header.parent_id sender_id \
            rssi stamp nodeTimeHigh nodeTimeLow x y z
        incr at 44
        set header.origin [low 0xff ${header.origin}]
        set header.id [low 0xffff ${header.id}]
        set header.parent_id [low 0xffff ${header.parent_id}]
        set sender_id [low 0xffff $sender_id]
        set rssi [low 0xffff $rssi]
        set stamp [low 0xffff $stamp]
        return [dict create \
            header [dict create origin ${header.origin} id ${header.id} parent_id ${header.parent_id}] \
            sender_id $sender_id rssi $rssi stamp $stamp nodeTimeHigh $nodeTimeHigh \
            nodeTimeLow $nodeTimeLow x $x y $y z $z]
    } {
        append out [Header.write [dict get $value header]]
        append out [put uint16 [dict get $value sender_id]]
        append out [put uint16 [dict get $value rssi]]
        append out [put uint16 [dict get $value stamp]]
        append out [put uint32 [dict get $value nodeTimeHigh]]
        append out [put uint32 [dict get $value nodeTimeLow]]
        append out [put float32 [dict get $value x]]
        append out [put float32 [dict get $value y]]
        append out [put float32 [dict get $value z]]
        return $out
    }

    # Position of a node. (player_coopobject_position_t)
    #   x: in m, frame p_WS.
    #   y: in m, frame p_WS.
    #   z: in m, frame p_WS.
    #   status: Driver-specific.
    struct Position {
        header coopobject.Header
        x float32
        y float32
        z float32
        status uint8
    } {
        if {[string length $body] - $at < 28} {cut $body $at {4 4 4 4 4 4 4}}
        binary scan $body @${at}IuIuIuRRRIu header.origin header.id header.parent_id x y z status
        incr at 28
        set header.origin [low 0xff ${header.origin}]
        set header.id [low 0xffff ${header.id}]
        set header.parent_id [low 0xffff ${header.parent_id}]
        set status [low 0xff $status]
        return [dict create \
            header [dict create origin ${header.origin} id ${header.id} parent_id ${header.parent_id}] \
            x $x y $y z $z status $status]
    } {
        append out [Header.write [dict get $value header]]
        append out [put float32 [dict get $value x]]
        append out [put float32 [dict get $value y]]
        append out [put float32 [dict get $value z]]
        append out [put uint8 [dict get $value status]]
        return $out
    }

    # One reading. (player_coopobject_sensor_t)
    #   type: Measured quantity.
    #   value: As the sensor reports it.
    struct Sensor {
        type uint8
        value int16
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuI type value
        incr at 8
        set type [low 0xff $type]
        set value [signed 0x8000 $value]
        return [dict create type $type value $value]
    } {
        append out [put uint8 [dict get $value type]]
        append out [put int16 [dict get $value value]]
        return $out
    }

    # Readings of a node. (player_coopobject_data_sensor_t)
    struct DataSensor {
        header coopobject.Header
        data coopobject.Sensor[]
    } {
        if {[string length $body] - $at < 16} {cut $body $at {4 4 4 4}}
        binary scan $body @${at}IuIuIuIu header.origin header.id header.parent_id data.count
        incr at 16
        set header.origin [low 0xff ${header.origin}]
        set header.id [low 0xffff ${header.id}]
        set header.parent_id [low 0xffff ${header.parent_id}]
        set data {}
        for {set data.left [length $body data ${data.count} 8]} {${data.left} > 0} {incr data.left -1} {
            lappend data [Sensor.read $body]
        }
        return [dict create \
            header [dict create origin ${header.origin} id ${header.id} parent_id ${header.parent_id}] \
            data $data]
    } {
        append out [Header.write [dict get $value header]]
        append out [count data [llength [dict get $value data]] 4194299]
        append out [count data [llength [dict get $value data]] 4194299]
        foreach item [dict get $value data] {append out [Sensor.write $item]}
        return $out
    }

    # Bytes from or to a node. (player_coopobject_data_userdefined_t)
    #   type: User-specific.
    struct DataUserdefined {
        header coopobject.Header
        type uint8
        data uint8[]
    } {
        if {[string length $body] - $at < 20} {cut $body $at {4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIuIu header.origin header.id header.parent_id type data.count
        incr at 20
        set header.origin [low 0xff ${header.origin}]
        set header.id [low 0xffff ${header.id}]
        set header.parent_id [low 0xffff ${header.parent_id}]
        set type [low 0xff $type]
        set data [opaque $body [length $body data ${data.count} 1]]
        return [dict create \
            header [dict create origin ${header.origin} id ${header.id} parent_id ${header.parent_id}] \
            type $type data $data]
    } {
        append out [Header.write [dict get $value header]]
        append out [put uint8 [dict get $value type]]
        append out [count data [string length [dict get $value data]] 33554392]
        append out [count data [string length [dict get $value data]] 33554392]
        append out [pad data [dict get $value data]]
        return $out
    }

    # A request. (player_coopobject_req_t)
    #   request: Which.
    #   parameters: Request-specific.
    struct Req {
        header coopobject.Header
        request uint8
        parameters uint8[]
    } {
        if {[string length $body] - $at < 20} {cut $body $at {4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIuIu header.origin header.id header.parent_id request \
            parameters.count
        incr at 20
        set header.origin [low 0xff ${header.origin}]
        set header.id [low 0xffff ${header.id}]
        set header.parent_id [low 0xffff ${header.parent_id}]
        set request [low 0xff $request]
        set parameters [opaque $body [length $body parameters ${parameters.count} 1]]
        return [dict create \
            header [dict create origin ${header.origin} id ${header.id} parent_id ${header.parent_id}] \
            request $request parameters $parameters]
    } {
        append out [Header.write [dict get $value header]]
        append out [put uint8 [dict get $value request]]
        append out [count parameters [string length [dict get $value parameters]] 33554392]
        append out [count parameters [string length [dict get $value parameters]] 33554392]
        append out [pad parameters [dict get $value parameters]]
        return $out
    }

    # A command. (player_coopobject_cmd_t)
    #   command: Which.
    #   parameters: Command-specific.
    struct Cmd {
        header coopobject.Header
        command uint8
        parameters uint8[]
    } {
        if {[string length $body] - $at < 20} {cut $body $at {4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIuIu header.origin header.id header.parent_id command \
            parameters.count
        incr at 20
        set header.origin [low 0xff ${header.origin}]
        set header.id [low 0xffff ${header.id}]
        set header.parent_id [low 0xffff ${header.parent_id}]
        set command [low 0xff $command]
        set parameters [opaque $body [length $body parameters ${parameters.count} 1]]
        return [dict create \
            header [dict create origin ${header.origin} id ${header.id} parent_id ${header.parent_id}] \
            command $command parameters $parameters]
    } {
        append out [Header.write [dict get $value header]]
        append out [put uint8 [dict get $value command]]
        append out [count parameters [string length [dict get $value parameters]] 33554392]
        append out [count parameters [string length [dict get $value parameters]] 33554392]
        append out [pad parameters [dict get $value parameters]]
        return $out
    }

    # A node is alive.
    message coopobject.data.health DATA 1 coopobject.Header
    # Signal strength received by a node.
    message coopobject.data.rssi DATA 2 coopobject.Rssi
    # Readings of a node.
    message coopobject.data.sensor DATA 3 coopobject.DataSensor
    # Readings of a node that crossed a threshold.
    message coopobject.data.alarm DATA 4 coopobject.DataSensor
    # Bytes from a node.
    message coopobject.data.userdefined DATA 5 coopobject.DataUserdefined
    # A request of a node.
    message coopobject.data.request DATA 6 coopobject.Req
    # A command of a node.
    message coopobject.data.command DATA 7 coopobject.Cmd
    # Position of a node.
    message coopobject.data.position DATA 8 coopobject.Position
    # Sends a command to a node.
    message coopobject.cmd.standard CMD 1 coopobject.Cmd
    # Sends bytes to a node.
    message coopobject.cmd.data CMD 2 coopobject.DataUserdefined
    # Sends the position of a node to a node.
    message coopobject.cmd.position CMD 3 coopobject.Position
    # Sends a request to a node.
    message coopobject.req.standard REQ 1 coopobject.Req
}
