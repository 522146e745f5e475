;;;; Interface player, code 1. The server itself: lists, opens and closes devices, and selects the delivery of
;;;; data. Always open as player:0.
;;;;
;;;; Generated from interfaces/001_player.toml by codegen; do not edit.

(cl:defpackage #:playhouse.player
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+open-mode+ #:+close-mode+ #:+error-mode+ #:+datamode-push+ #:+datamode-pull+
           #:+msg-replace-rule-accept+ #:+msg-replace-rule-replace+ #:+msg-replace-rule-ignore+
           #:+req-devlist+ #:+req-driverinfo+ #:+req-dev+ #:+req-data+ #:+req-datamode+ #:+req-auth+
           #:+req-nameservice+ #:+req-add-replace-rule+ #:+synch-ok+ #:+synch-overflow+ #:device-devlist
           #:device-driverinfo #:device-req #:device-datamode-req #:device-auth-req #:device-nameservice-req
           #:add-replace-rule-req #:make-device-devlist #:copy-device-devlist #:device-devlist-p
           #:device-devlist-devices #:make-device-driverinfo #:copy-device-driverinfo #:device-driverinfo-p
           #:device-driverinfo-addr #:device-driverinfo-driver-name #:make-device-req #:copy-device-req
           #:device-req-p #:device-req-addr #:device-req-access #:device-req-driver-name
           #:make-device-datamode-req #:copy-device-datamode-req #:device-datamode-req-p
           #:device-datamode-req-mode #:make-device-auth-req #:copy-device-auth-req #:device-auth-req-p
           #:device-auth-req-auth-key #:make-device-nameservice-req #:copy-device-nameservice-req
           #:device-nameservice-req-p #:device-nameservice-req-name #:device-nameservice-req-port
           #:make-add-replace-rule-req #:copy-add-replace-rule-req #:add-replace-rule-req-p
           #:add-replace-rule-req-interf #:add-replace-rule-req-index #:add-replace-rule-req-type
           #:add-replace-rule-req-subtype #:add-replace-rule-req-replace))

(cl:in-package #:playhouse.player)

(define-interface +code+ 1 "player")

;;; Values of DeviceReq.access.
(define-constants
  (+open-mode+ 1)
  (+close-mode+ 2)
  (+error-mode+ 3))

;;; Values of DeviceDatamodeReq.mode.
(define-constants
  (+datamode-push+ 1)
  (+datamode-pull+ 2))

;;; Values of AddReplaceRuleReq.replace.
(define-constants
  (+msg-replace-rule-accept+ 0)
  (+msg-replace-rule-replace+ 1)
  (+msg-replace-rule-ignore+ 2))

(define-struct (device-devlist "player.DeviceDevlist")
  "The devices of a server. (player_device_devlist_t)"
  ;; In the order of creation, without player:0.
  (devices "devices" (:bounded playhouse.common:devaddr 4096 16)))

(define-struct (device-driverinfo "player.DeviceDriverinfo")
  "A device and the driver behind it. (player_device_driverinfo_t)"
  ;; The queried device.
  (addr "addr" playhouse.common:devaddr)
  ;; NUL-terminated; empty in the request.
  (driver-name "driver_name" (:bounded :char 64)))

(define-struct (device-req "player.DeviceReq")
  "Request to open or close a device, and its answer. (player_device_req_t)"
  ;; The device; in the answer, completed with host and robot.
  (addr "addr" playhouse.common:devaddr)
  ;; Requested or granted access.
  (access "access" :uint8)
  ;; NUL-terminated; empty in the request.
  (driver-name "driver_name" (:bounded :char 64)))

(define-struct (device-datamode-req "player.DeviceDatamodeReq")
  "A delivery mode. (player_device_datamode_req_t)"
  ;; Push or pull.
  (mode "mode" :uint8))

(define-struct (device-auth-req "player.DeviceAuthReq")
  "A key. (player_device_auth_req_t)"
  (auth-key "auth_key" (:bounded :uint8 32)))

(define-struct (device-nameservice-req "player.DeviceNameserviceReq")
  "A robot's name and its port. (player_device_nameservice_req_t)"
  (name "name" (:bounded :uint8 64))
  ;; 0 in the request.
  (port "port" :uint16))

(define-struct (add-replace-rule-req "player.AddReplaceRuleReq")
  "Messages to which a rule applies, and its effect; -1 matches anything. (player_add_replace_rule_req_t)"
  ;; Interface code, or -1.
  (interf "interf" :int32)
  ;; Device index, or -1.
  (index "index" :int32)
  ;; Message type, or -1.
  (type "type" :int32)
  ;; Message subtype, or -1.
  (subtype "subtype" :int32)
  ;; Keep all, keep the newest, or drop.
  (replace "replace" :int32))

;; Lists the devices that this connection can open.
(define-message +req-devlist+ 1 :req 1 "player.req.devlist" device-devlist)
;; Requests the name of the driver behind a device.
(define-message +req-driverinfo+ 1 :req 2 "player.req.driverinfo" device-driverinfo)
;; Opens or closes a device; the answer has the granted access.
(define-message +req-dev+ 1 :req 3 "player.req.dev" device-req)
;; Requests one round of data, in pull mode; a synch ends the round.
(define-message +req-data+ 1 :req 4 "player.req.data")
;; Selects the delivery mode: immediately (push) or on request (pull).
(define-message +req-datamode+ 1 :req 5 "player.req.datamode" device-datamode-req)
;; Sends an authentication key: a guest's token, of a run with access control (docs/guests.md); NACK if it
;; admits nobody.
(define-message +req-auth+ 1 :req 7 "player.req.auth" device-auth-req)
;; Requests the port of a named robot; unused, answered by NACK.
(define-message +req-nameservice+ 1 :req 8 "player.req.nameservice" device-nameservice-req)
;; Adds a replace rule: which queued messages a newer one replaces.
(define-message +req-add-replace-rule+ 1 :req 10 "player.req.add_replace_rule" add-replace-rule-req)
;; Ends a round of data; no message was dropped since the previous one.
(define-message +synch-ok+ 1 :synch 1 "player.synch.ok")
;; Ends a round of data; the body is the number of messages dropped since the previous one.
(define-message +synch-overflow+ 1 :synch 2 "player.synch.overflow" playhouse.common:uint32)
