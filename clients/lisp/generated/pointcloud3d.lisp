;;;; Interface pointcloud3d, code 61. Points in space with colors.
;;;;
;;;; Generated from interfaces/061_pointcloud3d.toml by codegen; do not edit.

(cl:defpackage #:playhouse.pointcloud3d
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-state+ #:element #:data #:make-element #:copy-element #:element-p
           #:element-point #:element-color #:make-data #:copy-data #:data-p #:data-points))

(cl:in-package #:playhouse.pointcloud3d)

(define-interface +code+ 61 "pointcloud3d")

(define-struct (element "pointcloud3d.Element")
  "One point. (player_pointcloud3d_element_t)"
  ;; In m, frame p_SP.
  (point "point" playhouse.common:point3d)
  (color "color" playhouse.common:color))

(define-struct (data "pointcloud3d.Data")
  "One cloud. (player_pointcloud3d_data_t)"
  (points "points" (:counted element 838859 40)))

;; One cloud.
(define-message +data-state+ 61 :data 1 "pointcloud3d.data.state" data)
