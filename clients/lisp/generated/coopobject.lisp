;;;; Interface coopobject, code 66. Cooperating objects: fixed and moving sensor nodes and robots that report
;;;; to each other.
;;;;
;;;; Generated from interfaces/066_coopobject.toml by codegen; do not edit.

(cl:defpackage #:playhouse.coopobject
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+origin-staticbase+ #:+origin-mobilebase+ #:+origin-mote+ #:+origin-robot+
           #:+msg-none+ #:+msg-health+ #:+msg-position+ #:+msg-rssi+ #:+msg-sensor+ #:+msg-alarm+
           #:+msg-request+ #:+msg-command+ #:+temperature+ #:+humidity+ #:+pressure+ #:+light-1+ #:+light-2+
           #:+accel-x+ #:+accel-y+ #:+accel-z+ #:+magnetometer-x+ #:+magnetometer-y+ #:+magnetometer-z+
           #:+compass+ #:+co+ #:+co2+ #:+h2+ #:+smoke+ #:+optswitch+ #:+data-health+ #:+data-rssi+
           #:+data-sensor+ #:+data-alarm+ #:+data-userdefined+ #:+data-request+ #:+data-command+
           #:+data-position+ #:+cmd-standard+ #:+cmd-data+ #:+cmd-position+ #:+req-standard+ #:header #:rssi
           #:position #:sensor #:data-sensor #:data-userdefined #:req #:cmd #:make-header #:copy-header
           #:header-p #:header-origin #:header-id #:header-parent-id #:make-rssi #:copy-rssi #:rssi-p
           #:rssi-header #:rssi-sender-id #:rssi-rssi #:rssi-stamp #:rssi-node-time-high
           #:rssi-node-time-low #:rssi-x #:rssi-y #:rssi-z #:make-position #:copy-position #:position-p
           #:position-header #:position-x #:position-y #:position-z #:position-status #:make-sensor
           #:copy-sensor #:sensor-p #:sensor-type #:sensor-value #:make-data-sensor #:copy-data-sensor
           #:data-sensor-p #:data-sensor-header #:data-sensor-data #:make-data-userdefined
           #:copy-data-userdefined #:data-userdefined-p #:data-userdefined-header #:data-userdefined-type
           #:data-userdefined-data #:make-req #:copy-req #:req-p #:req-header #:req-request #:req-parameters
           #:make-cmd #:copy-cmd #:cmd-p #:cmd-header #:cmd-command #:cmd-parameters))

(cl:in-package #:playhouse.coopobject)

(define-interface +code+ 66 "coopobject")

;;; Values of Header.origin.
(define-constants
  (+origin-staticbase+ 0)
  (+origin-mobilebase+ 1)
  (+origin-mote+ 2)
  (+origin-robot+ 3))

;;; Types of messages between nodes.
(define-constants
  (+msg-none+ -1)
  (+msg-health+ 0)
  (+msg-position+ 1)
  (+msg-rssi+ 2)
  (+msg-sensor+ 3)
  (+msg-alarm+ 4)
  (+msg-request+ 5)
  (+msg-command+ 6))

;;; Values of Sensor.type.
(define-constants
  (+temperature+ 0)
  (+humidity+ 1)
  (+pressure+ 2)
  (+light-1+ 3)
  (+light-2+ 4)
  (+accel-x+ 5)
  (+accel-y+ 6)
  (+accel-z+ 7)
  (+magnetometer-x+ 8)
  (+magnetometer-y+ 9)
  (+magnetometer-z+ 10)
  (+compass+ 11)
  (+co+ 12)
  (+co2+ 13)
  (+h2+ 14)
  (+smoke+ 15)
  (+optswitch+ 16))

(define-struct (header "coopobject.Header")
  "Id of the node. (player_coopobject_header_t)"
  ;; Type of node.
  (origin "origin" :uint8)
  (id "id" :uint16)
  ;; Node that relayed the message.
  (parent-id "parent_id" :uint16))

(define-struct (rssi "coopobject.Rssi")
  "Radio signal strength. (player_coopobject_rssi_t)"
  (header "header" header)
  ;; Node that sent the signal.
  (sender-id "sender_id" :uint16)
  ;; As the radio reports it.
  (rssi "rssi" :uint16)
  ;; Counter of measurements.
  (stamp "stamp" :uint16)
  ;; Clock of the node: upper half.
  (node-time-high "nodeTimeHigh" :uint32)
  ;; Clock of the node: lower half.
  (node-time-low "nodeTimeLow" :uint32)
  ;; Position of the receiver (in m, frame p_WS).
  (x "x" :float32)
  ;; In m, frame p_WS.
  (y "y" :float32)
  ;; In m, frame p_WS.
  (z "z" :float32))

(define-struct (position "coopobject.Position")
  "Position of a node. (player_coopobject_position_t)"
  (header "header" header)
  ;; In m, frame p_WS.
  (x "x" :float32)
  ;; In m, frame p_WS.
  (y "y" :float32)
  ;; In m, frame p_WS.
  (z "z" :float32)
  ;; Driver-specific.
  (status "status" :uint8))

(define-struct (sensor "coopobject.Sensor")
  "One reading. (player_coopobject_sensor_t)"
  ;; Measured quantity.
  (type "type" :uint8)
  ;; As the sensor reports it.
  (value "value" :int16))

(define-struct (data-sensor "coopobject.DataSensor")
  "Readings of a node. (player_coopobject_data_sensor_t)"
  (header "header" header)
  (data "data" (:counted sensor 4194299 8)))

(define-struct (data-userdefined "coopobject.DataUserdefined")
  "Bytes from or to a node. (player_coopobject_data_userdefined_t)"
  (header "header" header)
  ;; User-specific.
  (type "type" :uint8)
  (data "data" (:counted :uint8 33554392)))

(define-struct (req "coopobject.Req")
  "A request. (player_coopobject_req_t)"
  (header "header" header)
  ;; Which.
  (request "request" :uint8)
  ;; Request-specific.
  (parameters "parameters" (:counted :uint8 33554392)))

(define-struct (cmd "coopobject.Cmd")
  "A command. (player_coopobject_cmd_t)"
  (header "header" header)
  ;; Which.
  (command "command" :uint8)
  ;; Command-specific.
  (parameters "parameters" (:counted :uint8 33554392)))

;; A node is alive.
(define-message +data-health+ 66 :data 1 "coopobject.data.health" header)
;; Signal strength received by a node.
(define-message +data-rssi+ 66 :data 2 "coopobject.data.rssi" rssi)
;; Readings of a node.
(define-message +data-sensor+ 66 :data 3 "coopobject.data.sensor" data-sensor)
;; Readings of a node that crossed a threshold.
(define-message +data-alarm+ 66 :data 4 "coopobject.data.alarm" data-sensor)
;; Bytes from a node.
(define-message +data-userdefined+ 66 :data 5 "coopobject.data.userdefined" data-userdefined)
;; A request of a node.
(define-message +data-request+ 66 :data 6 "coopobject.data.request" req)
;; A command of a node.
(define-message +data-command+ 66 :data 7 "coopobject.data.command" cmd)
;; Position of a node.
(define-message +data-position+ 66 :data 8 "coopobject.data.position" position)
;; Sends a command to a node.
(define-message +cmd-standard+ 66 :cmd 1 "coopobject.cmd.standard" cmd)
;; Sends bytes to a node.
(define-message +cmd-data+ 66 :cmd 2 "coopobject.cmd.data" data-userdefined)
;; Sends the position of a node to a node.
(define-message +cmd-position+ 66 :cmd 3 "coopobject.cmd.position" position)
;; Sends a request to a node.
(define-message +req-standard+ 66 :req 1 "coopobject.req.standard" req)
