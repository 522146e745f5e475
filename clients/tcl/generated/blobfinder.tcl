# Interface blobfinder, code 7. Finds regions of one color (blobs) in camera images.
#
# Generated from interfaces/007_blobfinder.toml by codegen; do not edit.

::playhouse::wire::interface blobfinder 7 {
    # A blob. Pixel coordinates start at the top left corner of the image. (player_blobfinder_blob_t)
    #   id: Channel that detected it.
    #   color: 0xRRGGBB, for display.
    #   area: Area in pixels (in px).
    #   x: Column of its centre (in px).
    #   y: Row of its centre (in px).
    #   left: First column (in px).
    #   right: Last column (in px).
    #   top: First row (in px).
    #   bottom: Last row (in px).
    #   range: Distance; 0 if unknown (in m).
    struct Blob {
        id uint32
        color uint32
        area uint32
        x uint32
        y uint32
        left uint32
        right uint32
        top uint32
        bottom uint32
        range float32
    } {
        if {[string length $body] - $at < 40} {cut $body $at {4 4 4 4 4 4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIuIuIuIuIuIuR id color area x y left right top bottom range
        incr at 40
        return [dict create id $id color $color area $area x $x y $y left $left right $right top $top \
            bottom $bottom range $range]
    } {
        append out [put uint32 [dict get $value id]]
        append out [put uint32 [dict get $value color]]
        append out [put uint32 [dict get $value area]]
        append out [put uint32 [dict get $value x]]
        append out [put uint32 [dict get $value y]]
        append out [put uint32 [dict get $value left]]
        append out [put uint32 [dict get $value right]]
        append out [put uint32 [dict get $value top]]
        append out [put uint32 [dict get $value bottom]]
        append out [put float32 [dict get $value range]]
        return $out
    }

    # The blobs of one image. (player_blobfinder_data_t)
    #   width: Of the image (in px).
    #   height: Of the image (in px).
    struct Data {
        width uint32
        height uint32
        blobs blobfinder.Blob[]
    } {
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}IuIuIu width height blobs.count
        incr at 12
        set blobs {}
        for {set blobs.left [length $body blobs ${blobs.count} 40]} {${blobs.left} > 0} {incr blobs.left -1} {
            lappend blobs [Blob.read $body]
        }
        return [dict create width $width height $height blobs $blobs]
    } {
        append out [put uint32 [dict get $value width]]
        append out [put uint32 [dict get $value height]]
        append out [count blobs [llength [dict get $value blobs]] 838859]
        append out [count blobs [llength [dict get $value blobs]] 838859]
        foreach item [dict get $value blobs] {append out [Blob.write $item]}
        return $out
    }

    # The colors that a channel detects, as ranges of red, green and blue. (player_blobfinder_color_config_t)
    #   channel: Channel; -1 means all.
    struct ColorConfig {
        channel int32
        rmin uint32
        rmax uint32
        gmin uint32
        gmax uint32
        bmin uint32
        bmax uint32
    } {
        if {[string length $body] - $at < 28} {cut $body $at {4 4 4 4 4 4 4}}
        binary scan $body @${at}IIuIuIuIuIuIu channel rmin rmax gmin gmax bmin bmax
        incr at 28
        return [dict create channel $channel rmin $rmin rmax $rmax gmin $gmin gmax $gmax bmin $bmin \
            bmax $bmax]
    } {
        append out [put int32 [dict get $value channel]]
        append out [put uint32 [dict get $value rmin]]
        append out [put uint32 [dict get $value rmax]]
        append out [put uint32 [dict get $value gmin]]
        append out [put uint32 [dict get $value gmax]]
        append out [put uint32 [dict get $value bmin]]
        append out [put uint32 [dict get $value bmax]]
        return $out
    }

    # Settings of the camera; -1 leaves a setting unchanged. (player_blobfinder_imager_config_t)
    #   brightness: 0 to 255.
    #   contrast: 0 to 255.
    #   colormode: 0 RGB, 1 RGB without white balance, 2 YUV, 3 YUV without white balance.
    #   autogain: 0 off, 1 on.
    struct ImagerConfig {
        brightness int32
        contrast int32
        colormode int32
        autogain int32
    } {
        if {[string length $body] - $at < 16} {cut $body $at {4 4 4 4}}
        binary scan $body @${at}IIII brightness contrast colormode autogain
        incr at 16
        return [dict create brightness $brightness contrast $contrast colormode $colormode \
            autogain $autogain]
    } {
        append out [put int32 [dict get $value brightness]]
        append out [put int32 [dict get $value contrast]]
        append out [put int32 [dict get $value colormode]]
        append out [put int32 [dict get $value autogain]]
        return $out
    }

    # The blobs of one image.
    message blobfinder.data.blobs DATA 1 blobfinder.Data
    # Sets the colors that a channel detects.
    message blobfinder.req.set_color REQ 1 blobfinder.ColorConfig
    # Sets brightness, contrast and other settings of the camera.
    message blobfinder.req.set_imager_params REQ 2 blobfinder.ImagerConfig
    # Requests the colors that a channel detects.
    message blobfinder.req.get_color REQ 3 blobfinder.ColorConfig
}
