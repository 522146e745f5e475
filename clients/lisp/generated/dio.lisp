;;;; Interface dio, code 20. Digital inputs and outputs.
;;;;
;;;; Generated from interfaces/020_dio.toml by codegen; do not edit.

(cl:defpackage #:playhouse.dio
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-values+ #:+cmd-values+ #:data #:cmd #:make-data #:copy-data #:data-p
           #:data-count #:data-bits #:make-cmd #:copy-cmd #:cmd-p #:cmd-count #:cmd-digout))

(cl:in-package #:playhouse.dio)

(define-interface +code+ 20 "dio")

(define-struct (data "dio.Data")
  "State of the inputs. (player_dio_data_t)"
  ;; Number of valid bits.
  (count "count" :uint32)
  ;; One bit per input, the first in the lowest bit.
  (bits "bits" :uint32))

(define-struct (cmd "dio.Cmd")
  "Commanded state of the outputs. (player_dio_cmd_t)"
  ;; Number of valid bits.
  (count "count" :uint32)
  ;; One bit per output, the first in the lowest bit.
  (digout "digout" :uint32))

;; State of the inputs.
(define-message +data-values+ 20 :data 1 "dio.data.values" data)
;; Commanded state of the outputs.
(define-message +cmd-values+ 20 :cmd 1 "dio.cmd.values" cmd)
