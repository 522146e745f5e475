# Interface camera, code 40. Images.
#
# Generated from interfaces/040_camera.toml by codegen; do not edit.

::playhouse::wire::interface camera 40 {
    # Values of Data.format.
    variable FORMAT_MONO8 1
    variable FORMAT_MONO16 2
    variable FORMAT_RGB565 4
    variable FORMAT_RGB888 5

    # Values of Data.compression.
    variable COMPRESS_RAW 0
    variable COMPRESS_JPEG 1

    # One image. (player_camera_data_t)
    #   width: in px.
    #   height: in px.
    #   bpp: Per pixel (in bit).
    #   format: Order and size of the colors.
    #   fdiv: Divides the values of a disparity image; 1 otherwise.
    #   compression: Raw or JPEG.
    #   image: Rows from the top, pixels from the left, or a JPEG file.
    struct Data {
        width uint32
        height uint32
        bpp uint32
        format uint32
        fdiv uint32
        compression uint32
        image uint8[]
    } {
        if {[string length $body] - $at < 28} {cut $body $at {4 4 4 4 4 4 4}}
        binary scan $body @${at}IuIuIuIuIuIuIu width height bpp format fdiv compression image.count
        incr at 28
        set image [opaque $body [length $body image ${image.count} 1]]
        return [dict create width $width height $height bpp $bpp format $format fdiv $fdiv \
            compression $compression image $image]
    } {
        append out [put uint32 [dict get $value width]]
        append out [put uint32 [dict get $value height]]
        append out [put uint32 [dict get $value bpp]]
        append out [put uint32 [dict get $value format]]
        append out [put uint32 [dict get $value fdiv]]
        append out [put uint32 [dict get $value compression]]
        append out [count image [string length [dict get $value image]] 33554392]
        append out [count image [string length [dict get $value image]] 33554392]
        append out [pad image [dict get $value image]]
        return $out
    }

    # An input of the camera. (player_camera_source_t)
    #   norm: Video norm, such as PAL or NTSC, NUL-terminated.
    #   source: Index of the input.
    struct Source {
        norm char[]
        source int32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu norm.count
        incr at 4
        set norm [opaque $body [length $body norm ${norm.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}I source
        incr at 4
        return [dict create norm $norm source $source]
    } {
        append out [count norm [string length [dict get $value norm]] 33554392]
        append out [count norm [string length [dict get $value norm]] 33554392]
        append out [pad norm [dict get $value norm]]
        append out [put int32 [dict get $value source]]
        return $out
    }

    # One image.
    message camera.data.state DATA 1 camera.Data
    # Requests the camera's input and norm.
    message camera.req.get_source REQ 1 camera.Source
    # Selects the input and norm.
    message camera.req.set_source REQ 2 camera.Source
    # Requests one image now.
    message camera.req.get_image REQ 3 camera.Data
}
