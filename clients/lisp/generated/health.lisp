;;;; Interface health, code 59. Load of a computer.
;;;;
;;;; Generated from interfaces/059_health.toml by codegen; do not edit.

(cl:defpackage #:playhouse.health
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-state+ #:cpu #:memory #:data #:make-cpu #:copy-cpu #:cpu-p #:cpu-idle
           #:cpu-system #:cpu-user #:make-memory #:copy-memory #:memory-p #:memory-total #:memory-used
           #:memory-free #:make-data #:copy-data #:data-p #:data-cpu-usage #:data-mem #:data-swap))

(cl:in-package #:playhouse.health)

(define-interface +code+ 59 "health")

(define-struct (cpu "health.Cpu")
  "Processor load. (player_health_cpu_t)"
  ;; Idle time (in %).
  (idle "idle" :float32)
  ;; Time in the operating system (in %).
  (system "system" :float32)
  ;; Time in programs (in %).
  (user "user" :float32))

(define-struct (memory "health.Memory")
  "Usage of a type of memory. (player_health_memory_t)"
  ;; In byte.
  (total "total" :int64)
  ;; In byte.
  (used "used" :int64)
  ;; In byte.
  (free "free" :int64))

(define-struct (data "health.Data")
  "Load of processor and memory. (player_health_data_t)"
  (cpu-usage "cpu_usage" cpu)
  (mem "mem" memory)
  (swap "swap" memory))

;; Load of processor and memory.
(define-message +data-state+ 59 :data 1 "health.data.state" data)
