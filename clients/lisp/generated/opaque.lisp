;;;; Interface opaque, code 51. Opaque bytes, defined by the driver and its clients.
;;;;
;;;; Generated from interfaces/051_opaque.toml by codegen; do not edit.

(cl:defpackage #:playhouse.opaque
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+req+ #:+cmd+ #:+data-state+ #:+cmd-data+ #:+req-data+ #:data #:make-data #:copy-data
           #:data-p #:data-data))

(cl:in-package #:playhouse.opaque)

(define-interface +code+ 51 "opaque")

;;; Subtypes under their older names.
(define-constants
  (+req+ 1)
  (+cmd+ 1))

(define-struct (data "opaque.Data")
  "Opaque bytes. (player_opaque_data_t)"
  (data "data" (:counted :uint8 33554392)))

;; Bytes from the driver.
(define-message +data-state+ 51 :data 1 "opaque.data.state" data)
;; Bytes for the driver.
(define-message +cmd-data+ 51 :cmd 1 "opaque.cmd.data" data)
;; Bytes for the driver, which answers with bytes.
(define-message +req-data+ 51 :req 1 "opaque.req.data" data)
