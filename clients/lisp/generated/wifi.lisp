;;;; Interface wifi, code 23. State of wireless network links.
;;;;
;;;; Generated from interfaces/023_wifi.toml by codegen; do not edit.

(cl:defpackage #:playhouse.wifi
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+qual-dbm+ #:+qual-rel+ #:+qual-unknown+ #:+mode-unknown+ #:+mode-auto+ #:+mode-adhoc+
           #:+mode-infra+ #:+mode-master+ #:+mode-repeat+ #:+mode-second+ #:+req-mac+ #:+req-iwspy-add+
           #:+req-iwspy-del+ #:+req-iwspy-ping+ #:+data-state+ #:link #:data #:mac-req #:iwspy-addr-req
           #:make-link #:copy-link #:link-p #:link-mac #:link-ip #:link-essid #:link-mode #:link-freq
           #:link-encrypt #:link-qual #:link-level #:link-noise #:make-data #:copy-data #:data-p
           #:data-links #:data-throughput #:data-bitrate #:data-mode #:data-qual-type #:data-maxqual
           #:data-maxlevel #:data-maxnoise #:data-ap #:make-mac-req #:copy-mac-req #:mac-req-p #:mac-req-mac
           #:make-iwspy-addr-req #:copy-iwspy-addr-req #:iwspy-addr-req-p #:iwspy-addr-req-address))

(cl:in-package #:playhouse.wifi)

(define-interface +code+ 23 "wifi")

;;; Values of Data.qual_type: unit of link quality.
(define-constants
  (+qual-dbm+ 1)
  (+qual-rel+ 2)
  (+qual-unknown+ 3))

;;; Values of Data.mode and Link.mode.
(define-constants
  (+mode-unknown+ 0)
  (+mode-auto+ 1)
  (+mode-adhoc+ 2)
  (+mode-infra+ 3)
  (+mode-master+ 4)
  (+mode-repeat+ 5)
  (+mode-second+ 6))

(define-struct (link "wifi.Link")
  "One link. (player_wifi_link_t)"
  ;; Hardware address, as a string.
  (mac "mac" (:bounded :uint8 32))
  ;; Network address, as a string.
  (ip "ip" (:bounded :uint8 32))
  ;; Name of the network, as a string.
  (essid "essid" (:bounded :uint8 32))
  ;; Role in the network.
  (mode "mode" :uint32)
  ;; In MHz.
  (freq "freq" :uint32)
  ;; 0: open, else encrypted.
  (encrypt "encrypt" :uint32)
  ;; Quality, up to Data.maxqual.
  (qual "qual" :uint32)
  ;; Signal, up to Data.maxlevel (signed).
  (level "level" :int32)
  ;; Noise, up to Data.maxnoise (signed).
  (noise "noise" :int32))

(define-struct (data "wifi.Data")
  "Every link and the state of the card. (player_wifi_data_t)"
  (links "links" (:counted link 699049 48))
  ;; Estimated throughput of the card (in bit/s).
  (throughput "throughput" :uint32)
  ;; Configured bit rate of the card (in bit/s).
  (bitrate "bitrate" :uint32)
  ;; Role in the network.
  (mode "mode" :uint32)
  ;; Unit of quality, level and noise.
  (qual-type "qual_type" :uint32)
  ;; Maximum reported quality.
  (maxqual "maxqual" :uint32)
  ;; Maximum reported signal level (signed).
  (maxlevel "maxlevel" :int32)
  ;; Maximum reported noise level (signed).
  (maxnoise "maxnoise" :int32)
  ;; Hardware address of the access point, as a string.
  (ap "ap" (:array :char 32)))

(define-struct (mac-req "wifi.MacReq")
  "The card's own address. (player_wifi_mac_req_t)"
  ;; Hardware address, as a string.
  (mac "mac" (:bounded :uint8 32)))

(define-struct (iwspy-addr-req "wifi.IwspyAddrReq")
  "The address of a station. (player_wifi_iwspy_addr_req_t)"
  ;; Hardware address, as a string.
  (address "address" (:array :char 32)))

;; Requests the card's own address.
(define-message +req-mac+ 23 :req 1 "wifi.req.mac" mac-req)
;; Starts monitoring the links to an address.
(define-message +req-iwspy-add+ 23 :req 2 "wifi.req.iwspy_add" iwspy-addr-req)
;; Stops monitoring the links to an address.
(define-message +req-iwspy-del+ 23 :req 3 "wifi.req.iwspy_del" iwspy-addr-req)
;; Sends a packet to an address to measure its link.
(define-message +req-iwspy-ping+ 23 :req 4 "wifi.req.iwspy_ping" iwspy-addr-req)
;; Every link and the state of the card.
(define-message +data-state+ 23 :data 1 "wifi.data.state" data)
