;;;; Interface simulation, code 31. A simulator: reads and moves its models, pauses and resets it.
;;;;
;;;; Generated from interfaces/031_simulation.toml by codegen; do not edit.

(cl:defpackage #:playhouse.simulation
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+req-get-pose2d+ #:+req-set-pose2d+ #:+req-get-pose3d+ #:+req-set-pose3d+
           #:+req-get-property+ #:+req-set-property+ #:+cmd-pause+ #:+cmd-reset+ #:+cmd-save+ #:data #:cmd
           #:pose2d-req #:pose3d-req #:property-req #:make-data #:copy-data #:data-p #:data-data #:make-cmd
           #:copy-cmd #:cmd-p #:cmd-cmd #:make-pose2d-req #:copy-pose2d-req #:pose2d-req-p #:pose2d-req-name
           #:pose2d-req-pose #:make-pose3d-req #:copy-pose3d-req #:pose3d-req-p #:pose3d-req-name
           #:pose3d-req-pose #:pose3d-req-simtime #:make-property-req #:copy-property-req #:property-req-p
           #:property-req-name #:property-req-prop #:property-req-index #:property-req-value))

(cl:in-package #:playhouse.simulation)

(define-interface +code+ 31 "simulation")

(define-struct (data "simulation.Data")
  "Not sent by any message. (player_simulation_data_t)"
  ;; Without meaning.
  (data "data" :uint8))

(define-struct (cmd "simulation.Cmd")
  "Not sent by any message. (player_simulation_cmd_t)"
  ;; Without meaning.
  (cmd "cmd" :uint8))

(define-struct (pose2d-req "simulation.Pose2dReq")
  "A model and its pose. (player_simulation_pose2d_req_t)"
  ;; Of the model, NUL-terminated.
  (name "name" (:counted :char 33554392))
  ;; Pose of the model in its parent (the world for a top-level model); ignored in a request (in m, m, rad,
  ;; frame X_PT).
  (pose "pose" playhouse.common:pose2d))

(define-struct (pose3d-req "simulation.Pose3dReq")
  "A model, its pose and the time. (player_simulation_pose3d_req_t)"
  ;; Of the model, NUL-terminated.
  (name "name" (:counted :char 33554392))
  ;; Pose of the model in its parent (the world for a top-level model); ignored in a request (in m, m, m,
  ;; rad, rad, rad, frame X_PT).
  (pose "pose" playhouse.common:pose3d)
  ;; Simulated time of the pose, as counted by Stage; set in answers only (in us).
  (simtime "simtime" :float64))

(define-struct (property-req "simulation.PropertyReq")
  "A property of a model. (player_simulation_property_req_t)"
  ;; Name of the model, NUL-terminated; empty for a property of the world.
  (name "name" (:counted :char 33554392))
  ;; Name of the property, NUL-terminated.
  (prop "prop" (:counted :char 33554392))
  ;; Element of a list property: in a request the first one requested, in an answer the first of the next
  ;; request, 0 at the end of the list.
  (index "index" :uint32)
  ;; Bytes of the property, in a simulator-specific format; empty in a request.
  (value "value" (:counted :char 33554392)))

;; Requests the pose of a model by name.
(define-message +req-get-pose2d+ 31 :req 1 "simulation.req.get_pose2d" pose2d-req)
;; Moves a model by name.
(define-message +req-set-pose2d+ 31 :req 2 "simulation.req.set_pose2d" pose2d-req)
;; Requests the pose of a model by name, and the time.
(define-message +req-get-pose3d+ 31 :req 3 "simulation.req.get_pose3d" pose3d-req)
;; Moves a model by name.
(define-message +req-set-pose3d+ 31 :req 4 "simulation.req.set_pose3d" pose3d-req)
;; Requests a property of a model by name; without a name, for "models", the list of all with their devices
;; (docs/drivers.md).
(define-message +req-get-property+ 31 :req 5 "simulation.req.get_property" property-req)
;; Sets a property of a model by name.
(define-message +req-set-property+ 31 :req 6 "simulation.req.set_property" property-req)
;; Pauses or resumes the simulated clock.
(define-message +cmd-pause+ 31 :cmd 1 "simulation.cmd.pause")
;; Resets the world to its start.
(define-message +cmd-reset+ 31 :cmd 2 "simulation.cmd.reset")
;; Saves the current world.
(define-message +cmd-save+ 31 :cmd 3 "simulation.cmd.save")
