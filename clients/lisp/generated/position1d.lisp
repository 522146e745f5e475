;;;; Interface position1d, code 52. A single prismatic or revolute actuator.
;;;;
;;;; Generated from interfaces/052_position1d.toml by codegen; do not edit.

(cl:defpackage #:playhouse.position1d
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+status-limit-min+ #:+status-limit-cen+ #:+status-limit-max+ #:+status-oc+
           #:+status-traj-complete+ #:+status-enabled+ #:+req-get-geom+ #:+req-motor-power+
           #:+req-velocity-mode+ #:+req-position-mode+ #:+req-set-odom+ #:+req-reset-odom+ #:+req-speed-pid+
           #:+req-position-pid+ #:+req-speed-prof+ #:+data-state+ #:+data-geom+ #:+cmd-vel+ #:+cmd-pos+
           #:data #:cmd-vel #:cmd-pos #:geom #:power-config #:velocity-mode-config #:reset-odom-config
           #:position-mode-req #:set-odom-req #:speed-pid-req #:position-pid-req #:speed-prof-req
           #:make-data #:copy-data #:data-p #:data-pos #:data-vel #:data-stall #:data-status #:make-cmd-vel
           #:copy-cmd-vel #:cmd-vel-p #:cmd-vel-vel #:cmd-vel-state #:make-cmd-pos #:copy-cmd-pos
           #:cmd-pos-p #:cmd-pos-pos #:cmd-pos-vel #:cmd-pos-state #:make-geom #:copy-geom #:geom-p
           #:geom-pose #:geom-size #:make-power-config #:copy-power-config #:power-config-p
           #:power-config-state #:make-velocity-mode-config #:copy-velocity-mode-config
           #:velocity-mode-config-p #:velocity-mode-config-value #:make-reset-odom-config
           #:copy-reset-odom-config #:reset-odom-config-p #:reset-odom-config-value #:make-position-mode-req
           #:copy-position-mode-req #:position-mode-req-p #:position-mode-req-state #:make-set-odom-req
           #:copy-set-odom-req #:set-odom-req-p #:set-odom-req-pos #:make-speed-pid-req #:copy-speed-pid-req
           #:speed-pid-req-p #:speed-pid-req-kp #:speed-pid-req-ki #:speed-pid-req-kd
           #:make-position-pid-req #:copy-position-pid-req #:position-pid-req-p #:position-pid-req-kp
           #:position-pid-req-ki #:position-pid-req-kd #:make-speed-prof-req #:copy-speed-prof-req
           #:speed-prof-req-p #:speed-prof-req-speed #:speed-prof-req-acc))

(cl:in-package #:playhouse.position1d)

(define-interface +code+ 52 "position1d")

;;; Bits of Data.status, by number.
(define-constants
  (+status-limit-min+ 0)
  (+status-limit-cen+ 1)
  (+status-limit-max+ 2)
  (+status-oc+ 3)
  (+status-traj-complete+ 4)
  (+status-enabled+ 5))

(define-struct (data "position1d.Data")
  "Position of the actuator. (player_position1d_data_t)"
  ;; From its zero (in m or rad).
  (pos "pos" :float32)
  ;; In m/s or rad/s.
  (vel "vel" :float32)
  ;; 1 if it is blocked by an obstacle.
  (stall "stall" :uint8)
  ;; Limits, current, motion and power, one bit each.
  (status "status" :uint8))

(define-struct (cmd-vel "position1d.CmdVel")
  "Commanded velocity. (player_position1d_cmd_vel_t)"
  ;; In m/s or rad/s.
  (vel "vel" :float32)
  ;; 1: motor on, 0: off.
  (state "state" :uint8))

(define-struct (cmd-pos "position1d.CmdPos")
  "Commanded position. (player_position1d_cmd_pos_t)"
  ;; From its zero (in m or rad).
  (pos "pos" :float32)
  ;; Velocity on the way; zero: chosen by the driver (in m/s or rad/s).
  (vel "vel" :float32)
  ;; 1: motor on, 0: off.
  (state "state" :uint8))

(define-struct (geom "position1d.Geom")
  "Size and pose. (player_position1d_geom_t)"
  ;; Pose of the actuator on the robot (in m, m, m, rad, rad, rad, frame X_RS).
  (pose "pose" playhouse.common:pose3d)
  ;; Bounding box of the actuator (in m, m, m).
  (size "size" playhouse.common:bbox3d))

(define-struct (power-config "position1d.PowerConfig")
  "The motor's switch. (player_position1d_power_config_t)"
  ;; 1: on, 0: off.
  (state "state" :uint8))

(define-struct (velocity-mode-config "position1d.VelocityModeConfig")
  "A velocity controller. (player_position1d_velocity_mode_config_t)"
  ;; Driver-specific.
  (value "value" :uint32))

(define-struct (reset-odom-config "position1d.ResetOdomConfig")
  "Request to set the current position to zero. (player_position1d_reset_odom_config_t)"
  ;; Without meaning.
  (value "value" :uint32))

(define-struct (position-mode-req "position1d.PositionModeReq")
  "A control mode. (player_position1d_position_mode_req_t)"
  ;; 0: velocity, 1: position.
  (state "state" :uint32))

(define-struct (set-odom-req "position1d.SetOdomReq")
  "New value of the current position. (player_position1d_set_odom_req_t)"
  ;; New value of the current position (in m or rad).
  (pos "pos" :float32))

(define-struct (speed-pid-req "position1d.SpeedPidReq")
  "Gains of velocity control. (player_position1d_speed_pid_req_t)"
  ;; Proportional.
  (kp "kp" :float32)
  ;; Integral.
  (ki "ki" :float32)
  ;; Derivative.
  (kd "kd" :float32))

(define-struct (position-pid-req "position1d.PositionPidReq")
  "Gains of position control. (player_position1d_position_pid_req_t)"
  ;; Proportional.
  (kp "kp" :float32)
  ;; Integral.
  (ki "ki" :float32)
  ;; Derivative.
  (kd "kd" :float32))

(define-struct (speed-prof-req "position1d.SpeedProfReq")
  "Limits of position control. (player_position1d_speed_prof_req_t)"
  ;; Maximum speed (in m/s or rad/s).
  (speed "speed" :float32)
  ;; Maximum acceleration (in m/s^2 or rad/s^2).
  (acc "acc" :float32))

;; Requests size and pose.
(define-message +req-get-geom+ 52 :req 1 "position1d.req.get_geom" geom)
;; Switches the motor on or off.
(define-message +req-motor-power+ 52 :req 2 "position1d.req.motor_power" power-config)
;; Selects the driver's velocity controller.
(define-message +req-velocity-mode+ 52 :req 3 "position1d.req.velocity_mode" velocity-mode-config)
;; Selects between velocity and position control.
(define-message +req-position-mode+ 52 :req 4 "position1d.req.position_mode" position-mode-req)
;; Sets the reference of the position.
(define-message +req-set-odom+ 52 :req 5 "position1d.req.set_odom" set-odom-req)
;; Sets the current position to zero.
(define-message +req-reset-odom+ 52 :req 6 "position1d.req.reset_odom" reset-odom-config)
;; Sets the gains of velocity control.
(define-message +req-speed-pid+ 52 :req 7 "position1d.req.speed_pid" speed-pid-req)
;; Sets the gains of position control.
(define-message +req-position-pid+ 52 :req 8 "position1d.req.position_pid" position-pid-req)
;; Sets the speed and acceleration limits of position control.
(define-message +req-speed-prof+ 52 :req 9 "position1d.req.speed_prof" speed-prof-req)
;; Position of the actuator.
(define-message +data-state+ 52 :data 1 "position1d.data.state" data)
;; Size and pose, sent on change.
(define-message +data-geom+ 52 :data 2 "position1d.data.geom" geom)
;; Commanded velocity.
(define-message +cmd-vel+ 52 :cmd 1 "position1d.cmd.vel" cmd-vel)
;; Commanded position.
(define-message +cmd-pos+ 52 :cmd 2 "position1d.cmd.pos" cmd-pos)
