# Interface imu, code 60. Accelerations, turn rates, magnetic field and orientation.
#
# Generated from interfaces/060_imu.toml by codegen; do not edit.

::playhouse::wire::interface imu 60 {
    # Pose by integration. (player_imu_data_state_t)
    #   pose: in m, m, m, rad, rad, rad, frame X_WS.
    struct DataState {
        pose common.Pose3d
    } {
        if {[string length $body] - $at < 48} {cut $body $at {8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQ pose.px pose.py pose.pz pose.proll pose.ppitch pose.pyaw
        incr at 48
        return [dict create \
            pose [dict create px ${pose.px} py ${pose.py} pz ${pose.pz} proll ${pose.proll} ppitch ${pose.ppitch} pyaw ${pose.pyaw}]]
    } {
        append out [common::Pose3d.write [dict get $value pose]]
        return $out
    }

    # Calibrated readings. (player_imu_data_calib_t)
    #   accel_x: in m/s^2, frame a_WS_S.
    #   accel_y: in m/s^2, frame a_WS_S.
    #   accel_z: in m/s^2, frame a_WS_S.
    #   gyro_x: in rad/s, frame v_WS_S.
    #   gyro_y: in rad/s, frame v_WS_S.
    #   gyro_z: in rad/s, frame v_WS_S.
    #   magn_x: Magnetic field, in a driver-specific unit (frame n_S).
    #   magn_y: frame n_S.
    #   magn_z: frame n_S.
    struct DataCalib {
        accel_x float32
        accel_y float32
        accel_z float32
        gyro_x float32
        gyro_y float32
        gyro_z float32
        magn_x float32
        magn_y float32
        magn_z float32
    } {
        if {[string length $body] - $at < 36} {cut $body $at {4 4 4 4 4 4 4 4 4}}
        binary scan $body @${at}RRRRRRRRR accel_x accel_y accel_z gyro_x gyro_y gyro_z magn_x magn_y \
            magn_z
        incr at 36
        return [dict create accel_x $accel_x accel_y $accel_y accel_z $accel_z gyro_x $gyro_x \
            gyro_y $gyro_y gyro_z $gyro_z magn_x $magn_x magn_y $magn_y magn_z $magn_z]
    } {
        append out [put float32 [dict get $value accel_x]]
        append out [put float32 [dict get $value accel_y]]
        append out [put float32 [dict get $value accel_z]]
        append out [put float32 [dict get $value gyro_x]]
        append out [put float32 [dict get $value gyro_y]]
        append out [put float32 [dict get $value gyro_z]]
        append out [put float32 [dict get $value magn_x]]
        append out [put float32 [dict get $value magn_y]]
        append out [put float32 [dict get $value magn_z]]
        return $out
    }

    # Calibrated readings and orientation as a quaternion. (player_imu_data_quat_t)
    #   q0: Real part (frame R_WS).
    #   q1: frame R_WS.
    #   q2: frame R_WS.
    #   q3: frame R_WS.
    struct DataQuat {
        calib_data imu.DataCalib
        q0 float32
        q1 float32
        q2 float32
        q3 float32
    } {
        if {[string length $body] - $at < 52} {cut $body $at {4 4 4 4 4 4 4 4 4 4 4 4 4}}
        binary scan $body @${at}RRRRRRRRRRRRR calib_data.accel_x calib_data.accel_y calib_data.accel_z \
            calib_data.gyro_x calib_data.gyro_y calib_data.gyro_z calib_data.magn_x calib_data.magn_y \
            calib_data.magn_z q0 q1 q2 q3
        incr at 52
        return [dict create \
            calib_data [dict create accel_x ${calib_data.accel_x} accel_y ${calib_data.accel_y} accel_z ${calib_data.accel_z} gyro_x ${calib_data.gyro_x} gyro_y ${calib_data.gyro_y} gyro_z ${calib_data.gyro_z} magn_x ${calib_data.magn_x} magn_y ${calib_data.magn_y} magn_z ${calib_data.magn_z}] \
            q0 $q0 q1 $q1 q2 $q2 q3 $q3]
    } {
        append out [DataCalib.write [dict get $value calib_data]]
        append out [put float32 [dict get $value q0]]
        append out [put float32 [dict get $value q1]]
        append out [put float32 [dict get $value q2]]
        append out [put float32 [dict get $value q3]]
        return $out
    }

    # Calibrated readings and orientation as angles. (player_imu_data_euler_t)
    #   orientation: in rad, frame R_WS.
    struct DataEuler {
        calib_data imu.DataCalib
        orientation common.Orientation3d
    } {
        if {[string length $body] - $at < 60} {cut $body $at {4 4 4 4 4 4 4 4 4 8 8 8}}
        binary scan $body @${at}RRRRRRRRRQQQ calib_data.accel_x calib_data.accel_y calib_data.accel_z \
            calib_data.gyro_x calib_data.gyro_y calib_data.gyro_z calib_data.magn_x calib_data.magn_y \
            calib_data.magn_z orientation.proll orientation.ppitch orientation.pyaw
        incr at 60
        return [dict create \
            calib_data [dict create accel_x ${calib_data.accel_x} accel_y ${calib_data.accel_y} accel_z ${calib_data.accel_z} gyro_x ${calib_data.gyro_x} gyro_y ${calib_data.gyro_y} gyro_z ${calib_data.gyro_z} magn_x ${calib_data.magn_x} magn_y ${calib_data.magn_y} magn_z ${calib_data.magn_z}] \
            orientation [dict create proll ${orientation.proll} ppitch ${orientation.ppitch} pyaw ${orientation.pyaw}]]
    } {
        append out [DataCalib.write [dict get $value calib_data]]
        append out [common::Orientation3d.write [dict get $value orientation]]
        return $out
    }

    # Pose, velocity and acceleration. (player_imu_data_fullstate_t)
    #   pose: in m, m, m, rad, rad, rad, frame X_WS.
    #   vel: in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_WS_S.
    #   acc: in m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2, frame a_WS_S.
    struct DataFullstate {
        pose common.Pose3d
        vel common.Pose3d
        acc common.Pose3d
    } {
        if {[string length $body] - $at < 144} {cut $body $at {8 8 8 8 8 8 8 8 8 8 8 8 8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQQQQQQQQQQQQQ pose.px pose.py pose.pz pose.proll pose.ppitch \
            pose.pyaw vel.px vel.py vel.pz vel.proll vel.ppitch vel.pyaw acc.px acc.py acc.pz acc.proll \
            acc.ppitch acc.pyaw
        incr at 144
        return [dict create \
            pose [dict create px ${pose.px} py ${pose.py} pz ${pose.pz} proll ${pose.proll} ppitch ${pose.ppitch} pyaw ${pose.pyaw}] \
            vel [dict create px ${vel.px} py ${vel.py} pz ${vel.pz} proll ${vel.proll} ppitch ${vel.ppitch} pyaw ${vel.pyaw}] \
            acc [dict create px ${acc.px} py ${acc.py} pz ${acc.pz} proll ${acc.proll} ppitch ${acc.ppitch} pyaw ${acc.pyaw}]]
    } {
        append out [common::Pose3d.write [dict get $value pose]]
        append out [common::Pose3d.write [dict get $value vel]]
        append out [common::Pose3d.write [dict get $value acc]]
        return $out
    }

    # Selected data message. (player_imu_datatype_config_t)
    #   value: Its subtype.
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

    # Quantity that becomes the reference. (player_imu_reset_orientation_config_t)
    #   value: 0: heading, 1: orientation, 2: driver-specific.
    struct ResetOrientationConfig {
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

    # A new orientation. (player_imu_reset_euler_config_t)
    #   orientation: Only the angles apply (in m, m, m, rad, rad, rad, frame X_WS).
    struct ResetEulerConfig {
        orientation common.Pose3d
    } {
        if {[string length $body] - $at < 48} {cut $body $at {8 8 8 8 8 8}}
        binary scan $body @${at}QQQQQQ orientation.px orientation.py orientation.pz orientation.proll \
            orientation.ppitch orientation.pyaw
        incr at 48
        return [dict create \
            orientation [dict create px ${orientation.px} py ${orientation.py} pz ${orientation.pz} proll ${orientation.proll} ppitch ${orientation.ppitch} pyaw ${orientation.pyaw}]]
    } {
        append out [common::Pose3d.write [dict get $value orientation]]
        return $out
    }

    # Pose by integration.
    message imu.data.state DATA 1 imu.DataState
    # Calibrated readings.
    message imu.data.calib DATA 2 imu.DataCalib
    # Calibrated readings and orientation as a quaternion.
    message imu.data.quat DATA 3 imu.DataQuat
    # Calibrated readings and orientation as angles.
    message imu.data.euler DATA 4 imu.DataEuler
    # Pose, velocity and acceleration.
    message imu.data.fullstate DATA 5 imu.DataFullstate
    # Selects which data message is sent.
    message imu.req.set_datatype REQ 1 imu.DatatypeConfig
    # Makes the current orientation the reference.
    message imu.req.reset_orientation REQ 2 imu.ResetOrientationConfig
    # Sets the current orientation.
    message imu.req.reset_euler REQ 3 imu.ResetEulerConfig
}
