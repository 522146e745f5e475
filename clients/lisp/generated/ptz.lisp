;;;; Interface ptz, code 8. A camera mount that pans, tilts and zooms.
;;;;
;;;; Generated from interfaces/008_ptz.toml by codegen; do not edit.

(cl:defpackage #:playhouse.ptz
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+velocity-control+ #:+position-control+ #:+req-generic+ #:+req-control-mode+
           #:+req-geom+ #:+req-status+ #:+data-state+ #:+data-geom+ #:+cmd-state+ #:data #:cmd #:req-status
           #:geom #:req-generic #:req-control-mode #:make-data #:copy-data #:data-p #:data-pan #:data-tilt
           #:data-zoom #:data-panspeed #:data-tiltspeed #:data-status #:make-cmd #:copy-cmd #:cmd-p
           #:cmd-pan #:cmd-tilt #:cmd-zoom #:cmd-panspeed #:cmd-tiltspeed #:make-req-status
           #:copy-req-status #:req-status-p #:req-status-status #:make-geom #:copy-geom #:geom-p #:geom-pos
           #:geom-size #:make-req-generic #:copy-req-generic #:req-generic-p #:req-generic-config
           #:make-req-control-mode #:copy-req-control-mode #:req-control-mode-p #:req-control-mode-mode))

(cl:in-package #:playhouse.ptz)

(define-interface +code+ 8 "ptz")

;;; Values of ReqControlMode.mode.
(define-constants
  (+velocity-control+ 0)
  (+position-control+ 1))

(define-struct (data "ptz.Data")
  "Direction of the mount. (player_ptz_data_t)"
  ;; Positive to the left (in rad).
  (pan "pan" :float32)
  ;; Positive upwards (in rad).
  (tilt "tilt" :float32)
  ;; Field of view (in rad).
  (zoom "zoom" :float32)
  ;; Positive to the left (in rad/s).
  (panspeed "panspeed" :float32)
  ;; Positive upwards (in rad/s).
  (tiltspeed "tiltspeed" :float32)
  ;; Driver-specific.
  (status "status" :uint32))

(define-struct (cmd "ptz.Cmd")
  "Commanded direction or velocity of the mount. (player_ptz_cmd_t)"
  ;; Positive to the left (in rad).
  (pan "pan" :float32)
  ;; Positive upwards (in rad).
  (tilt "tilt" :float32)
  ;; Field of view (in rad).
  (zoom "zoom" :float32)
  ;; Used by velocity control (in rad/s).
  (panspeed "panspeed" :float32)
  ;; Used by velocity control (in rad/s).
  (tiltspeed "tiltspeed" :float32))

(define-struct (req-status "ptz.ReqStatus")
  "The mount's status. (player_ptz_req_status_t)"
  ;; Driver-specific.
  (status "status" :uint32))

(define-struct (geom "ptz.Geom")
  "The mount's size and pose. (player_ptz_geom_t)"
  ;; Pose of the mount on the robot (in m, m, m, rad, rad, rad, frame X_RS).
  (pos "pos" playhouse.common:pose3d)
  ;; Bounding box of the mount (in m, m, m).
  (size "size" playhouse.common:bbox3d))

(define-struct (req-generic "ptz.ReqGeneric")
  "Driver-specific words. (player_ptz_req_generic_t)"
  ;; Driver-specific.
  (config "config" (:counted :uint32 8388598)))

(define-struct (req-control-mode "ptz.ReqControlMode")
  "A control mode. (player_ptz_req_control_mode_t)"
  ;; Velocity or position.
  (mode "mode" :uint32))

;; Exchanges driver-specific words with the mount.
(define-message +req-generic+ 8 :req 1 "ptz.req.generic" req-generic)
;; Selects between velocity and position control.
(define-message +req-control-mode+ 8 :req 2 "ptz.req.control_mode" req-control-mode)
;; Requests size and pose.
(define-message +req-geom+ 8 :req 4 "ptz.req.geom" geom)
;; Requests the mount's status.
(define-message +req-status+ 8 :req 5 "ptz.req.status" req-status)
;; Direction of the mount.
(define-message +data-state+ 8 :data 1 "ptz.data.state" data)
;; Size and pose, sent on change.
(define-message +data-geom+ 8 :data 2 "ptz.data.geom" geom)
;; Commanded direction of the mount.
(define-message +cmd-state+ 8 :cmd 1 "ptz.cmd.state" cmd)
