;;;; Interface speech_recognition, code 50. Reports recognised speech.
;;;;
;;;; Generated from interfaces/050_speech_recognition.toml by codegen; do not edit.

(cl:defpackage #:playhouse.speech-recognition
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-string+ #:data #:make-data #:copy-data #:data-p #:data-text))

(cl:in-package #:playhouse.speech-recognition)

(define-interface +code+ 50 "speech_recognition")

(define-struct (data "speech_recognition.Data")
  "Recognised speech. (player_speech_recognition_data_t)"
  ;; NUL-terminated.
  (text "text" (:counted :char 33554392)))

;; Recognised words.
(define-message +data-string+ 50 :data 1 "speech_recognition.data.string" data)
