;;;; Interface position3d, code 30. A robot that moves in 3D.
;;;;
;;;; Generated from interfaces/030_position3d.toml by codegen; do not edit.

(cl:defpackage #:playhouse.position3d
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-state+ #:+data-geometry+ #:+cmd-set-vel+ #:+cmd-set-pos+ #:+req-get-geom+
           #:+req-motor-power+ #:+req-velocity-mode+ #:+req-position-mode+ #:+req-reset-odom+
           #:+req-set-odom+ #:+req-speed-pid+ #:+req-position-pid+ #:+req-speed-prof+ #:data #:cmd-pos
           #:cmd-vel #:geom #:power-config #:position-mode-req #:velocity-mode-config #:set-odom-req
           #:speed-pid-req #:position-pid-req #:speed-prof-req #:make-data #:copy-data #:data-p #:data-pos
           #:data-vel #:data-stall #:make-cmd-pos #:copy-cmd-pos #:cmd-pos-p #:cmd-pos-pos #:cmd-pos-vel
           #:cmd-pos-state #:make-cmd-vel #:copy-cmd-vel #:cmd-vel-p #:cmd-vel-vel #:cmd-vel-state
           #:make-geom #:copy-geom #:geom-p #:geom-pose #:geom-size #:make-power-config #:copy-power-config
           #:power-config-p #:power-config-state #:make-position-mode-req #:copy-position-mode-req
           #:position-mode-req-p #:position-mode-req-value #:make-velocity-mode-config
           #:copy-velocity-mode-config #:velocity-mode-config-p #:velocity-mode-config-value
           #:make-set-odom-req #:copy-set-odom-req #:set-odom-req-p #:set-odom-req-pos #:make-speed-pid-req
           #:copy-speed-pid-req #:speed-pid-req-p #:speed-pid-req-kp #:speed-pid-req-ki #:speed-pid-req-kd
           #:make-position-pid-req #:copy-position-pid-req #:position-pid-req-p #:position-pid-req-kp
           #:position-pid-req-ki #:position-pid-req-kd #:make-speed-prof-req #:copy-speed-prof-req
           #:speed-prof-req-p #:speed-prof-req-speed #:speed-prof-req-acc))

(cl:in-package #:playhouse.position3d)

(define-interface +code+ 30 "position3d")

(define-struct (data "position3d.Data")
  "Odometry. (player_position3d_data_t)"
  ;; Pose from odometry (in m, m, m, rad, rad, rad, frame X_OR).
  (pos "pos" playhouse.common:pose3d)
  ;; Velocity along and about x, y and z (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R).
  (vel "vel" playhouse.common:pose3d)
  ;; 1 if the robot is blocked by an obstacle.
  (stall "stall" :uint8))

(define-struct (cmd-pos "position3d.CmdPos")
  "Commanded pose, and the velocity on the way. (player_position3d_cmd_pos_t)"
  ;; Goal (in m, m, m, rad, rad, rad, frame X_OG).
  (pos "pos" playhouse.common:pose3d)
  ;; Velocity on the way; zero: chosen by the driver (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R).
  (vel "vel" playhouse.common:pose3d)
  ;; 1: motors on, 0: off.
  (state "state" :uint8))

(define-struct (cmd-vel "position3d.CmdVel")
  "Commanded velocity. (player_position3d_cmd_vel_t)"
  ;; Along and about x, y and z (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R).
  (vel "vel" playhouse.common:pose3d)
  ;; 1: motors on, 0: off.
  (state "state" :uint8))

(define-struct (geom "position3d.Geom")
  "The robot's size and centre of rotation. (player_position3d_geom_t)"
  ;; Centre of the bounding box relative to the centre of rotation (in m, m, m, rad, rad, rad, frame X_RS).
  (pose "pose" playhouse.common:pose3d)
  ;; Bounding box of the robot (in m, m, m).
  (size "size" playhouse.common:bbox3d))

(define-struct (power-config "position3d.PowerConfig")
  "The motors' switch. (player_position3d_power_config_t)"
  ;; 1: on, 0: off.
  (state "state" :uint8))

(define-struct (position-mode-req "position3d.PositionModeReq")
  "A control mode. (player_position3d_position_mode_req_t)"
  ;; 0: velocity, 1: position.
  (value "value" :uint32))

(define-struct (velocity-mode-config "position3d.VelocityModeConfig")
  "A velocity controller. (player_position3d_velocity_mode_config_t)"
  ;; Driver-specific.
  (value "value" :uint32))

(define-struct (set-odom-req "position3d.SetOdomReq")
  "A new odometric pose. (player_position3d_set_odom_req_t)"
  ;; New odometric pose (in m, m, m, rad, rad, rad, frame X_OR).
  (pos "pos" playhouse.common:pose3d))

(define-struct (speed-pid-req "position3d.SpeedPidReq")
  "Gains of velocity control. (player_position3d_speed_pid_req_t)"
  ;; Proportional.
  (kp "kp" :float32)
  ;; Integral.
  (ki "ki" :float32)
  ;; Derivative.
  (kd "kd" :float32))

(define-struct (position-pid-req "position3d.PositionPidReq")
  "Gains of position control. (player_position3d_position_pid_req_t)"
  ;; Proportional.
  (kp "kp" :float32)
  ;; Integral.
  (ki "ki" :float32)
  ;; Derivative.
  (kd "kd" :float32))

(define-struct (speed-prof-req "position3d.SpeedProfReq")
  "Limits of position control. (player_position3d_speed_prof_req_t)"
  ;; Maximum turn rate (in rad/s).
  (speed "speed" :float32)
  ;; Maximum angular acceleration (in rad/s^2).
  (acc "acc" :float32))

;; Odometry.
(define-message +data-state+ 30 :data 1 "position3d.data.state" data)
;; The robot's size, sent on change.
(define-message +data-geometry+ 30 :data 2 "position3d.data.geometry" geom)
;; Commanded velocity.
(define-message +cmd-set-vel+ 30 :cmd 1 "position3d.cmd.set_vel" cmd-vel)
;; Commanded pose in the odometry frame.
(define-message +cmd-set-pos+ 30 :cmd 2 "position3d.cmd.set_pos" cmd-pos)
;; Requests the robot's size and centre of rotation.
(define-message +req-get-geom+ 30 :req 1 "position3d.req.get_geom" geom)
;; Switches the motors on or off.
(define-message +req-motor-power+ 30 :req 2 "position3d.req.motor_power" power-config)
;; Selects the driver's velocity controller.
(define-message +req-velocity-mode+ 30 :req 3 "position3d.req.velocity_mode" velocity-mode-config)
;; Selects between velocity and position control.
(define-message +req-position-mode+ 30 :req 4 "position3d.req.position_mode" position-mode-req)
;; Sets the odometric pose to zero.
(define-message +req-reset-odom+ 30 :req 5 "position3d.req.reset_odom")
;; Sets the odometric pose.
(define-message +req-set-odom+ 30 :req 6 "position3d.req.set_odom" set-odom-req)
;; Sets the gains of velocity control.
(define-message +req-speed-pid+ 30 :req 7 "position3d.req.speed_pid" speed-pid-req)
;; Sets the gains of position control.
(define-message +req-position-pid+ 30 :req 8 "position3d.req.position_pid" position-pid-req)
;; Sets the turn rate and angular acceleration limits of position control.
(define-message +req-speed-prof+ 30 :req 9 "position3d.req.speed_prof" speed-prof-req)
