;;;; Interface map, code 42. Grid and vector maps.
;;;;
;;;; Generated from interfaces/042_map.toml by codegen; do not edit.

(cl:defpackage #:playhouse.map
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-info+ #:+req-get-info+ #:+req-get-data+ #:+req-get-vector+ #:info #:data
           #:data-vector #:make-info #:copy-info #:info-p #:info-scale #:info-width #:info-height
           #:info-origin #:make-data #:copy-data #:data-p #:data-col #:data-row #:data-width #:data-height
           #:data-data-range #:data-data #:make-data-vector #:copy-data-vector #:data-vector-p
           #:data-vector-minx #:data-vector-maxx #:data-vector-miny #:data-vector-maxy
           #:data-vector-segments))

(cl:in-package #:playhouse.map)

(define-interface +code+ 42 "map")

(define-struct (info "map.Info")
  "Size, scale and origin of the map. (player_map_info_t)"
  ;; Cell size (in m/pixel).
  (scale "scale" :float32)
  ;; In px.
  (width "width" :uint32)
  ;; In px.
  (height "height" :uint32)
  ;; Of the lower left corner of cell (0, 0) (in m, m, rad, frame X_WM).
  (origin "origin" playhouse.common:pose2d))

(define-struct (data "map.Data")
  "A rectangle of cells. (player_map_data_t)"
  ;; First column, from the left (in px).
  (col "col" :uint32)
  ;; First row, from the bottom (in px).
  (row "row" :uint32)
  ;; In px.
  (width "width" :uint32)
  ;; In px.
  (height "height" :uint32)
  ;; Value of a cell that is certainly occupied; its negative: certainly free, 0: unknown.
  (data-range "data_range" :int8)
  ;; Rows, concatenated; compressed with zlib in an answer, empty in a request.
  (data "data" (:counted :int8 33554392) :count-before data-range))

(define-struct (data-vector "map.DataVector")
  "The map as line segments, and its extent. (player_map_data_vector_t)"
  ;; In m.
  (minx "minx" :float32)
  ;; In m.
  (maxx "maxx" :float32)
  ;; In m.
  (miny "miny" :float32)
  ;; In m.
  (maxy "maxy" :float32)
  ;; One per line (in m, frame p_MP).
  (segments "segments" (:counted playhouse.common:segment 1048574 32)))

;; Size and scale of the map, sent on change.
(define-message +data-info+ 42 :data 1 "map.data.info" info)
;; Requests the size and scale of the map.
(define-message +req-get-info+ 42 :req 1 "map.req.get_info" info)
;; Requests a rectangle of cells; the answer's cells are compressed with zlib.
(define-message +req-get-data+ 42 :req 2 "map.req.get_data" data)
;; Requests the map as lines.
(define-message +req-get-vector+ 42 :req 3 "map.req.get_vector" data-vector)
