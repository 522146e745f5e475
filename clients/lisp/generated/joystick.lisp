;;;; Interface joystick, code 49. A joystick or gamepad.
;;;;
;;;; Generated from interfaces/049_joystick.toml by codegen; do not edit.

(cl:defpackage #:playhouse.joystick
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-state+ #:data #:make-data #:copy-data #:data-p #:data-pos #:data-scale
           #:data-buttons #:data-axes-count))

(cl:in-package #:playhouse.joystick)

(define-interface +code+ 49 "joystick")

(define-struct (data "joystick.Data")
  "Sticks and buttons. (player_joystick_data_t)"
  ;; One per axis, from -scale to scale.
  (pos "pos" (:array :int32 8))
  ;; Maximum value per axis.
  (scale "scale" (:array :int32 8))
  ;; One bit per button, the first in the lowest bit.
  (buttons "buttons" :uint32)
  ;; Number of axes.
  (axes-count "axes_count" :uint32))

;; Sticks and buttons.
(define-message +data-state+ 49 :data 1 "joystick.data.state" data)
