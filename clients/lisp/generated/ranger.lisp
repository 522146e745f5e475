;;;; Interface ranger, code 62. Range finders of any type: lasers, sonars, infrared, single or in arrays.
;;;;
;;;; Generated from interfaces/062_ranger.toml by codegen; do not edit.

(cl:defpackage #:playhouse.ranger
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-range+ #:+data-rangestamped+ #:+data-intns+ #:+data-intnsstamped+ #:+data-geom+
           #:+req-get-geom+ #:+req-power+ #:+req-intns+ #:+req-set-config+ #:+req-get-config+ #:config
           #:geom #:data-range #:data-rangestamped #:data-intns #:data-intnsstamped #:power-config
           #:intns-config #:make-config #:copy-config #:config-p #:config-min-angle #:config-max-angle
           #:config-angular-res #:config-min-range #:config-max-range #:config-range-res #:config-frequency
           #:make-geom #:copy-geom #:geom-p #:geom-pose #:geom-size #:geom-element-poses
           #:geom-element-sizes #:make-data-range #:copy-data-range #:data-range-p #:data-range-ranges
           #:make-data-rangestamped #:copy-data-rangestamped #:data-rangestamped-p #:data-rangestamped-data
           #:data-rangestamped-have-geom #:data-rangestamped-geom #:data-rangestamped-have-config
           #:data-rangestamped-config #:make-data-intns #:copy-data-intns #:data-intns-p
           #:data-intns-intensities #:make-data-intnsstamped #:copy-data-intnsstamped #:data-intnsstamped-p
           #:data-intnsstamped-data #:data-intnsstamped-have-geom #:data-intnsstamped-geom
           #:data-intnsstamped-have-config #:data-intnsstamped-config #:make-power-config
           #:copy-power-config #:power-config-p #:power-config-state #:make-intns-config #:copy-intns-config
           #:intns-config-p #:intns-config-state))

(cl:in-package #:playhouse.ranger)

(define-interface +code+ 62 "ranger")

(define-struct (config "ranger.Config")
  "Angles, ranges and rate. (player_ranger_config_t)"
  ;; Of the first beam, counter-clockwise from x (in rad).
  (min-angle "min_angle" :float64)
  ;; Of the last beam (in rad).
  (max-angle "max_angle" :float64)
  ;; Angle between neighbouring beams (in rad).
  (angular-res "angular_res" :float64)
  ;; Minimum range (in m).
  (min-range "min_range" :float64)
  ;; Maximum range, and reported range of a beam without a hit (in m).
  (max-range "max_range" :float64)
  ;; Range resolution (in m).
  (range-res "range_res" :float64)
  ;; Scans per second (in Hz).
  (frequency "frequency" :float64))

(define-struct (geom "ranger.Geom")
  "Size and pose of the device and its elements. (player_ranger_geom_t)"
  ;; Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
  (pose "pose" playhouse.common:pose3d)
  ;; Bounding box of the device (in m, m, m).
  (size "size" playhouse.common:bbox3d)
  ;; One per element; x points along its beam, or along the middle of its scan (in m, m, m, rad, rad, rad,
  ;; frame X_SE).
  (element-poses "element_poses" (:counted playhouse.common:pose3d 699049 48))
  ;; One per element (in m, m, m).
  (element-sizes "element_sizes" (:counted playhouse.common:bbox3d 1398099 24)))

(define-struct (data-range "ranger.DataRange")
  "Ranges. (player_ranger_data_range_t)"
  ;; Beam by beam from right to left, element by element (in m).
  (ranges "ranges" (:counted :float64 4194299)))

(define-struct (data-rangestamped "ranger.DataRangestamped")
  "Ranges with geometry and configuration. (player_ranger_data_rangestamped_t)"
  (data "data" data-range)
  ;; 1 if `geom` is valid.
  (have-geom "have_geom" :uint8)
  (geom "geom" geom)
  ;; 1 if `config` is valid.
  (have-config "have_config" :uint8)
  (config "config" config))

(define-struct (data-intns "ranger.DataIntns")
  "Intensities. (player_ranger_data_intns_t)"
  ;; In the order of the ranges; driver-specific scale.
  (intensities "intensities" (:counted :float64 4194299)))

(define-struct (data-intnsstamped "ranger.DataIntnsstamped")
  "Intensities with geometry and configuration. (player_ranger_data_intnsstamped_t)"
  (data "data" data-intns)
  ;; 1 if `geom` is valid.
  (have-geom "have_geom" :uint8)
  (geom "geom" geom)
  ;; 1 if `config` is valid.
  (have-config "have_config" :uint8)
  (config "config" config))

(define-struct (power-config "ranger.PowerConfig")
  "The device's switch. (player_ranger_power_config_t)"
  ;; 1: on, 0: off.
  (state "state" :uint8))

(define-struct (intns-config "ranger.IntnsConfig")
  "The switch of intensities. (player_ranger_intns_config_t)"
  ;; 1: on, 0: off.
  (state "state" :uint8))

;; Ranges.
(define-message +data-range+ 62 :data 1 "ranger.data.range" data-range)
;; Ranges with the geometry and configuration of the measurement.
(define-message +data-rangestamped+ 62 :data 2 "ranger.data.rangestamped" data-rangestamped)
;; Intensities.
(define-message +data-intns+ 62 :data 3 "ranger.data.intns" data-intns)
;; Intensities with the geometry and configuration of the measurement.
(define-message +data-intnsstamped+ 62 :data 4 "ranger.data.intnsstamped" data-intnsstamped)
;; Size and pose, sent on change.
(define-message +data-geom+ 62 :data 5 "ranger.data.geom" geom)
;; Requests size and pose.
(define-message +req-get-geom+ 62 :req 1 "ranger.req.get_geom" geom)
;; Switches the device on or off.
(define-message +req-power+ 62 :req 2 "ranger.req.power" power-config)
;; Switches intensities on or off.
(define-message +req-intns+ 62 :req 3 "ranger.req.intns" intns-config)
;; Sets angles, ranges and rate; the answer has the values in effect.
(define-message +req-set-config+ 62 :req 4 "ranger.req.set_config" config)
;; Requests angles, ranges and rate.
(define-message +req-get-config+ 62 :req 5 "ranger.req.get_config" config)
