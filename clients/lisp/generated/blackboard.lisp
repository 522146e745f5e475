;;;; Interface blackboard, code 64. Named values shared by clients.
;;;;
;;;; Generated from interfaces/064_blackboard.toml by codegen; do not edit.

(cl:defpackage #:playhouse.blackboard
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+req-subscribe-to-key+ #:+req-unsubscribe-from-key+ #:+req-set-entry+
           #:+req-subscribe-to-group+ #:+req-unsubscribe-from-group+ #:+req-get-entry+ #:+data-update+))

(cl:in-package #:playhouse.blackboard)

(define-interface +code+ 64 "blackboard")

;; Subscribes to one entry; the answer has its value.
(define-message +req-subscribe-to-key+ 64 :req 1 "blackboard.req.subscribe_to_key"
  playhouse.common:blackboard-entry)
;; Unsubscribes one entry.
(define-message +req-unsubscribe-from-key+ 64 :req 2 "blackboard.req.unsubscribe_from_key"
  playhouse.common:blackboard-entry)
;; Sets an entry.
(define-message +req-set-entry+ 64 :req 3 "blackboard.req.set_entry" playhouse.common:blackboard-entry)
;; Subscribes to all entries of a group.
(define-message +req-subscribe-to-group+ 64 :req 4 "blackboard.req.subscribe_to_group"
  playhouse.common:blackboard-entry)
;; Unsubscribes a group.
(define-message +req-unsubscribe-from-group+ 64 :req 5 "blackboard.req.unsubscribe_from_group"
  playhouse.common:blackboard-entry)
;; Requests an entry once.
(define-message +req-get-entry+ 64 :req 6 "blackboard.req.get_entry" playhouse.common:blackboard-entry)
;; A subscribed entry has changed.
(define-message +data-update+ 64 :data 1 "blackboard.data.update" playhouse.common:blackboard-entry)
