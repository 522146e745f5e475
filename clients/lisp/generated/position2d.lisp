;;;; Interface position2d, code 4. A robot that moves in the plane: odometry, velocity and position control.
;;;;
;;;; Generated from interfaces/004_position2d.toml by codegen; do not edit.

(cl:defpackage #:playhouse.position2d
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+req-get-geom+ #:+req-motor-power+ #:+req-velocity-mode+ #:+req-position-mode+
           #:+req-set-odom+ #:+req-reset-odom+ #:+req-speed-pid+ #:+req-position-pid+ #:+req-speed-prof+
           #:+data-state+ #:+data-geom+ #:+cmd-vel+ #:+cmd-pos+ #:+cmd-car+ #:+cmd-vel-head+ #:data
           #:cmd-vel #:cmd-pos #:cmd-car #:cmd-vel-head #:geom #:power-config #:velocity-mode-config
           #:position-mode-req #:set-odom-req #:speed-pid-req #:position-pid-req #:speed-prof-req
           #:make-data #:copy-data #:data-p #:data-pos #:data-vel #:data-stall #:make-cmd-vel #:copy-cmd-vel
           #:cmd-vel-p #:cmd-vel-vel #:cmd-vel-state #:make-cmd-pos #:copy-cmd-pos #:cmd-pos-p #:cmd-pos-pos
           #:cmd-pos-vel #:cmd-pos-state #:make-cmd-car #:copy-cmd-car #:cmd-car-p #:cmd-car-velocity
           #:cmd-car-angle #:make-cmd-vel-head #:copy-cmd-vel-head #:cmd-vel-head-p #:cmd-vel-head-velocity
           #:cmd-vel-head-angle #:make-geom #:copy-geom #:geom-p #:geom-pose #:geom-size #:make-power-config
           #:copy-power-config #:power-config-p #:power-config-state #:make-velocity-mode-config
           #:copy-velocity-mode-config #:velocity-mode-config-p #:velocity-mode-config-value
           #:make-position-mode-req #:copy-position-mode-req #:position-mode-req-p #:position-mode-req-state
           #:make-set-odom-req #:copy-set-odom-req #:set-odom-req-p #:set-odom-req-pose #:make-speed-pid-req
           #:copy-speed-pid-req #:speed-pid-req-p #:speed-pid-req-kp #:speed-pid-req-ki #:speed-pid-req-kd
           #:make-position-pid-req #:copy-position-pid-req #:position-pid-req-p #:position-pid-req-kp
           #:position-pid-req-ki #:position-pid-req-kd #:make-speed-prof-req #:copy-speed-prof-req
           #:speed-prof-req-p #:speed-prof-req-speed #:speed-prof-req-acc))

(cl:in-package #:playhouse.position2d)

(define-interface +code+ 4 "position2d")

(define-struct (data "position2d.Data")
  "Odometry. (player_position2d_data_t)"
  ;; Pose from odometry (in m, m, rad, frame X_OR).
  (pos "pos" playhouse.common:pose2d)
  ;; Velocity: forward, to the left, turning left (in m/s, m/s, rad/s, frame v_OR_R).
  (vel "vel" playhouse.common:pose2d)
  ;; 1 if the robot is blocked by an obstacle.
  (stall "stall" :uint8))

(define-struct (cmd-vel "position2d.CmdVel")
  "Commanded velocity. (player_position2d_cmd_vel_t)"
  ;; Forward, to the left, turning left; for a simulated car the last part is its steering angle in rad (in
  ;; m/s, m/s, rad/s, frame v_OR_R).
  (vel "vel" playhouse.common:pose2d)
  ;; 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER.
  (state "state" :uint8))

(define-struct (cmd-pos "position2d.CmdPos")
  "Commanded pose, and the velocity on the way. (player_position2d_cmd_pos_t)"
  ;; Goal (in m, m, rad, frame X_OG).
  (pos "pos" playhouse.common:pose2d)
  ;; Velocity on the way; zero: chosen by the driver. Simulated robots ignore it (in m/s, m/s, rad/s, frame
  ;; v_OR_R).
  (vel "vel" playhouse.common:pose2d)
  ;; 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER.
  (state "state" :uint8))

(define-struct (cmd-car "position2d.CmdCar")
  "Commanded motion of a car. (player_position2d_cmd_car_t)"
  ;; Forward (in m/s).
  (velocity "velocity" :float64)
  ;; Steering angle of the front wheels, positive to the left; a simulated robot without them uses it as turn
  ;; rate in rad/s (in rad).
  (angle "angle" :float64))

(define-struct (cmd-vel-head "position2d.CmdVelHead")
  "Commanded speed and heading. (player_position2d_cmd_vel_head_t)"
  ;; Forward (in m/s).
  (velocity "velocity" :float64)
  ;; Heading in the odometry frame (in rad).
  (angle "angle" :float64))

(define-struct (geom "position2d.Geom")
  "The robot's size and centre of rotation. (player_position2d_geom_t)"
  ;; Centre of the bounding box relative to the centre of rotation (in m, m, m, rad, rad, rad, frame X_RS).
  (pose "pose" playhouse.common:pose3d)
  ;; Bounding box of the robot (in m, m, m).
  (size "size" playhouse.common:bbox3d))

(define-struct (power-config "position2d.PowerConfig")
  "The motors' switch. (player_position2d_power_config_t)"
  ;; 1: on, 0: off.
  (state "state" :uint8))

(define-struct (velocity-mode-config "position2d.VelocityModeConfig")
  "A velocity controller. (player_position2d_velocity_mode_config_t)"
  ;; Driver-specific.
  (value "value" :uint32))

(define-struct (position-mode-req "position2d.PositionModeReq")
  "A control mode. (player_position2d_position_mode_req_t)"
  ;; 0: velocity, 1: position.
  (state "state" :uint32))

(define-struct (set-odom-req "position2d.SetOdomReq")
  "A new odometric pose. (player_position2d_set_odom_req_t)"
  ;; New odometric pose (in m, m, rad, frame X_OR).
  (pose "pose" playhouse.common:pose2d))

(define-struct (speed-pid-req "position2d.SpeedPidReq")
  "Gains of velocity control. (player_position2d_speed_pid_req_t)"
  ;; Proportional.
  (kp "kp" :float32)
  ;; Integral.
  (ki "ki" :float32)
  ;; Derivative.
  (kd "kd" :float32))

(define-struct (position-pid-req "position2d.PositionPidReq")
  "Gains of position control. (player_position2d_position_pid_req_t)"
  ;; Proportional.
  (kp "kp" :float32)
  ;; Integral.
  (ki "ki" :float32)
  ;; Derivative.
  (kd "kd" :float32))

(define-struct (speed-prof-req "position2d.SpeedProfReq")
  "Limits of position control. (player_position2d_speed_prof_req_t)"
  ;; Maximum speed (in m/s).
  (speed "speed" :float32)
  ;; Maximum acceleration (in m/s^2).
  (acc "acc" :float32))

;; Requests the robot's size and centre of rotation.
(define-message +req-get-geom+ 4 :req 1 "position2d.req.get_geom" geom)
;; Switches the motors on or off.
(define-message +req-motor-power+ 4 :req 2 "position2d.req.motor_power" power-config)
;; Selects the driver's velocity controller.
(define-message +req-velocity-mode+ 4 :req 3 "position2d.req.velocity_mode" velocity-mode-config)
;; Selects between velocity and position control.
(define-message +req-position-mode+ 4 :req 4 "position2d.req.position_mode" position-mode-req)
;; Sets the odometric pose.
(define-message +req-set-odom+ 4 :req 5 "position2d.req.set_odom" set-odom-req)
;; Sets the odometric pose to zero.
(define-message +req-reset-odom+ 4 :req 6 "position2d.req.reset_odom")
;; Sets the gains of velocity control.
(define-message +req-speed-pid+ 4 :req 7 "position2d.req.speed_pid" speed-pid-req)
;; Sets the gains of position control.
(define-message +req-position-pid+ 4 :req 8 "position2d.req.position_pid" position-pid-req)
;; Sets the speed and acceleration limits of position control.
(define-message +req-speed-prof+ 4 :req 9 "position2d.req.speed_prof" speed-prof-req)
;; Odometry.
(define-message +data-state+ 4 :data 1 "position2d.data.state" data)
;; The robot's size, sent on change.
(define-message +data-geom+ 4 :data 2 "position2d.data.geom" geom)
;; Commanded velocity.
(define-message +cmd-vel+ 4 :cmd 1 "position2d.cmd.vel" cmd-vel)
;; Commanded pose in the odometry frame.
(define-message +cmd-pos+ 4 :cmd 2 "position2d.cmd.pos" cmd-pos)
;; Commanded speed and steering angle of a car.
(define-message +cmd-car+ 4 :cmd 3 "position2d.cmd.car" cmd-car)
;; Commanded speed and heading.
(define-message +cmd-vel-head+ 4 :cmd 4 "position2d.cmd.vel_head" cmd-vel-head)
