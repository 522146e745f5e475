;;;; Interface power, code 2. Battery and charger of a robot.
;;;;
;;;; Generated from interfaces/002_power.toml by codegen; do not edit.

(cl:defpackage #:playhouse.power
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+mask-volts+ #:+mask-watts+ #:+mask-joules+ #:+mask-percent+ #:+mask-charging+
           #:+data-state+ #:+req-set-charging-policy+ #:data #:chargepolicy-config #:make-data #:copy-data
           #:data-p #:data-valid #:data-volts #:data-percent #:data-joules #:data-watts #:data-charging
           #:make-chargepolicy-config #:copy-chargepolicy-config #:chargepolicy-config-p
           #:chargepolicy-config-enable-input #:chargepolicy-config-enable-output))

(cl:in-package #:playhouse.power)

(define-interface +code+ 2 "power")

;;; Bits of Data.valid: valid fields.
(define-constants
  (+mask-volts+ 1)
  (+mask-watts+ 2)
  (+mask-joules+ 4)
  (+mask-percent+ 8)
  (+mask-charging+ 16))

(define-struct (data "power.Data")
  "State of charge; only the fields flagged in `valid` apply. (player_power_data_t)"
  ;; Bits of the valid fields.
  (valid "valid" :uint32)
  ;; In V.
  (volts "volts" :float32)
  ;; Percentage of a full charge, 0 to 100 (in %).
  (percent "percent" :float32)
  ;; Remaining energy (in J).
  (joules "joules" :float32)
  ;; Power drawn from the battery; negative while charging (in W).
  (watts "watts" :float32)
  ;; 1 charging, 0 not, -1 charging is impossible.
  (charging "charging" :int32))

(define-struct (chargepolicy-config "power.ChargepolicyConfig")
  "Enabled flows of power. (player_power_chargepolicy_config_t)"
  ;; 1: the battery may be charged.
  (enable-input "enable_input" :uint8)
  ;; 1: the battery may supply others.
  (enable-output "enable_output" :uint8))

;; State of charge.
(define-message +data-state+ 2 :data 1 "power.data.state" data)
;; Enables or disables charging and discharging of the battery.
(define-message +req-set-charging-policy+ 2 :req 1 "power.req.set_charging_policy" chargepolicy-config)
