# Interface wifi, code 23. State of wireless network links.
#
# Generated from interfaces/023_wifi.toml by codegen; do not edit.

::playhouse::wire::interface wifi 23 {
    # Values of Data.qual_type: unit of link quality.
    variable QUAL_DBM 1
    variable QUAL_REL 2
    variable QUAL_UNKNOWN 3

    # Values of Data.mode and Link.mode.
    variable MODE_UNKNOWN 0
    variable MODE_AUTO 1
    variable MODE_ADHOC 2
    variable MODE_INFRA 3
    variable MODE_MASTER 4
    variable MODE_REPEAT 5
    variable MODE_SECOND 6

    # One link. (player_wifi_link_t)
    #   mac: Hardware address, as a string.
    #   ip: Network address, as a string.
    #   essid: Name of the network, as a string.
    #   mode: Role in the network.
    #   freq: in MHz.
    #   encrypt: 0: open, else encrypted.
    #   qual: Quality, up to Data.maxqual.
    #   level: Signal, up to Data.maxlevel.
    #   noise: Noise, up to Data.maxnoise.
    struct Link {
        mac uint8[]
        ip uint8[]
        essid uint8[]
        mode uint32
        freq uint32
        encrypt uint32
        qual uint32
        level int32
        noise int32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        incr at 4
        set mac [opaque $body [length $body mac 32 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        incr at 4
        set ip [opaque $body [length $body ip 32 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        incr at 4
        set essid [opaque $body [length $body essid 32 1]]
        if {[string length $body] - $at < 24} {cut $body $at {4 4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIuII mode freq encrypt qual level noise
        incr at 24
        return [dict create mac $mac ip $ip essid $essid mode $mode freq $freq encrypt $encrypt \
            qual $qual level $level noise $noise]
    } {
        append out [count mac [string length [dict get $value mac]] 32]
        append out [count mac [string length [dict get $value mac]] 32]
        append out [pad mac [dict get $value mac]]
        append out [count ip [string length [dict get $value ip]] 32]
        append out [count ip [string length [dict get $value ip]] 32]
        append out [pad ip [dict get $value ip]]
        append out [count essid [string length [dict get $value essid]] 32]
        append out [count essid [string length [dict get $value essid]] 32]
        append out [pad essid [dict get $value essid]]
        append out [put uint32 [dict get $value mode]]
        append out [put uint32 [dict get $value freq]]
        append out [put uint32 [dict get $value encrypt]]
        append out [put uint32 [dict get $value qual]]
        append out [put int32 [dict get $value level]]
        append out [put int32 [dict get $value noise]]
        return $out
    }

    # Every link and the state of the card. (player_wifi_data_t)
    #   throughput: Estimated throughput of the card (in bit/s).
    #   bitrate: Configured bit rate of the card (in bit/s).
    #   mode: Role in the network.
    #   qual_type: Unit of quality, level and noise.
    #   maxqual: Maximum reported quality.
    #   maxlevel: Maximum reported signal level.
    #   maxnoise: Maximum reported noise level.
    #   ap: Hardware address of the access point, as a string.
    struct Data {
        links wifi.Link[]
        throughput uint32
        bitrate uint32
        mode uint32
        qual_type uint32
        maxqual uint32
        maxlevel int32
        maxnoise int32
        ap char[32]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu links.count
        incr at 4
        set links {}
        for {set links.left [length $body links ${links.count} 48]} {${links.left} > 0} {incr links.left -1} {
            lappend links [Link.read $body]
        }
        if {[string length $body] - $at < 60} {cut $body $at {4 4 4 4 4 4 4 32}}
        binary scan $body @${at}IuIuIuIuIuIIa32 throughput bitrate mode qual_type maxqual maxlevel \
            maxnoise ap
        incr at 60
        return [dict create links $links throughput $throughput bitrate $bitrate mode $mode \
            qual_type $qual_type maxqual $maxqual maxlevel $maxlevel maxnoise $maxnoise ap $ap]
    } {
        append out [count links [llength [dict get $value links]] 699049]
        append out [count links [llength [dict get $value links]] 699049]
        foreach item [dict get $value links] {append out [Link.write $item]}
        append out [put uint32 [dict get $value throughput]]
        append out [put uint32 [dict get $value bitrate]]
        append out [put uint32 [dict get $value mode]]
        append out [put uint32 [dict get $value qual_type]]
        append out [put uint32 [dict get $value maxqual]]
        append out [put int32 [dict get $value maxlevel]]
        append out [put int32 [dict get $value maxnoise]]
        append out [pad ap [dict get $value ap] 32]
        return $out
    }

    # The card's own address. (player_wifi_mac_req_t)
    #   mac: Hardware address, as a string.
    struct MacReq {
        mac uint8[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        incr at 4
        set mac [opaque $body [length $body mac 32 1]]
        return [dict create mac $mac]
    } {
        append out [count mac [string length [dict get $value mac]] 32]
        append out [count mac [string length [dict get $value mac]] 32]
        append out [pad mac [dict get $value mac]]
        return $out
    }

    # The address of a station. (player_wifi_iwspy_addr_req_t)
    #   address: Hardware address, as a string.
    struct IwspyAddrReq {
        address char[32]
    } {
        if {[string length $body] - $at < 32} {cut $body $at {32}}
        binary scan $body @${at}a32 address
        incr at 32
        return [dict create address $address]
    } {
        append out [pad address [dict get $value address] 32]
        return $out
    }

    # Requests the card's own address.
    message wifi.req.mac REQ 1 wifi.MacReq
    # Starts monitoring the links to an address.
    message wifi.req.iwspy_add REQ 2 wifi.IwspyAddrReq
    # Stops monitoring the links to an address.
    message wifi.req.iwspy_del REQ 3 wifi.IwspyAddrReq
    # Sends a packet to an address to measure its link.
    message wifi.req.iwspy_ping REQ 4 wifi.IwspyAddrReq
    # Every link and the state of the card.
    message wifi.data.state DATA 1 wifi.Data
}
