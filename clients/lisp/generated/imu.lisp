;;;; Interface imu, code 60. Accelerations, turn rates, magnetic field and orientation.
;;;;
;;;; Generated from interfaces/060_imu.toml by codegen; do not edit.

(cl:defpackage #:playhouse.imu
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-state+ #:+data-calib+ #:+data-quat+ #:+data-euler+ #:+data-fullstate+
           #:+req-set-datatype+ #:+req-reset-orientation+ #:+req-reset-euler+ #:data-state #:data-calib
           #:data-quat #:data-euler #:data-fullstate #:datatype-config #:reset-orientation-config
           #:reset-euler-config #:make-data-state #:copy-data-state #:data-state-p #:data-state-pose
           #:make-data-calib #:copy-data-calib #:data-calib-p #:data-calib-accel-x #:data-calib-accel-y
           #:data-calib-accel-z #:data-calib-gyro-x #:data-calib-gyro-y #:data-calib-gyro-z
           #:data-calib-magn-x #:data-calib-magn-y #:data-calib-magn-z #:make-data-quat #:copy-data-quat
           #:data-quat-p #:data-quat-calib-data #:data-quat-q0 #:data-quat-q1 #:data-quat-q2 #:data-quat-q3
           #:make-data-euler #:copy-data-euler #:data-euler-p #:data-euler-calib-data
           #:data-euler-orientation #:make-data-fullstate #:copy-data-fullstate #:data-fullstate-p
           #:data-fullstate-pose #:data-fullstate-vel #:data-fullstate-acc #:make-datatype-config
           #:copy-datatype-config #:datatype-config-p #:datatype-config-value
           #:make-reset-orientation-config #:copy-reset-orientation-config #:reset-orientation-config-p
           #:reset-orientation-config-value #:make-reset-euler-config #:copy-reset-euler-config
           #:reset-euler-config-p #:reset-euler-config-orientation))

(cl:in-package #:playhouse.imu)

(define-interface +code+ 60 "imu")

(define-struct (data-state "imu.DataState")
  "Pose by integration. (player_imu_data_state_t)"
  ;; In m, m, m, rad, rad, rad, frame X_WS.
  (pose "pose" playhouse.common:pose3d))

(define-struct (data-calib "imu.DataCalib")
  "Calibrated readings. (player_imu_data_calib_t)"
  ;; In m/s^2, frame a_WS_S.
  (accel-x "accel_x" :float32)
  ;; In m/s^2, frame a_WS_S.
  (accel-y "accel_y" :float32)
  ;; In m/s^2, frame a_WS_S.
  (accel-z "accel_z" :float32)
  ;; In rad/s, frame v_WS_S.
  (gyro-x "gyro_x" :float32)
  ;; In rad/s, frame v_WS_S.
  (gyro-y "gyro_y" :float32)
  ;; In rad/s, frame v_WS_S.
  (gyro-z "gyro_z" :float32)
  ;; Magnetic field, in a driver-specific unit (frame n_S).
  (magn-x "magn_x" :float32)
  ;; Frame n_S.
  (magn-y "magn_y" :float32)
  ;; Frame n_S.
  (magn-z "magn_z" :float32))

(define-struct (data-quat "imu.DataQuat")
  "Calibrated readings and orientation as a quaternion. (player_imu_data_quat_t)"
  (calib-data "calib_data" data-calib)
  ;; Real part (frame R_WS).
  (q0 "q0" :float32)
  ;; Frame R_WS.
  (q1 "q1" :float32)
  ;; Frame R_WS.
  (q2 "q2" :float32)
  ;; Frame R_WS.
  (q3 "q3" :float32))

(define-struct (data-euler "imu.DataEuler")
  "Calibrated readings and orientation as angles. (player_imu_data_euler_t)"
  (calib-data "calib_data" data-calib)
  ;; In rad, frame R_WS.
  (orientation "orientation" playhouse.common:orientation3d))

(define-struct (data-fullstate "imu.DataFullstate")
  "Pose, velocity and acceleration. (player_imu_data_fullstate_t)"
  ;; In m, m, m, rad, rad, rad, frame X_WS.
  (pose "pose" playhouse.common:pose3d)
  ;; In m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_WS_S.
  (vel "vel" playhouse.common:pose3d)
  ;; In m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2, frame a_WS_S.
  (acc "acc" playhouse.common:pose3d))

(define-struct (datatype-config "imu.DatatypeConfig")
  "Selected data message. (player_imu_datatype_config_t)"
  ;; Its subtype.
  (value "value" :uint8))

(define-struct (reset-orientation-config "imu.ResetOrientationConfig")
  "Quantity that becomes the reference. (player_imu_reset_orientation_config_t)"
  ;; 0: heading, 1: orientation, 2: driver-specific.
  (value "value" :uint32))

(define-struct (reset-euler-config "imu.ResetEulerConfig")
  "A new orientation. (player_imu_reset_euler_config_t)"
  ;; Only the angles apply (in m, m, m, rad, rad, rad, frame X_WS).
  (orientation "orientation" playhouse.common:pose3d))

;; Pose by integration.
(define-message +data-state+ 60 :data 1 "imu.data.state" data-state)
;; Calibrated readings.
(define-message +data-calib+ 60 :data 2 "imu.data.calib" data-calib)
;; Calibrated readings and orientation as a quaternion.
(define-message +data-quat+ 60 :data 3 "imu.data.quat" data-quat)
;; Calibrated readings and orientation as angles.
(define-message +data-euler+ 60 :data 4 "imu.data.euler" data-euler)
;; Pose, velocity and acceleration.
(define-message +data-fullstate+ 60 :data 5 "imu.data.fullstate" data-fullstate)
;; Selects which data message is sent.
(define-message +req-set-datatype+ 60 :req 1 "imu.req.set_datatype" datatype-config)
;; Makes the current orientation the reference.
(define-message +req-reset-orientation+ 60 :req 2 "imu.req.reset_orientation" reset-orientation-config)
;; Sets the current orientation.
(define-message +req-reset-euler+ 60 :req 3 "imu.req.reset_euler" reset-euler-config)
