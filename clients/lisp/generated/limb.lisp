;;;; Interface limb, code 54. An arm controlled by the pose of its end effector.
;;;;
;;;; Generated from interfaces/054_limb.toml by codegen; do not edit.

(cl:defpackage #:playhouse.limb
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+state-idle+ #:+state-braked+ #:+state-moving+ #:+state-oor+ #:+state-coll+
           #:+data-state+ #:+cmd-home+ #:+cmd-stop+ #:+cmd-setpose+ #:+cmd-setposition+ #:+cmd-vecmove+
           #:+req-power+ #:+req-brakes+ #:+req-geom+ #:+req-speed+ #:data #:setpose-cmd #:setposition-cmd
           #:vecmove-cmd #:power-req #:brakes-req #:geom-req #:speed-req #:make-data #:copy-data #:data-p
           #:data-position #:data-approach #:data-orientation #:data-state #:make-setpose-cmd
           #:copy-setpose-cmd #:setpose-cmd-p #:setpose-cmd-position #:setpose-cmd-approach
           #:setpose-cmd-orientation #:make-setposition-cmd #:copy-setposition-cmd #:setposition-cmd-p
           #:setposition-cmd-position #:make-vecmove-cmd #:copy-vecmove-cmd #:vecmove-cmd-p
           #:vecmove-cmd-direction #:vecmove-cmd-length #:make-power-req #:copy-power-req #:power-req-p
           #:power-req-value #:make-brakes-req #:copy-brakes-req #:brakes-req-p #:brakes-req-value
           #:make-geom-req #:copy-geom-req #:geom-req-p #:geom-req-base-pos #:make-speed-req
           #:copy-speed-req #:speed-req-p #:speed-req-speed))

(cl:in-package #:playhouse.limb)

(define-interface +code+ 54 "limb")

;;; Values of Data.state.
(define-constants
  (+state-idle+ 1)
  (+state-braked+ 2)
  (+state-moving+ 3)
  (+state-oor+ 4)
  (+state-coll+ 5))

(define-struct (data "limb.Data")
  "Pose of the end effector. (player_limb_data_t)"
  ;; In m, frame p_BE.
  (position "position" playhouse.common:point3d)
  ;; Approach direction, a unit vector (frame n_B).
  (approach "approach" playhouse.common:point3d)
  ;; Unit vector across the end effector (frame n_B).
  (orientation "orientation" playhouse.common:point3d)
  ;; Idle, braked, moving, out of reach or in contact.
  (state "state" :uint8))

(define-struct (setpose-cmd "limb.SetposeCmd")
  "Commanded pose of the end effector. (player_limb_setpose_cmd_t)"
  ;; In m, frame p_BE.
  (position "position" playhouse.common:point3d)
  ;; Commanded approach direction, a unit vector (frame n_B).
  (approach "approach" playhouse.common:point3d)
  ;; Unit vector across the end effector (frame n_B).
  (orientation "orientation" playhouse.common:point3d))

(define-struct (setposition-cmd "limb.SetpositionCmd")
  "Commanded position of the end effector. (player_limb_setposition_cmd_t)"
  ;; In m, frame p_BE.
  (position "position" playhouse.common:point3d))

(define-struct (vecmove-cmd "limb.VecmoveCmd")
  "A straight motion of the end effector. (player_limb_vecmove_cmd_t)"
  ;; Unit vector of the motion (frame n_B).
  (direction "direction" playhouse.common:point3d)
  ;; Distance (in m).
  (length "length" :float32))

(define-struct (power-req "limb.PowerReq")
  "The motors' switch. (player_limb_power_req_t)"
  ;; 1: on, 0: off.
  (value "value" :uint8))

(define-struct (brakes-req "limb.BrakesReq")
  "The brakes' switch. (player_limb_brakes_req_t)"
  ;; 1: braked, 0: released.
  (value "value" :uint8))

(define-struct (geom-req "limb.GeomReq")
  "Pose of the arm's base. (player_limb_geom_req_t)"
  ;; Of the arm's base on the robot (in m, frame p_RB).
  (base-pos "basePos" playhouse.common:point3d))

(define-struct (speed-req "limb.SpeedReq")
  "Speed of the end effector. (player_limb_speed_req_t)"
  ;; Maximum speed of the end effector (in m/s).
  (speed "speed" :float32))

;; Pose of the end effector.
(define-message +data-state+ 54 :data 1 "limb.data.state" data)
;; Moves the arm to its home position.
(define-message +cmd-home+ 54 :cmd 1 "limb.cmd.home")
;; Stops the arm at its current position.
(define-message +cmd-stop+ 54 :cmd 2 "limb.cmd.stop")
;; Moves the end effector to a pose.
(define-message +cmd-setpose+ 54 :cmd 3 "limb.cmd.setpose" setpose-cmd)
;; Moves the end effector to a position, in any orientation.
(define-message +cmd-setposition+ 54 :cmd 4 "limb.cmd.setposition" setposition-cmd)
;; Moves the end effector along a line from its current position.
(define-message +cmd-vecmove+ 54 :cmd 5 "limb.cmd.vecmove" vecmove-cmd)
;; Switches the motors on or off.
(define-message +req-power+ 54 :req 1 "limb.req.power" power-req)
;; Sets or releases the brakes.
(define-message +req-brakes+ 54 :req 2 "limb.req.brakes" brakes-req)
;; Requests the pose of the arm's base on the robot.
(define-message +req-geom+ 54 :req 3 "limb.req.geom" geom-req)
;; Sets the speed of the end effector.
(define-message +req-speed+ 54 :req 4 "limb.req.speed" speed-req)
