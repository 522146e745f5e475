;;;; Interface stereo, code 65. A pair of cameras, their disparity and the points in space.
;;;;
;;;; Generated from interfaces/065_stereo.toml by codegen; do not edit.

(cl:defpackage #:playhouse.stereo
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-state+ #:pointcloud3d-stereo-element #:data #:make-pointcloud3d-stereo-element
           #:copy-pointcloud3d-stereo-element #:pointcloud3d-stereo-element-p
           #:pointcloud3d-stereo-element-px #:pointcloud3d-stereo-element-py
           #:pointcloud3d-stereo-element-pz #:pointcloud3d-stereo-element-red
           #:pointcloud3d-stereo-element-green #:pointcloud3d-stereo-element-blue #:make-data #:copy-data
           #:data-p #:data-left-channel #:data-right-channel #:data-disparity #:data-points #:data-mode))

(cl:in-package #:playhouse.stereo)

(define-interface +code+ 65 "stereo")

(define-struct (pointcloud3d-stereo-element "stereo.Pointcloud3dStereoElement")
  "One point. (player_pointcloud3d_stereo_element_t)"
  ;; In m, frame p_SP.
  (px "px" :float32)
  ;; In m, frame p_SP.
  (py "py" :float32)
  ;; In m, frame p_SP.
  (pz "pz" :float32)
  (red "red" :uint8)
  (green "green" :uint8)
  (blue "blue" :uint8))

(define-struct (data "stereo.Data")
  "A pair of images, and the results computed from it. (player_stereo_data_t)"
  ;; Image of the left camera.
  (left-channel "left_channel" playhouse.camera:data)
  ;; Image of the right camera.
  (right-channel "right_channel" playhouse.camera:data)
  ;; Disparity, as an image.
  (disparity "disparity" playhouse.camera:data)
  ;; Points in space.
  (points "points" (:counted pointcloud3d-stereo-element 1398099 24))
  ;; Driver-specific.
  (mode "mode" :uint32))

;; A pair of images, and the results computed from it.
(define-message +data-state+ 65 :data 1 "stereo.data.state" data)
