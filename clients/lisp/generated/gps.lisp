;;;; Interface gps, code 13. A satellite receiver.
;;;;
;;;; Generated from interfaces/013_gps.toml by codegen; do not edit.

(cl:defpackage #:playhouse.gps
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-state+ #:data #:make-data #:copy-data #:data-p #:data-time-sec #:data-time-usec
           #:data-latitude #:data-longitude #:data-altitude #:data-speed #:data-course #:data-utm-e
           #:data-utm-n #:data-quality #:data-num-sats #:data-hdop #:data-vdop #:data-err-horz
           #:data-err-vert))

(cl:in-package #:playhouse.gps)

(define-interface +code+ 13 "gps")

(define-struct (data "gps.Data")
  "A fix. (player_gps_data_t)"
  ;; Time of the fix since 1970: whole seconds (in s).
  (time-sec "time_sec" :uint32)
  ;; Time of the fix: microseconds of the second (in us).
  (time-usec "time_usec" :uint32)
  ;; Positive north, WGS84 (in 1e-7 deg).
  (latitude "latitude" :int32)
  ;; Positive east, WGS84 (in 1e-7 deg).
  (longitude "longitude" :int32)
  ;; Above the ellipsoid (in mm).
  (altitude "altitude" :int32)
  ;; Over ground (in m/s).
  (speed "speed" :float64)
  ;; Direction of travel, clockwise from north (in rad).
  (course "course" :float64)
  ;; UTM easting (in m).
  (utm-e "utm_e" :float64)
  ;; UTM northing (in m).
  (utm-n "utm_n" :float64)
  ;; 0: no fix, 1: plain, 2: differential.
  (quality "quality" :uint32)
  ;; Satellites used.
  (num-sats "num_sats" :uint32)
  ;; Horizontal dilution of precision (in 0.1).
  (hdop "hdop" :uint32)
  ;; Vertical dilution of precision (in 0.1).
  (vdop "vdop" :uint32)
  ;; Expected horizontal error (in m).
  (err-horz "err_horz" :float64)
  ;; Expected vertical error (in m).
  (err-vert "err_vert" :float64))

;; The newest fix.
(define-message +data-state+ 13 :data 1 "gps.data.state" data)
