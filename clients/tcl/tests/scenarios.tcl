# Repeats the programs behind the recorded sessions with this library: scenarios NAME HOST:PORT.
# clients/python/tests/test_replay.py plays back the recorded answers and compares what the client sends; its twin is
# clients/python/tests/scenarios.py.

source [file join [file dirname [file normalize [info script]]] program.tcl]

set degree [expr {$playhouse::PI / 180}]

proc reads {client count} {
    for {set i 0} {$i < $count} {incr i} {$client read}
}

proc printPosition {address} {
    set client [playhouse::connect $address]
    $client position2d 0
    $client setMode pull
    $client setReplaceRule accept
    reads $client 3
}

proc printDefaults {address} {
    set client [playhouse::connect $address]
    $client position2d 0
    reads $client 2
}

proc checkPosition {address} {
    global degree
    set client [playhouse::connect $address]
    set robot [$client position2d 0]
    reads $client 23
    $robot setOdometry 0.1 -0.2 $playhouse::PI
    reads $client 10
    $robot setOdometry 0 0 0
    $robot setMotorPower 1
    $robot drive 0.1
    $robot drive -0.1
    $robot drive 0 0 0.1
    $robot drive 0 0 -0.1
    $robot drive 0 [expr {-25 * $degree}]
    $robot drive 0 [expr {25 * $degree}]
    $robot drive 0 [expr {45 * $degree}] 0.1
    $robot drive 0 [expr {-45 * $degree}] -0.1
    $robot stop
    $robot setMotorPower 0
    $robot setOdometry 0 0 0
}

proc checkLaser {address} {
    set client [playhouse::connect $address]
    set laser [$client laser 0]
    reads $client 20
    set quarter [expr {$playhouse::PI / 2}]
    mustRefuse {
        $laser setConfig [dict create min_angle -$quarter max_angle $quarter resolution 100 range_res 1 intensity 1 \
            scanning_frequency 10]
    }
}

proc checkRanger {address} {
    set client [playhouse::connect $address]
    set ranger [$client ranger 1]
    reads $client 60
    $ranger request ranger.req.get_geom
    reads $client 3
}

proc askMap {address} {
    set client [playhouse::connect $address -mode push]
    set map [$client device map 0]
    $map request map.req.get_info
    $map request map.req.get_data {col 0 row 0 width 20 height 10}
    $map request map.req.get_data {col 495 row 0 width 50 height 3}
    mustRefuse {$map request map.req.get_vector}
}

proc askSimulation {address} {
    set client [playhouse::connect $address -mode push]
    set simulation [$client simulation 0]
    $simulation pose r0
    $simulation setPose r0 -6 -6 0.5
    mustRefuse {$simulation pose nosuch}
    $simulation pose3d r0
}

proc askProperties {address} {
    set client [playhouse::connect $address -mode push]
    set lights [$client device dio 0]
    set stream [$client device opaque 1]
    $lights getProperty skip_lines int
    $lights setProperty skip_lines int 7
    $lights getProperty skip_lines int
    $lights getProperty max_diff_pixels double
    $lights setProperty max_diff_pixels double 0.25
    $lights getProperty max_diff_pixels double
    $lights getProperty max_diff_pixels int
    mustRefuse {$lights getProperty nope int}
    $lights hasCapability universal.req.capabilities
    $stream getProperty ip string
    $stream setProperty ip string 127.0.0.2
    $stream getProperty ip string
    mustRefuse {$stream getProperty nobool bool}
}

runProgram "usage: scenarios NAME HOST:PORT" {
    05_playerprint_position2d printPosition
    06_playerprint_defaults printDefaults
    10_cxxtest_position2d checkPosition
    11_cxxtest_laser checkLaser
    12_cxxtest_ranger checkRanger
    13_raw_map askMap
    14_raw_simulation askSimulation
    15_raw_properties askProperties
}
