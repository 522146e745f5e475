;;;; Interface log, code 45. Records data of devices to a file, or plays back such a file.
;;;;
;;;; Generated from interfaces/045_log.toml by codegen; do not edit.

(cl:defpackage #:playhouse.log
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+type-read+ #:+type-write+ #:+req-set-write-state+ #:+req-set-read-state+
           #:+req-get-state+ #:+req-set-read-rewind+ #:+req-set-filename+ #:set-write-state #:set-read-state
           #:get-state #:set-filename #:make-set-write-state #:copy-set-write-state #:set-write-state-p
           #:set-write-state-state #:make-set-read-state #:copy-set-read-state #:set-read-state-p
           #:set-read-state-state #:make-get-state #:copy-get-state #:get-state-p #:get-state-type
           #:get-state-state #:make-set-filename #:copy-set-filename #:set-filename-p
           #:set-filename-filename))

(cl:in-package #:playhouse.log)

(define-interface +code+ 45 "log")

;;; Values of GetState.type.
(define-constants
  (+type-read+ 1)
  (+type-write+ 2))

(define-struct (set-write-state "log.SetWriteState")
  "Whether data is being recorded. (player_log_set_write_state_t)"
  ;; 1: on, 0: off.
  (state "state" :uint8))

(define-struct (set-read-state "log.SetReadState")
  "Whether the file is being played. (player_log_set_read_state_t)"
  ;; 1: on, 0: off.
  (state "state" :uint8))

(define-struct (get-state "log.GetState")
  "Type and state of the device. (player_log_get_state_t)"
  ;; Reader or writer.
  (type "type" :uint8)
  ;; 1: running, 0: stopped.
  (state "state" :uint8))

(define-struct (set-filename "log.SetFilename")
  "The file to write to. (player_log_set_filename_t)"
  ;; NUL-terminated.
  (filename "filename" (:bounded :char 256)))

;; Starts or stops writing.
(define-message +req-set-write-state+ 45 :req 1 "log.req.set_write_state" set-write-state)
;; Starts or stops playing.
(define-message +req-set-read-state+ 45 :req 2 "log.req.set_read_state" set-read-state)
;; Requests the type and state of the device.
(define-message +req-get-state+ 45 :req 3 "log.req.get_state" get-state)
;; Rewinds to the start of the file.
(define-message +req-set-read-rewind+ 45 :req 4 "log.req.set_read_rewind")
;; Sets the file to write to.
(define-message +req-set-filename+ 45 :req 5 "log.req.set_filename" set-filename)
