;;;; What every interface shares. Types shared by several interfaces, and requests to any device.
;;;;
;;;; Generated from interfaces/000_common.toml by codegen; do not edit.

(cl:defpackage #:playhouse.common
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+max-message-size+ #:+max-driver-string-len+ #:+max-devices+ #:+msgqueue-default-maxlen+
           #:+ident-strlen+ #:+keylen+ #:+req-capabilities+ #:+req-get-intprop+ #:+req-set-intprop+
           #:+req-get-dblprop+ #:+req-set-dblprop+ #:+req-get-strprop+ #:+req-set-strprop+
           #:+req-get-boolprop+ #:+req-set-boolprop+ #:devaddr #:point2d #:point3d #:orientation3d #:pose2d
           #:pose3d #:bbox2d #:bbox3d #:blackboard-entry #:segment #:extent2d #:color #:bool #:uint32
           #:capabilities-req #:boolprop-req #:intprop-req #:dblprop-req #:strprop-req #:make-devaddr
           #:copy-devaddr #:devaddr-p #:devaddr-host #:devaddr-robot #:devaddr-interf #:devaddr-index
           #:make-point2d #:copy-point2d #:point2d-p #:point2d-px #:point2d-py #:make-point3d #:copy-point3d
           #:point3d-p #:point3d-px #:point3d-py #:point3d-pz #:make-orientation3d #:copy-orientation3d
           #:orientation3d-p #:orientation3d-proll #:orientation3d-ppitch #:orientation3d-pyaw #:make-pose2d
           #:copy-pose2d #:pose2d-p #:pose2d-px #:pose2d-py #:pose2d-pa #:make-pose3d #:copy-pose3d
           #:pose3d-p #:pose3d-px #:pose3d-py #:pose3d-pz #:pose3d-proll #:pose3d-ppitch #:pose3d-pyaw
           #:make-bbox2d #:copy-bbox2d #:bbox2d-p #:bbox2d-sw #:bbox2d-sl #:make-bbox3d #:copy-bbox3d
           #:bbox3d-p #:bbox3d-sw #:bbox3d-sl #:bbox3d-sh #:make-blackboard-entry #:copy-blackboard-entry
           #:blackboard-entry-p #:blackboard-entry-key #:blackboard-entry-group #:blackboard-entry-type
           #:blackboard-entry-subtype #:blackboard-entry-data #:blackboard-entry-timestamp-sec
           #:blackboard-entry-timestamp-usec #:make-segment #:copy-segment #:segment-p #:segment-x0
           #:segment-y0 #:segment-x1 #:segment-y1 #:make-extent2d #:copy-extent2d #:extent2d-p #:extent2d-x0
           #:extent2d-y0 #:extent2d-x1 #:extent2d-y1 #:make-color #:copy-color #:color-p #:color-alpha
           #:color-red #:color-green #:color-blue #:make-bool #:copy-bool #:bool-p #:bool-state
           #:make-uint32 #:copy-uint32 #:uint32-p #:uint32-value #:make-capabilities-req
           #:copy-capabilities-req #:capabilities-req-p #:capabilities-req-type #:capabilities-req-subtype
           #:make-boolprop-req #:copy-boolprop-req #:boolprop-req-p #:boolprop-req-key #:boolprop-req-value
           #:make-intprop-req #:copy-intprop-req #:intprop-req-p #:intprop-req-key #:intprop-req-value
           #:make-dblprop-req #:copy-dblprop-req #:dblprop-req-p #:dblprop-req-key #:dblprop-req-value
           #:make-strprop-req #:copy-strprop-req #:strprop-req-p #:strprop-req-key #:strprop-req-value))

(cl:in-package #:playhouse.common)

;;; Limits shared by all implementations of the protocol.
(define-constants
  (+max-message-size+ 8388608)
  (+max-driver-string-len+ 64)
  (+max-devices+ 4096)
  (+msgqueue-default-maxlen+ 1024)
  (+ident-strlen+ 32)
  (+keylen+ 32))

(define-struct (devaddr "common.Devaddr")
  "Address of a device. (player_devaddr_t)"
  ;; Host of the device's server; receivers compare only interf and index.
  (host "host" :uint32)
  ;; TCP port of the device's server: its name space.
  (robot "robot" :uint32)
  ;; Interface code.
  (interf "interf" :uint16)
  ;; Index of the device within its interface.
  (index "index" :uint16))

(define-struct (point2d "common.Point2d")
  "A point or vector in the plane. (player_point_2d_t)"
  ;; In m.
  (px "px" :float64)
  ;; In m.
  (py "py" :float64))

(define-struct (point3d "common.Point3d")
  "A point or vector in space. (player_point_3d_t)"
  ;; In m.
  (px "px" :float64)
  ;; In m.
  (py "py" :float64)
  ;; In m.
  (pz "pz" :float64))

(define-struct (orientation3d "common.Orientation3d")
  "An orientation in space: rotations about z (yaw), then y (pitch), then x (roll).
  (player_orientation_3d_t)"
  ;; About x (in rad).
  (proll "proll" :float64)
  ;; About y (in rad).
  (ppitch "ppitch" :float64)
  ;; About z (in rad).
  (pyaw "pyaw" :float64))

(define-struct (pose2d "common.Pose2d")
  "A pose in the plane, or, if the message says so, a velocity with the same three components.
  (player_pose2d_t)"
  ;; In m.
  (px "px" :float64)
  ;; In m.
  (py "py" :float64)
  ;; Heading, counter-clockwise from x (in rad).
  (pa "pa" :float64))

(define-struct (pose3d "common.Pose3d")
  "A pose in space, or, if the message says so, a velocity or acceleration with the same six components.
  (player_pose3d_t)"
  ;; In m.
  (px "px" :float64)
  ;; In m.
  (py "py" :float64)
  ;; In m.
  (pz "pz" :float64)
  ;; About x (in rad).
  (proll "proll" :float64)
  ;; About y (in rad).
  (ppitch "ppitch" :float64)
  ;; About z (in rad).
  (pyaw "pyaw" :float64))

(define-struct (bbox2d "common.Bbox2d")
  "Size of a bounding rectangle. (player_bbox2d_t)"
  ;; Width, along y (in m).
  (sw "sw" :float64)
  ;; Length, along x (in m).
  (sl "sl" :float64))

(define-struct (bbox3d "common.Bbox3d")
  "Size of a bounding box. (player_bbox3d_t)"
  ;; Width, along y (in m).
  (sw "sw" :float64)
  ;; Length, along x (in m).
  (sl "sl" :float64)
  ;; Height, along z (in m).
  (sh "sh" :float64))

(define-struct (blackboard-entry "common.BlackboardEntry")
  "One entry of a blackboard: a value under a key in a group. (player_blackboard_entry_t)"
  ;; Name of the entry within its group.
  (key "key" (:counted :char 33554392))
  ;; Name of the group, a namespace of keys.
  (group "group" (:counted :char 33554392))
  ;; Category of `data`: simple values or types of other interfaces.
  (type "type" :uint16)
  ;; Exact type of `data`; of simple values: string, integer or floating-point number.
  (subtype "subtype" :uint16)
  ;; Bytes of the value, opaque to the blackboard.
  (data "data" (:counted :uint8 33554392))
  ;; Time at which the value was set: whole seconds (in s).
  (timestamp-sec "timestamp_sec" :uint32)
  ;; Time at which the value was set: microseconds of the second (in us).
  (timestamp-usec "timestamp_usec" :uint32))

(define-struct (segment "common.Segment")
  "A line segment. (player_segment_t)"
  ;; x of the start (in m).
  (x0 "x0" :float64)
  ;; y of the start (in m).
  (y0 "y0" :float64)
  ;; x of the end (in m).
  (x1 "x1" :float64)
  ;; y of the end (in m).
  (y1 "y1" :float64))

(define-struct (extent2d "common.Extent2d")
  "An axis-aligned rectangle, given by two corners. (player_extent2d_t)"
  ;; Smallest x (in m).
  (x0 "x0" :float64)
  ;; Smallest y (in m).
  (y0 "y0" :float64)
  ;; Largest x (in m).
  (x1 "x1" :float64)
  ;; Largest y (in m).
  (y1 "y1" :float64))

(define-struct (color "common.Color")
  "A color with opacity, each component from 0 to 255. (player_color_t)"
  ;; 255 is opaque, 0 invisible.
  (alpha "alpha" :uint8)
  (red "red" :uint8)
  (green "green" :uint8)
  (blue "blue" :uint8))

(define-struct (bool "common.Bool")
  "A switch. (player_bool_t)"
  ;; 0: off, else on.
  (state "state" :uint8))

(define-struct (uint32 "common.Uint32")
  "One integer. (player_uint32_t)"
  (value "value" :uint32))

(define-struct (capabilities-req "common.CapabilitiesReq")
  "The queried message. (player_capabilities_req_t)"
  ;; Type of the message, as in a header.
  (type "type" :uint32)
  ;; Subtype of the message, as in a header.
  (subtype "subtype" :uint32))

(define-struct (boolprop-req "common.BoolpropReq")
  "A named switch. (player_boolprop_req_t)"
  ;; Name of the property, NUL-terminated.
  (key "key" (:counted :char 33554392))
  ;; 0 false, else true; ignored in a request.
  (value "value" :char))

(define-struct (intprop-req "common.IntpropReq")
  "A named integer. (player_intprop_req_t)"
  ;; Name of the property, NUL-terminated.
  (key "key" (:counted :char 33554392))
  ;; Ignored in a question.
  (value "value" :int32))

(define-struct (dblprop-req "common.DblpropReq")
  "A named number. (player_dblprop_req_t)"
  ;; Name of the property, NUL-terminated.
  (key "key" (:counted :char 33554392))
  ;; In the driver's unit for the property; ignored in a request.
  (value "value" :float64))

(define-struct (strprop-req "common.StrpropReq")
  "A named string. (player_strprop_req_t)"
  ;; Name of the property, NUL-terminated.
  (key "key" (:counted :char 33554392))
  ;; NUL-terminated; ignored in a request.
  (value "value" (:counted :char 33554392)))

;; Queries whether the device supports a message: an empty ACK means yes, NACK no.
(define-message +req-capabilities+ 0 :req 255 "universal.req.capabilities" capabilities-req)
;; Reads a named integer of the driver; the answer repeats the key.
(define-message +req-get-intprop+ 0 :req 254 "universal.req.get_intprop" intprop-req)
;; Changes a named integer of the driver.
(define-message +req-set-intprop+ 0 :req 253 "universal.req.set_intprop" intprop-req)
;; Reads a named number of the driver; the answer repeats the key.
(define-message +req-get-dblprop+ 0 :req 252 "universal.req.get_dblprop" dblprop-req)
;; Changes a named number of the driver.
(define-message +req-set-dblprop+ 0 :req 251 "universal.req.set_dblprop" dblprop-req)
;; Reads a named string of the driver; the answer repeats the key.
(define-message +req-get-strprop+ 0 :req 250 "universal.req.get_strprop" strprop-req)
;; Changes a named string of the driver.
(define-message +req-set-strprop+ 0 :req 249 "universal.req.set_strprop" strprop-req)
;; Reads a named switch of the driver; the answer repeats the key.
(define-message +req-get-boolprop+ 0 :req 248 "universal.req.get_boolprop" boolprop-req)
;; Changes a named switch of the driver.
(define-message +req-set-boolprop+ 0 :req 247 "universal.req.set_boolprop" boolprop-req)
