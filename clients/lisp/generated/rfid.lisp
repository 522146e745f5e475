;;;; Interface rfid, code 56. Reads and writes radio tags.
;;;;
;;;; Generated from interfaces/056_rfid.toml by codegen; do not edit.

(cl:defpackage #:playhouse.rfid
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-tags+ #:+req-power+ #:+req-readtag+ #:+req-writetag+ #:+req-locktag+ #:tag
           #:data #:make-tag #:copy-tag #:tag-p #:tag-type #:tag-guid #:make-data #:copy-data #:data-p
           #:data-tags))

(cl:in-package #:playhouse.rfid)

(define-interface +code+ 56 "rfid")

(define-struct (tag "rfid.Tag")
  "One tag. (player_rfid_tag_t)"
  ;; Type of tag.
  (type "type" :uint32)
  ;; Id of the tag, as bytes.
  (guid "guid" (:counted :char 33554392)))

(define-struct (data "rfid.Data")
  "Tags in range. (player_rfid_data_t)"
  (tags "tags" (:counted tag 2796199 12)))

;; Tags in range.
(define-message +data-tags+ 56 :data 1 "rfid.data.tags" data)
;; Switches the reader on or off.
(define-message +req-power+ 56 :req 1 "rfid.req.power")
;; Reads a tag.
(define-message +req-readtag+ 56 :req 2 "rfid.req.readtag")
;; Writes a tag.
(define-message +req-writetag+ 56 :req 3 "rfid.req.writetag")
;; Locks a tag against writing.
(define-message +req-locktag+ 56 :req 4 "rfid.req.locktag")
