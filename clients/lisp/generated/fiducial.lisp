;;;; Interface fiducial, code 10. Detects markers and reports their ids and poses.
;;;;
;;;; Generated from interfaces/010_fiducial.toml by codegen; do not edit.

(cl:defpackage #:playhouse.fiducial
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-scan+ #:+req-get-geom+ #:+req-get-fov+ #:+req-set-fov+ #:+req-get-id+
           #:+req-set-id+ #:item #:data #:geom #:fov #:id #:make-item #:copy-item #:item-p #:item-id
           #:item-pose #:item-upose #:make-data #:copy-data #:data-p #:data-fiducials #:make-geom
           #:copy-geom #:geom-p #:geom-pose #:geom-size #:geom-fiducial-size #:make-fov #:copy-fov #:fov-p
           #:fov-min-range #:fov-max-range #:fov-view-angle #:make-id #:copy-id #:id-p #:id-id))

(cl:in-package #:playhouse.fiducial)

(define-interface +code+ 10 "fiducial")

(define-struct (item "fiducial.Item")
  "One marker in view. (player_fiducial_item_t)"
  ;; Id of the marker; -1 if it cannot be identified, from simulated finders 0.
  (id "id" :int32)
  ;; Pose of the marker (in m, m, m, rad, rad, rad, frame X_ST).
  (pose "pose" playhouse.common:pose3d)
  ;; Standard deviation of each component of the pose; 0 if unknown (in m, m, m, rad, rad, rad, frame X_ST).
  (upose "upose" playhouse.common:pose3d))

(define-struct (data "fiducial.Data")
  "The markers in view. (player_fiducial_data_t)"
  (fiducials "fiducials" (:counted item 335543 100)))

(define-struct (geom "fiducial.Geom")
  "Size and pose. (player_fiducial_geom_t)"
  ;; Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
  (pose "pose" playhouse.common:pose3d)
  ;; Bounding box of the device (in m, m, m).
  (size "size" playhouse.common:bbox3d)
  ;; Of the markers; 0 if unknown (in m, m).
  (fiducial-size "fiducial_size" playhouse.common:bbox2d))

(define-struct (fov "fiducial.Fov")
  "Range and field of view. (player_fiducial_fov_t)"
  ;; In m.
  (min-range "min_range" :float32)
  ;; In m.
  (max-range "max_range" :float32)
  ;; From the first to the last direction (in rad).
  (view-angle "view_angle" :float32))

(define-struct (id "fiducial.Id")
  "A marker id. (player_fiducial_id_t)"
  (id "id" :uint32))

;; The markers in view.
(define-message +data-scan+ 10 :data 1 "fiducial.data.scan" data)
;; Requests the device's size and pose and the markers' size.
(define-message +req-get-geom+ 10 :req 1 "fiducial.req.get_geom" geom)
;; Requests the range and the field of view.
(define-message +req-get-fov+ 10 :req 2 "fiducial.req.get_fov" fov)
;; Sets the range and the field of view; the answer has the values in effect.
(define-message +req-set-fov+ 10 :req 3 "fiducial.req.set_fov" fov)
;; Requests the robot's own marker id.
(define-message +req-get-id+ 10 :req 7 "fiducial.req.get_id" id)
;; Sets the robot's own marker id.
(define-message +req-set-id+ 10 :req 8 "fiducial.req.set_id" id)
