;;;; Interface sonar, code 5. An array of sonars. New drivers use the ranger interface.
;;;;
;;;; Generated from interfaces/005_sonar.toml by codegen; do not edit.

(cl:defpackage #:playhouse.sonar
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+req-get-geom+ #:+req-power+ #:+data-ranges+ #:+data-geom+ #:data #:geom
           #:power-config #:make-data #:copy-data #:data-p #:data-ranges #:make-geom #:copy-geom #:geom-p
           #:geom-poses #:make-power-config #:copy-power-config #:power-config-p #:power-config-state))

(cl:in-package #:playhouse.sonar)

(define-interface +code+ 5 "sonar")

(define-struct (data "sonar.Data")
  "One range per sonar. (player_sonar_data_t)"
  ;; Range of the nearest echo, in the order of the geometry (in m).
  (ranges "ranges" (:counted :float32 8388598)))

(define-struct (geom "sonar.Geom")
  "Poses of the sonars. (player_sonar_geom_t)"
  ;; One per sonar; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS).
  (poses "poses" (:counted playhouse.common:pose3d 699049 48)))

(define-struct (power-config "sonar.PowerConfig")
  "The sonars' switch. (player_sonar_power_config_t)"
  ;; 1: on, 0: off.
  (state "state" :uint8))

;; Requests the poses of the sonars.
(define-message +req-get-geom+ 5 :req 1 "sonar.req.get_geom" geom)
;; Switches the sonars on or off.
(define-message +req-power+ 5 :req 2 "sonar.req.power" power-config)
;; One range per sonar.
(define-message +data-ranges+ 5 :data 1 "sonar.data.ranges" data)
;; Poses of the sonars, sent on change.
(define-message +data-geom+ 5 :data 2 "sonar.data.geom" geom)
