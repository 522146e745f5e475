;;;; Interface wsn, code 57. A network of wireless sensor nodes.
;;;;
;;;; Generated from interfaces/057_wsn.toml by codegen; do not edit.

(cl:defpackage #:playhouse.wsn
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-state+ #:+cmd-devstate+ #:+req-power+ #:+req-datatype+ #:+req-datafreq+
           #:node-data #:data #:cmd #:power-config #:datatype-config #:datafreq-config #:make-node-data
           #:copy-node-data #:node-data-p #:node-data-light #:node-data-mic #:node-data-accel-x
           #:node-data-accel-y #:node-data-accel-z #:node-data-magn-x #:node-data-magn-y #:node-data-magn-z
           #:node-data-temperature #:node-data-battery #:make-data #:copy-data #:data-p #:data-node-type
           #:data-node-id #:data-node-parent-id #:data-data-packet #:make-cmd #:copy-cmd #:cmd-p
           #:cmd-node-id #:cmd-group-id #:cmd-device #:cmd-enable #:make-power-config #:copy-power-config
           #:power-config-p #:power-config-node-id #:power-config-group-id #:power-config-value
           #:make-datatype-config #:copy-datatype-config #:datatype-config-p #:datatype-config-value
           #:make-datafreq-config #:copy-datafreq-config #:datafreq-config-p #:datafreq-config-node-id
           #:datafreq-config-group-id #:datafreq-config-frequency))

(cl:in-package #:playhouse.wsn)

(define-interface +code+ 57 "wsn")

(define-struct (node-data "wsn.NodeData")
  "Readings, raw or converted as selected by DATATYPE. (player_wsn_node_data_t)"
  ;; In 1 or lx.
  (light "light" :float32)
  (mic "mic" :float32)
  ;; In 1 or m/s^2.
  (accel-x "accel_x" :float32)
  ;; In 1 or m/s^2.
  (accel-y "accel_y" :float32)
  ;; In 1 or m/s^2.
  (accel-z "accel_z" :float32)
  ;; In 1 or G.
  (magn-x "magn_x" :float32)
  ;; In 1 or G.
  (magn-y "magn_y" :float32)
  ;; In 1 or G.
  (magn-z "magn_z" :float32)
  ;; In 1 or degC.
  (temperature "temperature" :float32)
  ;; In 1 or V.
  (battery "battery" :float32))

(define-struct (data "wsn.Data")
  "Readings of one node. (player_wsn_data_t)"
  ;; Type of node.
  (node-type "node_type" :uint32)
  ;; Id of the node.
  (node-id "node_id" :uint32)
  ;; Node that relayed the readings.
  (node-parent-id "node_parent_id" :uint32)
  (data-packet "data_packet" node-data))

(define-struct (cmd "wsn.Cmd")
  "Switch of an actuator of a node. (player_wsn_cmd_t)"
  ;; Id of the node; -1: all.
  (node-id "node_id" :int32)
  ;; Group of the node; -1: all.
  (group-id "group_id" :int32)
  ;; Actuator, such as a light or a buzzer.
  (device "device" :uint32)
  ;; 1: on, 0: off.
  (enable "enable" :uint8))

(define-struct (power-config "wsn.PowerConfig")
  "Sleep mode of nodes. (player_wsn_power_config_t)"
  ;; Id of the node; -1: all.
  (node-id "node_id" :int32)
  ;; Group of the node; -1: all.
  (group-id "group_id" :int32)
  ;; 0: asleep, 1: awake, 2: driver-specific.
  (value "value" :uint8))

(define-struct (datatype-config "wsn.DatatypeConfig")
  "Format of readings. (player_wsn_datatype_config_t)"
  ;; 0: raw, 1: converted.
  (value "value" :uint8))

(define-struct (datafreq-config "wsn.DatafreqConfig")
  "Rate of reports. (player_wsn_datafreq_config_t)"
  ;; Id of the node; -1: all.
  (node-id "node_id" :int32)
  ;; Group of the node; -1: all.
  (group-id "group_id" :int32)
  ;; In Hz.
  (frequency "frequency" :float64))

;; Readings of one node.
(define-message +data-state+ 57 :data 1 "wsn.data.state" data)
;; Switches an actuator of a node.
(define-message +cmd-devstate+ 57 :cmd 1 "wsn.cmd.devstate" cmd)
;; Puts nodes to sleep or wakes them.
(define-message +req-power+ 57 :req 1 "wsn.req.power" power-config)
;; Selects between raw and converted readings.
(define-message +req-datatype+ 57 :req 2 "wsn.req.datatype" datatype-config)
;; Sets the reporting rate of nodes.
(define-message +req-datafreq+ 57 :req 3 "wsn.req.datafreq" datafreq-config)
