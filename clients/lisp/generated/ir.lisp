;;;; Interface ir, code 22. An array of infrared range finders. New drivers use the ranger interface.
;;;;
;;;; Generated from interfaces/022_ir.toml by codegen; do not edit.

(cl:defpackage #:playhouse.ir
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+req-pose+ #:+req-power+ #:+data-ranges+ #:data #:pose #:power-req #:make-data
           #:copy-data #:data-p #:data-voltages #:data-ranges #:make-pose #:copy-pose #:pose-p #:pose-poses
           #:make-power-req #:copy-power-req #:power-req-p #:power-req-state))

(cl:in-package #:playhouse.ir)

(define-interface +code+ 22 "ir")

(define-struct (data "ir.Data")
  "Measurements of the sensors. (player_ir_data_t)"
  ;; One per sensor, as measured (in V).
  (voltages "voltages" (:counted :float32 8388598))
  ;; One per sensor, computed from the voltage (in m).
  (ranges "ranges" (:counted :float32 8388598)))

(define-struct (pose "ir.Pose")
  "Poses of the sensors. (player_ir_pose_t)"
  ;; One per sensor; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS).
  (poses "poses" (:counted playhouse.common:pose3d 699049 48)))

(define-struct (power-req "ir.PowerReq")
  "The sensors' switch. (player_ir_power_req_t)"
  ;; 1: on, 0: off.
  (state "state" :uint8))

;; Requests the poses of the sensors.
(define-message +req-pose+ 22 :req 1 "ir.req.pose" pose)
;; Switches the sensors on or off.
(define-message +req-power+ 22 :req 2 "ir.req.power" power-req)
;; Voltages and ranges.
(define-message +data-ranges+ 22 :data 1 "ir.data.ranges" data)
