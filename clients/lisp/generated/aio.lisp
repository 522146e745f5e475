;;;; Interface aio, code 21. Analog inputs and outputs.
;;;;
;;;; Generated from interfaces/021_aio.toml by codegen; do not edit.

(cl:defpackage #:playhouse.aio
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+cmd-state+ #:+data-state+ #:data #:cmd #:make-data #:copy-data #:data-p
           #:data-voltages #:make-cmd #:copy-cmd #:cmd-p #:cmd-id #:cmd-voltage))

(cl:in-package #:playhouse.aio)

(define-interface +code+ 21 "aio")

(define-struct (data "aio.Data")
  "Voltages of the inputs. (player_aio_data_t)"
  ;; In V.
  (voltages "voltages" (:counted :float32 8388598)))

(define-struct (cmd "aio.Cmd")
  "Commanded voltage of one output. (player_aio_cmd_t)"
  ;; Index of the output.
  (id "id" :uint32)
  ;; In V.
  (voltage "voltage" :float32))

;; Commanded voltage of one output.
(define-message +cmd-state+ 21 :cmd 1 "aio.cmd.state" cmd)
;; Voltages of the inputs.
(define-message +data-state+ 21 :data 1 "aio.data.state" data)
