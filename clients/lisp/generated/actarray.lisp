;;;; Interface actarray, code 53. A chain of prismatic or revolute joints, such as an arm.
;;;;
;;;; Generated from interfaces/053_actarray.toml by codegen; do not edit.

(cl:defpackage #:playhouse.actarray
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+actstate-idle+ #:+actstate-moving+ #:+actstate-braked+ #:+actstate-stalled+
           #:+type-linear+ #:+type-rotary+ #:+req-power+ #:+req-brakes+ #:+req-get-geom+ #:+req-speed+
           #:+req-accel+ #:+cmd-pos+ #:+cmd-multi-pos+ #:+cmd-speed+ #:+cmd-multi-speed+ #:+cmd-home+
           #:+cmd-current+ #:+cmd-multi-current+ #:+data-state+ #:actuator #:data #:actuatorgeom #:geom
           #:position-cmd #:multi-position-cmd #:speed-cmd #:multi-speed-cmd #:home-cmd #:current-cmd
           #:multi-current-cmd #:power-config #:brakes-config #:speed-config #:accel-config #:make-actuator
           #:copy-actuator #:actuator-p #:actuator-position #:actuator-speed #:actuator-acceleration
           #:actuator-current #:actuator-state #:make-data #:copy-data #:data-p #:data-actuators
           #:data-motor-state #:make-actuatorgeom #:copy-actuatorgeom #:actuatorgeom-p #:actuatorgeom-type
           #:actuatorgeom-length #:actuatorgeom-orientation #:actuatorgeom-axis #:actuatorgeom-min
           #:actuatorgeom-centre #:actuatorgeom-max #:actuatorgeom-home #:actuatorgeom-config-speed
           #:actuatorgeom-hasbrakes #:make-geom #:copy-geom #:geom-p #:geom-actuators #:geom-base-pos
           #:geom-base-orientation #:make-position-cmd #:copy-position-cmd #:position-cmd-p
           #:position-cmd-joint #:position-cmd-position #:make-multi-position-cmd #:copy-multi-position-cmd
           #:multi-position-cmd-p #:multi-position-cmd-positions #:make-speed-cmd #:copy-speed-cmd
           #:speed-cmd-p #:speed-cmd-joint #:speed-cmd-speed #:make-multi-speed-cmd #:copy-multi-speed-cmd
           #:multi-speed-cmd-p #:multi-speed-cmd-speeds #:make-home-cmd #:copy-home-cmd #:home-cmd-p
           #:home-cmd-joint #:make-current-cmd #:copy-current-cmd #:current-cmd-p #:current-cmd-joint
           #:current-cmd-current #:make-multi-current-cmd #:copy-multi-current-cmd #:multi-current-cmd-p
           #:multi-current-cmd-currents #:make-power-config #:copy-power-config #:power-config-p
           #:power-config-value #:make-brakes-config #:copy-brakes-config #:brakes-config-p
           #:brakes-config-value #:make-speed-config #:copy-speed-config #:speed-config-p
           #:speed-config-joint #:speed-config-speed #:make-accel-config #:copy-accel-config
           #:accel-config-p #:accel-config-joint #:accel-config-accel))

(cl:in-package #:playhouse.actarray)

(define-interface +code+ 53 "actarray")

;;; Values of Actuator.state.
(define-constants
  (+actstate-idle+ 1)
  (+actstate-moving+ 2)
  (+actstate-braked+ 4)
  (+actstate-stalled+ 8))

;;; Values of Actuatorgeom.type.
(define-constants
  (+type-linear+ 1)
  (+type-rotary+ 2))

(define-struct (actuator "actarray.Actuator")
  "State of one joint. (player_actarray_actuator_t)"
  ;; In m or rad.
  (position "position" :float32)
  ;; In m/s or rad/s.
  (speed "speed" :float32)
  ;; In m/s^2 or rad/s^2.
  (acceleration "acceleration" :float32)
  ;; Of its motor; -1 if unknown (in A).
  (current "current" :float32)
  ;; Idle, moving, braked or stalled.
  (state "state" :uint8))

(define-struct (data "actarray.Data")
  "State of each joint. (player_actarray_data_t)"
  (actuators "actuators" (:counted actuator 1677719 20))
  ;; 1: motors on, 0: off.
  (motor-state "motor_state" :uint8))

(define-struct (actuatorgeom "actarray.Actuatorgeom")
  "Description of a joint. (player_actarray_actuatorgeom_t)"
  ;; Prismatic or revolute.
  (type "type" :uint8)
  ;; To the next joint (in m).
  (length "length" :float32)
  ;; Orientation of the joint at rest, relative to the previous joint (in rad, rad, rad, frame R_BJ).
  (orientation "orientation" playhouse.common:orientation3d)
  ;; Unit vector of the axis of translation or rotation (frame n_J).
  (axis "axis" playhouse.common:point3d)
  ;; Lowest position (in m or rad).
  (min "min" :float32)
  ;; Centre position (in m or rad).
  (centre "centre" :float32)
  ;; Highest position (in m or rad).
  (max "max" :float32)
  ;; Position after CMD HOME (in m or rad).
  (home "home" :float32)
  ;; Speed in position control (in m/s or rad/s).
  (config-speed "config_speed" :float32)
  ;; 1 if it has brakes.
  (hasbrakes "hasbrakes" :uint8))

(define-struct (geom "actarray.Geom")
  "Joints and base pose of the chain. (player_actarray_geom_t)"
  (actuators "actuators" (:counted actuatorgeom 419429 80))
  ;; Position of the base of the chain on the robot (in m, frame p_RB).
  (base-pos "base_pos" playhouse.common:point3d)
  ;; Orientation of the base of the chain on the robot (in rad, frame R_RB).
  (base-orientation "base_orientation" playhouse.common:orientation3d))

(define-struct (position-cmd "actarray.PositionCmd")
  "Commanded position of one joint. (player_actarray_position_cmd_t)"
  ;; Index of the joint, from 0.
  (joint "joint" :int32)
  ;; In m or rad.
  (position "position" :float32))

(define-struct (multi-position-cmd "actarray.MultiPositionCmd")
  "Commanded positions of all joints. (player_actarray_multi_position_cmd_t)"
  ;; In m or rad.
  (positions "positions" (:counted :float32 8388598)))

(define-struct (speed-cmd "actarray.SpeedCmd")
  "Commanded speed of one joint. (player_actarray_speed_cmd_t)"
  ;; Index of the joint, from 0.
  (joint "joint" :int32)
  ;; In m/s or rad/s.
  (speed "speed" :float32))

(define-struct (multi-speed-cmd "actarray.MultiSpeedCmd")
  "Commanded speeds of all joints. (player_actarray_multi_speed_cmd_t)"
  ;; In m/s or rad/s.
  (speeds "speeds" (:counted :float32 8388598)))

(define-struct (home-cmd "actarray.HomeCmd")
  "A joint to move to its home position. (player_actarray_home_cmd_t)"
  ;; Index of the joint; -1: all.
  (joint "joint" :int32))

(define-struct (current-cmd "actarray.CurrentCmd")
  "Commanded current of one joint. (player_actarray_current_cmd_t)"
  ;; Index of the joint, from 0.
  (joint "joint" :int32)
  ;; In A.
  (current "current" :float32))

(define-struct (multi-current-cmd "actarray.MultiCurrentCmd")
  "Commanded currents of all joints. (player_actarray_multi_current_cmd_t)"
  ;; In A.
  (currents "currents" (:counted :float32 8388598)))

(define-struct (power-config "actarray.PowerConfig")
  "The motors' switch. (player_actarray_power_config_t)"
  ;; 1: on, 0: off.
  (value "value" :uint8))

(define-struct (brakes-config "actarray.BrakesConfig")
  "The brakes' switch. (player_actarray_brakes_config_t)"
  ;; 1: braked, 0: released.
  (value "value" :uint8))

(define-struct (speed-config "actarray.SpeedConfig")
  "Speed of one joint. (player_actarray_speed_config_t)"
  ;; Index of the joint; -1: all.
  (joint "joint" :int32)
  ;; In m/s or rad/s.
  (speed "speed" :float32))

(define-struct (accel-config "actarray.AccelConfig")
  "Acceleration of one joint. (player_actarray_accel_config_t)"
  ;; Index of the joint; -1: all.
  (joint "joint" :int32)
  ;; In m/s^2 or rad/s^2.
  (accel "accel" :float32))

;; Switches the motors on or off.
(define-message +req-power+ 53 :req 1 "actarray.req.power" power-config)
;; Sets or releases the brakes.
(define-message +req-brakes+ 53 :req 2 "actarray.req.brakes" brakes-config)
;; Requests the joints and the base pose of the chain.
(define-message +req-get-geom+ 53 :req 3 "actarray.req.get_geom" geom)
;; Sets a joint's speed in position control.
(define-message +req-speed+ 53 :req 4 "actarray.req.speed" speed-config)
;; Sets a joint's acceleration in position control.
(define-message +req-accel+ 53 :req 5 "actarray.req.accel" accel-config)
;; Commanded position of one joint.
(define-message +cmd-pos+ 53 :cmd 1 "actarray.cmd.pos" position-cmd)
;; Commanded positions of all joints.
(define-message +cmd-multi-pos+ 53 :cmd 2 "actarray.cmd.multi_pos" multi-position-cmd)
;; Commanded speed of one joint.
(define-message +cmd-speed+ 53 :cmd 3 "actarray.cmd.speed" speed-cmd)
;; Commanded speeds of all joints.
(define-message +cmd-multi-speed+ 53 :cmd 4 "actarray.cmd.multi_speed" multi-speed-cmd)
;; Moves one joint, or all, to the home position.
(define-message +cmd-home+ 53 :cmd 5 "actarray.cmd.home" home-cmd)
;; Commanded current of one joint.
(define-message +cmd-current+ 53 :cmd 6 "actarray.cmd.current" current-cmd)
;; Commanded currents of all joints.
(define-message +cmd-multi-current+ 53 :cmd 7 "actarray.cmd.multi_current" multi-current-cmd)
;; State of each joint.
(define-message +data-state+ 53 :data 1 "actarray.data.state" data)
