# What every interface shares. Types shared by several interfaces, and requests to any device.
#
# Generated from interfaces/000_common.toml by codegen; do not edit.

::playhouse::wire::interface common 0 {
    # Limits shared by all implementations of the protocol.
    variable MAX_MESSAGE_SIZE 8388608
    variable MAX_DRIVER_STRING_LEN 64
    variable MAX_DEVICES 4096
    variable MSGQUEUE_DEFAULT_MAXLEN 1024
    variable IDENT_STRLEN 32
    variable KEYLEN 32

    # Address of a device. (player_devaddr_t)
    #   host: Host of the device's server; receivers compare only interf and index.
    #   robot: TCP port of the device's server: its name space.
    #   interf: Interface code.
    #   index: Index of the device within its interface.
    struct Devaddr {
        host uint32
        robot uint32
        interf uint16
        index uint16
    } {
        if {[string length $body] - $at < 16} {cut $body $at {4 4 4 4}}
        binary scan $body @${at}IuIuIuIu host robot interf index
        incr at 16
        set interf [low 0xffff $interf]
        set index [low 0xffff $index]
        return [dict create host $host robot $robot interf $interf index $index]
    } {
        append out [put uint32 [dict get $value host]]
        append out [put uint32 [dict get $value robot]]
        append out [put uint16 [dict get $value interf]]
        append out [put uint16 [dict get $value index]]
        return $out
    }

    # A point or vector in the plane. (player_point_2d_t)
    #   px: in m.
    #   py: in m.
    struct Point2d {
        px float64
        py float64
    } {
        if {[string length $body] - $at < 16} {cut $body $at {8 8}}
        binary scan $body @${at}QQ px py
        incr at 16
        return [dict create px $px py $py]
    } {
        append out [put float64 [dict get $value px]]
        append out [put float64 [dict get $value py]]
        return $out
    }

    # A point or vector in space. (player_point_3d_t)
    #   px: in m.
    #   py: in m.
    #   pz: in m.
    struct Point3d {
        px float64
        py float64
        pz float64
    } {
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}QQQ px py pz
        incr at 24
        return [dict create px $px py $py pz $pz]
    } {
        append out [put float64 [dict get $value px]]
        append out [put float64 [dict get $value py]]
        append out [put float64 [dict get $value pz]]
        return $out
    }

    # An orientation in space: rotations about z (yaw), then y (pitch), then x (roll).
    # (player_orientation_3d_t)
    #   proll: About x (in rad).
    #   ppitch: About y (in rad).
    #   pyaw: About z (in rad).
    struct Orientation3d {
        proll float64
        ppitch float64
        pyaw float64
    } {
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}QQQ proll ppitch pyaw
        incr at 24
        return [dict create proll $proll ppitch $ppitch pyaw $pyaw]
    } {
        append out [put float64 [dict get $value proll]]
        append out [put float64 [dict get $value ppitch]]
        append out [put float64 [dict get $value pyaw]]
        return $out
    }

    # A pose in the plane, or, if the message says so, a velocity with the same three components.
    # (player_pose2d_t)
    #   px: in m.
    #   py: in m.
    #   pa: Heading, counter-clockwise from x (in rad).
    struct Pose2d {
        px float64
        py float64
        pa float64
    } {
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}QQQ px py pa
        incr at 24
        return [dict create px $px py $py pa $pa]
    } {
        append out [put float64 [dict get $value px]]
        append out [put float64 [dict get $value py]]
        append out [put float64 [dict get $value pa]]
        return $out
    }

    # A pose in space, or, if the message says so, a velocity or acceleration with the same six components.
    # (player_pose3d_t)
    #   px: in m.
    #   py: in m.
    #   pz: in m.
    #   proll: About x (in rad).
    #   ppitch: About y (in rad).
    #   pyaw: About z (in rad).
    struct Pose3d {
        px float64
        py float64
        pz float64
        proll float64
        ppitch float64
        pyaw float64
    } {
        if {[string length $body] - $at < 48} {cut $body $at {8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQ px py pz proll ppitch pyaw
        incr at 48
        return [dict create px $px py $py pz $pz proll $proll ppitch $ppitch pyaw $pyaw]
    } {
        append out [put float64 [dict get $value px]]
        append out [put float64 [dict get $value py]]
        append out [put float64 [dict get $value pz]]
        append out [put float64 [dict get $value proll]]
        append out [put float64 [dict get $value ppitch]]
        append out [put float64 [dict get $value pyaw]]
        return $out
    }

    # Size of a bounding rectangle. (player_bbox2d_t)
    #   sw: Width, along y (in m).
    #   sl: Length, along x (in m).
    struct Bbox2d {
        sw float64
        sl float64
    } {
        if {[string length $body] - $at < 16} {cut $body $at {8 8}}
        binary scan $body @${at}QQ sw sl
        incr at 16
        return [dict create sw $sw sl $sl]
    } {
        append out [put float64 [dict get $value sw]]
        append out [put float64 [dict get $value sl]]
        return $out
    }

    # Size of a bounding box. (player_bbox3d_t)
    #   sw: Width, along y (in m).
    #   sl: Length, along x (in m).
    #   sh: Height, along z (in m).
    struct Bbox3d {
        sw float64
        sl float64
        sh float64
    } {
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}QQQ sw sl sh
        incr at 24
        return [dict create sw $sw sl $sl sh $sh]
    } {
        append out [put float64 [dict get $value sw]]
        append out [put float64 [dict get $value sl]]
        append out [put float64 [dict get $value sh]]
        return $out
    }

    # One entry of a blackboard: a value under a key in a group. (player_blackboard_entry_t)
    #   key: Name of the entry within its group.
    #   group: Name of the group, a namespace of keys.
    #   type: Category of `data`: simple values or types of other interfaces.
    #   subtype: Exact type of `data`; of simple values: string, integer or floating-point number.
    #   data: Bytes of the value, opaque to the blackboard.
    #   timestamp_sec: Time at which the value was set: whole seconds (in s).
    #   timestamp_usec: Time at which the value was set: microseconds of the second (in us).
    struct BlackboardEntry {
        key char[]
        group char[]
        type uint16
        subtype uint16
        data uint8[]
        timestamp_sec uint32
        timestamp_usec uint32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu key.count
        incr at 4
        set key [opaque $body [length $body key ${key.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu group.count
        incr at 4
        set group [opaque $body [length $body group ${group.count} 1]]
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}IuIuIu type subtype data.count
        incr at 12
        set type [low 0xffff $type]
        set subtype [low 0xffff $subtype]
        set data [opaque $body [length $body data ${data.count} 1]]
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuIu timestamp_sec timestamp_usec
        incr at 8
        return [dict create key $key group $group type $type subtype $subtype data $data \
            timestamp_sec $timestamp_sec timestamp_usec $timestamp_usec]
    } {
        append out [count key [string length [dict get $value key]] 33554392]
        append out [count key [string length [dict get $value key]] 33554392]
        append out [pad key [dict get $value key]]
        append out [count group [string length [dict get $value group]] 33554392]
        append out [count group [string length [dict get $value group]] 33554392]
        append out [pad group [dict get $value group]]
        append out [put uint16 [dict get $value type]]
        append out [put uint16 [dict get $value subtype]]
        append out [count data [string length [dict get $value data]] 33554392]
        append out [count data [string length [dict get $value data]] 33554392]
        append out [pad data [dict get $value data]]
        append out [put uint32 [dict get $value timestamp_sec]]
        append out [put uint32 [dict get $value timestamp_usec]]
        return $out
    }

    # A line segment. (player_segment_t)
    #   x0: x of the start (in m).
    #   y0: y of the start (in m).
    #   x1: x of the end (in m).
    #   y1: y of the end (in m).
    struct Segment {
        x0 float64
        y0 float64
        x1 float64
        y1 float64
    } {
        if {[string length $body] - $at < 32} {cut $body $at {8 8 8 8}}
        binary scan $body @${at}QQQQ x0 y0 x1 y1
        incr at 32
        return [dict create x0 $x0 y0 $y0 x1 $x1 y1 $y1]
    } {
        append out [put float64 [dict get $value x0]]
        append out [put float64 [dict get $value y0]]
        append out [put float64 [dict get $value x1]]
        append out [put float64 [dict get $value y1]]
        return $out
    }

    # An axis-aligned rectangle, given by two corners. (player_extent2d_t)
    #   x0: Smallest x (in m).
    #   y0: Smallest y (in m).
    #   x1: Largest x (in m).
    #   y1: Largest y (in m).
    struct Extent2d {
        x0 float64
        y0 float64
        x1 float64
        y1 float64
    } {
        if {[string length $body] - $at < 32} {cut $body $at {8 8 8 8}}
        binary scan $body @${at}QQQQ x0 y0 x1 y1
        incr at 32
        return [dict create x0 $x0 y0 $y0 x1 $x1 y1 $y1]
    } {
        append out [put float64 [dict get $value x0]]
        append out [put float64 [dict get $value y0]]
        append out [put float64 [dict get $value x1]]
        append out [put float64 [dict get $value y1]]
        return $out
    }

    # A color with opacity, each component from 0 to 255. (player_color_t)
    #   alpha: 255 is opaque, 0 invisible.
    struct Color {
        alpha uint8
        red uint8
        green uint8
        blue uint8
    } {
        if {[string length $body] - $at < 16} {cut $body $at {4 4 4 4}}
        binary scan $body @${at}IuIuIuIu alpha red green blue
        incr at 16
        set alpha [low 0xff $alpha]
        set red [low 0xff $red]
        set green [low 0xff $green]
        set blue [low 0xff $blue]
        return [dict create alpha $alpha red $red green $green blue $blue]
    } {
        append out [put uint8 [dict get $value alpha]]
        append out [put uint8 [dict get $value red]]
        append out [put uint8 [dict get $value green]]
        append out [put uint8 [dict get $value blue]]
        return $out
    }

    # A switch. (player_bool_t)
    #   state: 0: off, else on.
    struct Bool {
        state uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu state
        incr at 4
        set state [low 0xff $state]
        return [dict create state $state]
    } {
        append out [put uint8 [dict get $value state]]
        return $out
    }

    # One integer. (player_uint32_t)
    struct Uint32 {
        value uint32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu value
        incr at 4
        return [dict create value $value]
    } {
        append out [put uint32 [dict get $value value]]
        return $out
    }

    # The queried message. (player_capabilities_req_t)
    #   type: Type of the message, as in a header.
    #   subtype: Subtype of the message, as in a header.
    struct CapabilitiesReq {
        type uint32
        subtype uint32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IuIu type subtype
        incr at 8
        return [dict create type $type subtype $subtype]
    } {
        append out [put uint32 [dict get $value type]]
        append out [put uint32 [dict get $value subtype]]
        return $out
    }

    # A named switch. (player_boolprop_req_t)
    #   key: Name of the property, NUL-terminated.
    #   value: 0 false, else true; ignored in a request.
    struct BoolpropReq {
        key char[]
        value char
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu key.count
        incr at 4
        set key [opaque $body [length $body key ${key.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}I value
        incr at 4
        set value [signed 0x80 $value]
        return [dict create key $key value $value]
    } {
        append out [count key [string length [dict get $value key]] 33554392]
        append out [count key [string length [dict get $value key]] 33554392]
        append out [pad key [dict get $value key]]
        append out [put char [dict get $value value]]
        return $out
    }

    # A named integer. (player_intprop_req_t)
    #   key: Name of the property, NUL-terminated.
    #   value: Ignored in a question.
    struct IntpropReq {
        key char[]
        value int32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu key.count
        incr at 4
        set key [opaque $body [length $body key ${key.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}I value
        incr at 4
        return [dict create key $key value $value]
    } {
        append out [count key [string length [dict get $value key]] 33554392]
        append out [count key [string length [dict get $value key]] 33554392]
        append out [pad key [dict get $value key]]
        append out [put int32 [dict get $value value]]
        return $out
    }

    # A named number. (player_dblprop_req_t)
    #   key: Name of the property, NUL-terminated.
    #   value: In the driver's unit for the property; ignored in a request.
    struct DblpropReq {
        key char[]
        value float64
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu key.count
        incr at 4
        set key [opaque $body [length $body key ${key.count} 1]]
        if {[string length $body] - $at < 8} {cut $body $at {8}}
        binary scan $body @${at}Q value
        incr at 8
        return [dict create key $key value $value]
    } {
        append out [count key [string length [dict get $value key]] 33554392]
        append out [count key [string length [dict get $value key]] 33554392]
        append out [pad key [dict get $value key]]
        append out [put float64 [dict get $value value]]
        return $out
    }

    # A named string. (player_strprop_req_t)
    #   key: Name of the property, NUL-terminated.
    #   value: NUL-terminated; ignored in a request.
    struct StrpropReq {
        key char[]
        value char[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu key.count
        incr at 4
        set key [opaque $body [length $body key ${key.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu value.count
        incr at 4
        set value [opaque $body [length $body value ${value.count} 1]]
        return [dict create key $key value $value]
    } {
        append out [count key [string length [dict get $value key]] 33554392]
        append out [count key [string length [dict get $value key]] 33554392]
        append out [pad key [dict get $value key]]
        append out [count value [string length [dict get $value value]] 33554392]
        append out [count value [string length [dict get $value value]] 33554392]
        append out [pad value [dict get $value value]]
        return $out
    }

    # Queries whether the device supports a message: an empty ACK means yes, NACK no.
    message universal.req.capabilities REQ 255 common.CapabilitiesReq
    # Reads a named integer of the driver; the answer repeats the key.
    message universal.req.get_intprop REQ 254 common.IntpropReq
    # Changes a named integer of the driver.
    message universal.req.set_intprop REQ 253 common.IntpropReq
    # Reads a named number of the driver; the answer repeats the key.
    message universal.req.get_dblprop REQ 252 common.DblpropReq
    # Changes a named number of the driver.
    message universal.req.set_dblprop REQ 251 common.DblpropReq
    # Reads a named string of the driver; the answer repeats the key.
    message universal.req.get_strprop REQ 250 common.StrpropReq
    # Changes a named string of the driver.
    message universal.req.set_strprop REQ 249 common.StrpropReq
    # Reads a named switch of the driver; the answer repeats the key.
    message universal.req.get_boolprop REQ 248 common.BoolpropReq
    # Changes a named switch of the driver.
    message universal.req.set_boolprop REQ 247 common.BoolpropReq
}
