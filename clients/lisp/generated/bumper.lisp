;;;; Interface bumper, code 14. Contact switches.
;;;;
;;;; Generated from interfaces/014_bumper.toml by codegen; do not edit.

(cl:defpackage #:playhouse.bumper
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-state+ #:+data-geom+ #:+req-get-geom+ #:data #:define #:geom #:make-data
           #:copy-data #:data-p #:data-bumpers #:make-define #:copy-define #:define-p #:define-pose
           #:define-length #:define-radius #:make-geom #:copy-geom #:geom-p #:geom-bumper-def))

(cl:in-package #:playhouse.bumper)

(define-interface +code+ 14 "bumper")

(define-struct (data "bumper.Data")
  "Which bumpers are pressed. (player_bumper_data_t)"
  ;; One per bumper: 0 free, else pressed.
  (bumpers "bumpers" (:counted :uint8 33554392)))

(define-struct (define "bumper.Define")
  "One bumper. (player_bumper_define_t)"
  ;; Of the bumper's centre (in m, m, m, rad, rad, rad, frame X_RS).
  (pose "pose" playhouse.common:pose3d)
  ;; In m.
  (length "length" :float32)
  ;; Radius of curvature; 0 if it is straight (in m).
  (radius "radius" :float32))

(define-struct (geom "bumper.Geom")
  "Poses of the bumpers. (player_bumper_geom_t)"
  (bumper-def "bumper_def" (:counted define 599185 56)))

;; Which bumpers are pressed.
(define-message +data-state+ 14 :data 1 "bumper.data.state" data)
;; Poses of the bumpers, sent on change.
(define-message +data-geom+ 14 :data 2 "bumper.data.geom" geom)
;; Requests the poses of the bumpers.
(define-message +req-get-geom+ 14 :req 1 "bumper.req.get_geom" geom)
