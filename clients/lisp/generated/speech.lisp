;;;; Interface speech, code 12. Speaks text.
;;;;
;;;; Generated from interfaces/012_speech.toml by codegen; do not edit.

(cl:defpackage #:playhouse.speech
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+cmd-say+ #:cmd #:make-cmd #:copy-cmd #:cmd-p #:cmd-string))

(cl:in-package #:playhouse.speech)

(define-interface +code+ 12 "speech")

(define-struct (cmd "speech.Cmd")
  "A text to speak. (player_speech_cmd_t)"
  ;; NUL-terminated.
  (string "string" (:counted :char 33554392)))

;; Speaks a text; texts are spoken one after the other.
(define-message +cmd-say+ 12 :cmd 1 "speech.cmd.say" cmd)
