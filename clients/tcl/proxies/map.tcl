namespace eval ::playhouse {
    variable TILE 512 ;# cells along a side of a tile of a map, so that any map fits into messages
    variable MOST_CELLS 67108864 ;# of a map
}

# A grid map.
oo::class create ::playhouse::Map {
    superclass ::playhouse::Device

    # Size and place of the map, without its cells. An error of kind WIRE if the numbers are those of no map.
    method grid {} {
        set info [my Ask map.req.get_info]
        set size [dict get $info scale]
        set origin [from::pose [dict get $info origin]]
        foreach number [list $size {*}[dict values $origin]] {
            if {![isFinite $number] || $size <= 0} {
                fail WIRE "[my name]: invalid map: cells of $size m from ([join [dict values $origin] {, }]) on"
            }
        }
        return [dict create cellSize $size width [dict get $info width] height [dict get $info height] origin $origin]
    }

    # The whole map, row by row from the bottom: [lindex $cells $row $column] is 1 if the cell is occupied, -1 if it is
    # free, 0 if that is unknown. An error of kind WIRE for a map of more than 2^26 cells, and for faulty answers.
    method cells {} {
        set grid [my grid]
        set width [dict get $grid width]
        set height [dict get $grid height]
        if {$width * $height > $::playhouse::MOST_CELLS} {
            fail WIRE "[my name]: $width x $height cells are over the limit of $::playhouse::MOST_CELLS"
        }
        if {$width == 0} {return {}}
        set rows {}
        for {set row 0} {$row < $height} {incr row $::playhouse::TILE} {
            lappend rows {*}[my Band $row $width [expr {min($::playhouse::TILE, $height - $row)}]]
        }
        return $rows
    }

    # All cells of the rows from `row` on, as high as a tile.
    method Band {row width height} {
        set rows [lrepeat $height {}]
        for {set column 0} {$column < $width} {incr column $::playhouse::TILE} {
            set part [expr {min($::playhouse::TILE, $width - $column)}]
            set cells [my Tile $column $row $part $height]
            for {set i 0} {$i < $height} {incr i} {
                lset rows $i [concat [lindex $rows $i] [lrange $cells [expr {$i * $part}] [expr {($i + 1) * $part - 1}]]]
            }
        }
        return $rows
    }

    method Tile {column row width height} {
        set tile [my Ask map.req.get_data [dict create col $column row $row width $width height $height]]
        set values [my Inflated [dict get $tile data] [expr {$width * $height}]]
        if {[string length $values] != $width * $height} {
            fail WIRE "[my name]: a tile of $width x $height cells is damaged"
        }
        binary scan $values c* values
        set limit [expr {max([dict get $tile data_range], 1)}]
        # What each byte says: 1 and -1 beyond half of the range.
        for {set value -128} {$value < 128} {incr value} {
            set occupancy($value) [expr {(2 * $value > $limit) - (2 * $value < -$limit)}]
        }
        return [lmap value $values {set occupancy($value)}]
    }

    # At most one byte more than `count`; the data themselves if they are not a zlib stream, as of a server without it.
    method Inflated {data count} {
        set stream [zlib stream decompress]
        try {
            $stream put $data
            return [$stream get [expr {$count + 1}]]
        } trap {TCL ZLIB} {} {
            return $data
        } finally {
            $stream close
        }
    }
}
