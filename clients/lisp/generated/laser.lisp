;;;; Interface laser, code 6. A scanning range finder. New drivers use the ranger interface.
;;;;
;;;; Generated from interfaces/006_laser.toml by codegen; do not edit.

(cl:defpackage #:playhouse.laser
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+max-filter-params+ #:+filter-median+ #:+filter-edge+ #:+filter-range+ #:+filter-mean+
           #:+data-scan+ #:+data-scanpose+ #:+data-scanangle+ #:+req-get-geom+ #:+req-set-config+
           #:+req-get-config+ #:+req-power+ #:+req-get-id+ #:+req-set-filter+ #:data #:data-scanpose
           #:data-scanangle #:geom #:config #:power-config #:get-id-config #:set-filter-config #:make-data
           #:copy-data #:data-p #:data-min-angle #:data-max-angle #:data-resolution #:data-max-range
           #:data-ranges #:data-intensity #:data-id #:make-data-scanpose #:copy-data-scanpose
           #:data-scanpose-p #:data-scanpose-scan #:data-scanpose-pose #:make-data-scanangle
           #:copy-data-scanangle #:data-scanangle-p #:data-scanangle-max-range #:data-scanangle-ranges
           #:data-scanangle-angles #:data-scanangle-intensity #:data-scanangle-id #:make-geom #:copy-geom
           #:geom-p #:geom-pose #:geom-size #:make-config #:copy-config #:config-p #:config-min-angle
           #:config-max-angle #:config-resolution #:config-max-range #:config-range-res #:config-intensity
           #:config-scanning-frequency #:make-power-config #:copy-power-config #:power-config-p
           #:power-config-state #:make-get-id-config #:copy-get-id-config #:get-id-config-p
           #:get-id-config-serial-number #:make-set-filter-config #:copy-set-filter-config
           #:set-filter-config-p #:set-filter-config-filter-type #:set-filter-config-parameters))

(cl:in-package #:playhouse.laser)

(define-interface +code+ 6 "laser")

;;; Largest number of filter parameters.
(define-constants
  (+max-filter-params+ 8))

;;; Values of SetFilterConfig.filter_type.
(define-constants
  (+filter-median+ 1)
  (+filter-edge+ 2)
  (+filter-range+ 3)
  (+filter-mean+ 4))

(define-struct (data "laser.Data")
  "One scan at equal angles. (player_laser_data_t)"
  ;; Of the first beam, counter-clockwise from x (in rad).
  (min-angle "min_angle" :float32)
  ;; Of the last beam (in rad).
  (max-angle "max_angle" :float32)
  ;; Angle between neighbouring beams (in rad).
  (resolution "resolution" :float32)
  ;; Reported range of a beam without a hit (in m).
  (max-range "max_range" :float32)
  ;; From right to left (in m).
  (ranges "ranges" (:counted :float32 8388598))
  ;; Intensity of the echo per beam; empty if the device has none.
  (intensity "intensity" (:counted :uint8 33554392))
  ;; Increases from scan to scan, by one or more.
  (id "id" :uint32))

(define-struct (data-scanpose "laser.DataScanpose")
  "One scan and the pose at which it was measured. (player_laser_data_scanpose_t)"
  (scan "scan" data)
  ;; Of the robot at the time of the scan (in m, m, rad, frame X_OR).
  (pose "pose" playhouse.common:pose2d))

(define-struct (data-scanangle "laser.DataScanangle")
  "One scan with an angle per beam. (player_laser_data_scanangle_t)"
  ;; Reported range of a beam without a hit (in m).
  (max-range "max_range" :float32)
  ;; One per beam (in m).
  (ranges "ranges" (:counted :float32 8388598))
  ;; One per beam, counter-clockwise from x (in rad).
  (angles "angles" (:counted :float32 8388598))
  ;; Intensity of the echo per beam; empty if the device has none.
  (intensity "intensity" (:counted :uint8 33554392))
  ;; Increases from scan to scan, by one or more.
  (id "id" :uint32))

(define-struct (geom "laser.Geom")
  "The device's size and pose. (player_laser_geom_t)"
  ;; Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
  (pose "pose" playhouse.common:pose3d)
  ;; Bounding box of the device (in m, m, m).
  (size "size" playhouse.common:bbox3d))

(define-struct (config "laser.Config")
  "Angles, resolution and rate. (player_laser_config_t)"
  ;; Of the first beam (in rad).
  (min-angle "min_angle" :float32)
  ;; Of the last beam (in rad).
  (max-angle "max_angle" :float32)
  ;; Angle between neighbouring beams (in rad).
  (resolution "resolution" :float32)
  ;; Maximum range (in m).
  (max-range "max_range" :float32)
  ;; Range resolution (in m).
  (range-res "range_res" :float32)
  ;; 1: send intensities, too.
  (intensity "intensity" :uint8)
  ;; Scans per second (in Hz).
  (scanning-frequency "scanning_frequency" :float32))

(define-struct (power-config "laser.PowerConfig")
  "The device's switch. (player_laser_power_config_t)"
  ;; 1: on, 0: off.
  (state "state" :uint8))

(define-struct (get-id-config "laser.GetIdConfig")
  "A serial number. (player_laser_get_id_config_t)"
  ;; 0 in the request.
  (serial-number "serial_number" :uint32))

(define-struct (set-filter-config "laser.SetFilterConfig")
  "A filter. (player_laser_set_filter_config_t)"
  ;; Type of filter.
  (filter-type "filter_type" :uint8)
  ;; Filter-specific.
  (parameters "parameters" (:bounded :float32 8)))

;; One scan at equal angles.
(define-message +data-scan+ 6 :data 1 "laser.data.scan" data)
;; One scan and the pose at which it was measured.
(define-message +data-scanpose+ 6 :data 2 "laser.data.scanpose" data-scanpose)
;; One scan with an angle per beam.
(define-message +data-scanangle+ 6 :data 3 "laser.data.scanangle" data-scanangle)
;; Requests the device's size and pose.
(define-message +req-get-geom+ 6 :req 1 "laser.req.get_geom" geom)
;; Sets angles, resolution and rate; the answer has the values in effect.
(define-message +req-set-config+ 6 :req 2 "laser.req.set_config" config)
;; Requests angles, resolution and rate.
(define-message +req-get-config+ 6 :req 3 "laser.req.get_config" config)
;; Switches the device on or off.
(define-message +req-power+ 6 :req 4 "laser.req.power" power-config)
;; Requests the serial number.
(define-message +req-get-id+ 6 :req 5 "laser.req.get_id" get-id-config)
;; Selects a filter for the ranges.
(define-message +req-set-filter+ 6 :req 6 "laser.req.set_filter" set-filter-config)
