;;;; Interface gripper, code 3. A two-finger gripper, with break beams between the fingers and optionally a
;;;; store for objects.
;;;;
;;;; Generated from interfaces/003_gripper.toml by codegen; do not edit.

(cl:defpackage #:playhouse.gripper
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+state-open+ #:+state-closed+ #:+state-moving+ #:+state-error+ #:+data-state+
           #:+req-get-geom+ #:+cmd-open+ #:+cmd-close+ #:+cmd-stop+ #:+cmd-store+ #:+cmd-retrieve+ #:data
           #:geom #:make-data #:copy-data #:data-p #:data-state #:data-beams #:data-stored #:make-geom
           #:copy-geom #:geom-p #:geom-pose #:geom-outer-size #:geom-inner-size #:geom-num-beams
           #:geom-capacity))

(cl:in-package #:playhouse.gripper)

(define-interface +code+ 3 "gripper")

;;; Values of Data.state.
(define-constants
  (+state-open+ 1)
  (+state-closed+ 2)
  (+state-moving+ 3)
  (+state-error+ 4))

(define-struct (data "gripper.Data")
  "State of the fingers and of the break beams. (player_gripper_data_t)"
  ;; Open, closed, moving or faulty.
  (state "state" :uint8)
  ;; One bit per break beam, set if it is interrupted.
  (beams "beams" :uint32)
  ;; Number of stored objects.
  (stored "stored" :uint8))

(define-struct (geom "gripper.Geom")
  "The gripper's size and pose. (player_gripper_geom_t)"
  ;; Pose of the gripper on the robot (in m, m, m, rad, rad, rad, frame X_RS).
  (pose "pose" playhouse.common:pose3d)
  ;; Around the fingers (in m, m, m).
  (outer-size "outer_size" playhouse.common:bbox3d)
  ;; Of the gap between the open fingers (in m, m, m).
  (inner-size "inner_size" playhouse.common:bbox3d)
  ;; Number of break beams.
  (num-beams "num_beams" :uint8)
  ;; Capacity of the store, in objects.
  (capacity "capacity" :uint8))

;; State of the fingers and of the break beams.
(define-message +data-state+ 3 :data 1 "gripper.data.state" data)
;; Requests the gripper's size and pose.
(define-message +req-get-geom+ 3 :req 1 "gripper.req.get_geom" geom)
;; Opens the fingers.
(define-message +cmd-open+ 3 :cmd 1 "gripper.cmd.open")
;; Closes the fingers.
(define-message +cmd-close+ 3 :cmd 2 "gripper.cmd.close")
;; Stops the fingers at their current position.
(define-message +cmd-stop+ 3 :cmd 3 "gripper.cmd.stop")
;; Moves the held object into the store.
(define-message +cmd-store+ 3 :cmd 4 "gripper.cmd.store")
;; Moves the object stored last between the fingers.
(define-message +cmd-retrieve+ 3 :cmd 5 "gripper.cmd.retrieve")
