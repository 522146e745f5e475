# The values that the proxies give: dictionaries, in SI units and radians; x forward, y left, z up, angles
# counter-clockwise. The frame of a pose is said where it is given. The others are in generated/proxies/, a file per interface.
#
#     pose          x, y (m), a (heading in rad, 0 along the frame's x, in (-pi, pi] as servers report it)
#     velocity      x, y (m/s), a (rad/s), in the robot's frame
#     pose3d        x, y, z (m), roll, pitch, yaw (rad): rotations about z by yaw, then about the new y by pitch, then about
#                   the new x by roll
#     scan          ranges (m), angles (rad), pairwise; maxRange (m), time
#     marker        id, pose (a pose3d in the sensor's frame), distance (m), bearing (rad)
#     image         width, height, format (a FORMAT_... of ::playhouse::camera), isJpeg, data, time; rows from the top
#     covariance    xx, yy, aa (variances), xy, ya, xa, of a pose
#     plannerState  valid, done, pose, goal, waypoint (on the map), index (-1: none), count, time
#     path          waypoints (poses on the map), length (m)
#     grid          cellSize (m), width, height (cells), origin (pose of the lower left corner of cell 0, 0 in the world)
#     cell          column, row, from the lower left
#     model         name, type, parent, devices (each: port, interface, index, model, name), id
#
# Numbers of a server can be NaN or Inf. Tcl does not compute with NaN: what follows from one is NaN here.

namespace eval ::playhouse {
    variable PI 3.141592653589793
}

proc ::playhouse::pose {{x 0.0} {y 0.0} {a 0.0}} {
    return [dict create x $x y $y a $a]
}

proc ::playhouse::pose3d {{x 0.0} {y 0.0} {z 0.0} {roll 0.0} {pitch 0.0} {yaw 0.0}} {
    return [dict create x $x y $y z $z roll $roll pitch $pitch yaw $yaw]
}

proc ::playhouse::covariance {{xx 0.0} {yy 0.0} {aa 0.0} {xy 0.0} {ya 0.0} {xa 0.0}} {
    return [dict create xx $xx yy $yy aa $aa xy $xy ya $ya xa $xa]
}

# The covariance of independent errors with these standard deviations, in m, m and rad.
proc ::playhouse::ofDeviations {x y a} {
    return [covariance [expr {$x * $x}] [expr {$y * $y}] [expr {$a * $a}]]
}

# The smallest range of a scan between two directions (rad), NaN aside; maxRange if no beam is there. An
# error of kind INVALID if the limits are not numbers, or the first is above the second.
proc ::playhouse::nearest {scan {low -3.141592653589793} {high 3.141592653589793}} {
    foreach limit [list $low $high] {
        if {![string is double -strict $limit] || [isNan $limit]} {fail INVALID "invalid direction of $limit rad"}
    }
    if {$low > $high} {fail INVALID "no direction is from $low to $high rad"}
    set least ""
    foreach range [dict get $scan ranges] angle [dict get $scan angles] {
        if {$angle >= $low && $angle <= $high && ![isNan $range] && ($least eq "" || $range < $least)} {set least $range}
    }
    if {$least eq ""} {return [dict get $scan maxRange]}
    return $least
}

# The ends of a scan's beams, {x y} each in m, in the sensor's frame.
proc ::playhouse::points {scan} {
    return [lmap range [dict get $scan ranges] angle [dict get $scan angles] {
        if {![isFinite $range] || ![isFinite $angle]} {
            list NaN NaN
        } else {
            list [expr {$range * cos($angle)}] [expr {$range * sin($angle)}]
        }
    }]
}

# The values of a pixel of an image: red, green, blue; or its brightness; or its depth in mm. An error of kind INVALID
# for a JPEG file, for other formats, outside of the image, and if the data are shorter than the image.
proc ::playhouse::pixel {image column row} {
    set letters [switch -- [dict get $image format] \
        $camera::FORMAT_MONO8 {set size 1; string cat cu1} $camera::FORMAT_MONO16 {set size 2; string cat su1} \
        $camera::FORMAT_RGB888 {set size 3; string cat cu3}]
    if {$letters eq "" || [dict get $image isJpeg]} {
        fail INVALID "pixels can be told of raw MONO8, MONO16 and RGB888 alone"
    }
    set width [dict get $image width]
    if {$column < 0 || $column >= $width || $row < 0 || $row >= [dict get $image height]} {
        fail INVALID "pixel $column, $row is outside the $width x [dict get $image height] picture"
    }
    if {![binary scan [dict get $image data] @[expr {($row * $width + $column) * $size}]$letters values]} {
        fail INVALID "the picture has fewer bytes than pixels: [string length [dict get $image data]]"
    }
    return $values
}

# For images of a camera with `image "segmentation"`: the id of the model at the pixel, as in the client's models, up
# to 24 bits; empty without a model. Errors as of pixel, and for other formats.
proc ::playhouse::modelId {image column row} {
    set channels [pixel $image $column $row]
    if {[llength $channels] != 3} {fail INVALID "which model a pixel shows is told by RGB888 alone"}
    lassign $channels red green blue
    set number [expr {$red << 16 | $green << 8 | $blue}]
    return [expr {$number > 0 ? $number - 1 : ""}]
}

# The cell of a grid with this point of the world (m); empty beyond the map.
proc ::playhouse::cellOf {grid x y} {
    if {![isFinite $x] || ![isFinite $y]} {return ""}
    set origin [dict get $grid origin]
    set dx [expr {$x - [dict get $origin x]}]
    set dy [expr {$y - [dict get $origin y]}]
    set c [expr {cos([dict get $origin a])}]
    set s [expr {sin([dict get $origin a])}]
    set size [dict get $grid cellSize]
    set column [expr {($c * $dx + $s * $dy) / $size}]
    set row [expr {($c * $dy - $s * $dx) / $size}]
    if {!($column >= 0 && $column < [dict get $grid width] && $row >= 0 && $row < [dict get $grid height])} {return ""}
    return [dict create column [expr {int($column)}] row [expr {int($row)}]]
}

# --- from the wire, and to it ----------------------------------------------------------------------------------------

namespace eval ::playhouse::from {}

proc ::playhouse::from::pose {wire} {
    return [dict create x [dict get $wire px] y [dict get $wire py] a [dict get $wire pa]]
}

proc ::playhouse::from::pose3d {wire} {
    return [dict create x [dict get $wire px] y [dict get $wire py] z [dict get $wire pz] \
        roll [dict get $wire proll] pitch [dict get $wire ppitch] yaw [dict get $wire pyaw]]
}

proc ::playhouse::from::size {wire} {
    return [dict create x [dict get $wire sl] y [dict get $wire sw] z [dict get $wire sh]]
}

proc ::playhouse::from::rgb {wire} {
    return [lmap channel {red green blue} {dict get $wire $channel}]
}

proc ::playhouse::from::rgba {wire} {
    return [lmap channel {red green blue alpha} {dict get $wire $channel}]
}

# Of 0xRRGGBB.
proc ::playhouse::from::packedRgb {color} {
    return [list [expr {$color >> 16 & 255}] [expr {$color >> 8 & 255}] [expr {$color & 255}]]
}

# impossible, no or yes.
proc ::playhouse::from::charging {state} {
    return [expr {$state < 0 ? "impossible" : $state > 0 ? "yes" : "no"}]
}

# Levels in dBm are signed, all others are not.
proc ::playhouse::from::level {value unit} {
    return [expr {$unit == $::playhouse::wifi::QUAL_DBM ? $value : $value & 0xffffffff}]
}

# A value, empty if the flags lack a bit.
proc ::playhouse::from::onlyIf {flags bit value} {
    return [expr {$flags & $bit ? $value : ""}]
}

# A number, empty if it is the one that stands for none.
proc ::playhouse::from::unless {absent value} {
    if {![::playhouse::isNan $value] && $value == $absent} return
    return $value
}

# The bytes of a byte string, and whether each is not 0.
proc ::playhouse::from::numbers {bytes} {
    binary scan $bytes cu* numbers
    return $numbers
}

proc ::playhouse::from::truths {bytes} {
    return [lmap number [numbers $bytes] {expr {$number != 0}}]
}

# The direction of each range: those of the elements if there is one per range, else spread from low to high.
proc ::playhouse::from::directions {low high ranges {elements {}}} {
    set count [llength $ranges]
    if {[llength $elements] == $count && $count > 1} {return [lmap element $elements {dict get $element pyaw}]}
    if {![::playhouse::isFinite $low] || ![::playhouse::isFinite $high]} {return [lrepeat $count NaN]}
    set step [expr {$count > 1 ? ($high - $low) / ($count - 1) : 0.0}]
    set angles {}
    for {set i 0} {$i < $count} {incr i} {lappend angles [expr {$low + $i * $step}]}
    return $angles
}

proc ::playhouse::from::scan {ranges angles maxRange time} {
    return [dict create ranges $ranges angles $angles maxRange $maxRange time $time]
}

proc ::playhouse::from::image {width height format isJpeg data time} {
    return [dict create width $width height $height format $format isJpeg $isJpeg data $data time $time]
}

# A marker, with its distance and bearing.
proc ::playhouse::from::marker {id pose} {
    lassign [dict values $pose] x y
    set marker [dict create id $id pose $pose distance NaN bearing NaN]
    if {![::playhouse::isNan $x] && ![::playhouse::isNan $y]} {
        dict set marker distance [expr {hypot($x, $y)}]
        dict set marker bearing [expr {atan2($y, $x)}]
    }
    return $marker
}

namespace eval ::playhouse::to {}

proc ::playhouse::to::pose {x y a} {
    return [dict create px $x py $y pa $a]
}

proc ::playhouse::to::color {rgb} {
    lassign $rgb red green blue
    return [dict create alpha 255 red $red green $green blue $blue]
}

# A pose3d or a covariance whose missing parts are 0. Other parts are an error of kind INVALID.
proc ::playhouse::to::complete {what given} {
    set zero [::playhouse::$what]
    if {[catch {dict merge $zero $given} value] || [dict size $value] != [dict size $zero]} {
        ::playhouse::fail INVALID "a $what has [join [dict keys $zero] {, }], and is not \"$given\""
    }
    return $value
}

proc ::playhouse::to::pose3d {pose} {
    set pose [complete pose3d $pose]
    return [dict create px [dict get $pose x] py [dict get $pose y] pz [dict get $pose z] \
        proll [dict get $pose roll] ppitch [dict get $pose pitch] pyaw [dict get $pose yaw]]
}
