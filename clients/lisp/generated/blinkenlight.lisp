;;;; Interface blinkenlight, code 33. Lights that can be switched, colored and made to blink.
;;;;
;;;; Generated from interfaces/033_blinkenlight.toml by codegen; do not edit.

(cl:defpackage #:playhouse.blinkenlight
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-state+ #:+cmd-state+ #:+cmd-power+ #:+cmd-color+ #:+cmd-flash+ #:data #:cmd
           #:cmd-power #:cmd-color #:cmd-flash #:make-data #:copy-data #:data-p #:data-enable #:data-period
           #:data-dutycycle #:data-color #:make-cmd #:copy-cmd #:cmd-p #:cmd-id #:cmd-enable #:cmd-period
           #:cmd-dutycycle #:make-cmd-power #:copy-cmd-power #:cmd-power-p #:cmd-power-id #:cmd-power-enable
           #:make-cmd-color #:copy-cmd-color #:cmd-color-p #:cmd-color-id #:cmd-color-color #:make-cmd-flash
           #:copy-cmd-flash #:cmd-flash-p #:cmd-flash-id #:cmd-flash-period #:cmd-flash-dutycycle))

(cl:in-package #:playhouse.blinkenlight)

(define-interface +code+ 33 "blinkenlight")

(define-struct (data "blinkenlight.Data")
  "State of the light. (player_blinkenlight_data_t)"
  ;; 1: on, 0: off.
  (enable "enable" :uint8)
  ;; Blinking period; 0: steady light (in s).
  (period "period" :float32)
  ;; Duty cycle: fraction of the period in which the light is on, 0 to 1.
  (dutycycle "dutycycle" :float32)
  (color "color" playhouse.common:color))

(define-struct (cmd "blinkenlight.Cmd")
  "Commanded state of one light. (player_blinkenlight_cmd_t)"
  ;; Index of the light.
  (id "id" :uint16)
  ;; 1: on, 0: off.
  (enable "enable" :uint8)
  ;; Blinking period; 0: steady light (in s).
  (period "period" :float32)
  ;; Duty cycle: fraction of the period in which the light is on, 0 to 1.
  (dutycycle "dutycycle" :float32)
  (color "color" playhouse.common:color))

(define-struct (cmd-power "blinkenlight.CmdPower")
  "Switch of one light. (player_blinkenlight_cmd_power_t)"
  ;; Index of the light.
  (id "id" :uint16)
  ;; 1: on, 0: off.
  (enable "enable" :uint8))

(define-struct (cmd-color "blinkenlight.CmdColor")
  "Color of one light. (player_blinkenlight_cmd_color_t)"
  ;; Index of the light.
  (id "id" :uint16)
  (color "color" playhouse.common:color))

(define-struct (cmd-flash "blinkenlight.CmdFlash")
  "Blinking of one light. (player_blinkenlight_cmd_flash_t)"
  ;; Index of the light.
  (id "id" :uint16)
  ;; Blinking period (in s).
  (period "period" :float32)
  ;; Duty cycle: fraction of the period in which the light is on, 0 to 1.
  (dutycycle "dutycycle" :float32))

;; State of the light.
(define-message +data-state+ 33 :data 1 "blinkenlight.data.state" data)
;; Sets all properties of one light.
(define-message +cmd-state+ 33 :cmd 1 "blinkenlight.cmd.state" cmd)
;; Switches one light.
(define-message +cmd-power+ 33 :cmd 2 "blinkenlight.cmd.power" cmd-power)
;; Colors one light.
(define-message +cmd-color+ 33 :cmd 3 "blinkenlight.cmd.color" cmd-color)
;; Makes one light blink.
(define-message +cmd-flash+ 33 :cmd 4 "blinkenlight.cmd.flash" cmd-flash)
