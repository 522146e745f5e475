;;;; Interface vectormap, code 63. Maps of points, lines and areas in layers.
;;;;
;;;; Generated from interfaces/063_vectormap.toml by codegen; do not edit.

(cl:defpackage #:playhouse.vectormap
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+req-get-map-info+ #:+req-get-layer-data+ #:+req-write-layer+ #:feature-data
           #:layer-info #:layer-data #:info #:make-feature-data #:copy-feature-data #:feature-data-p
           #:feature-data-name #:feature-data-wkb #:feature-data-attrib #:make-layer-info #:copy-layer-info
           #:layer-info-p #:layer-info-name #:layer-info-extent #:make-layer-data #:copy-layer-data
           #:layer-data-p #:layer-data-name #:layer-data-features #:make-info #:copy-info #:info-p
           #:info-srid #:info-layers #:info-extent))

(cl:in-package #:playhouse.vectormap)

(define-interface +code+ 63 "vectormap")

(define-struct (feature-data "vectormap.FeatureData")
  "One feature. (player_vectormap_feature_data_t)"
  (name "name" (:counted :char 33554392))
  ;; Its shape, as OGC well-known binary, in map coordinates.
  (wkb "wkb" (:counted :uint8 33554392))
  ;; Free text.
  (attrib "attrib" (:counted :char 33554392)))

(define-struct (layer-info "vectormap.LayerInfo")
  "Description of a layer. (player_vectormap_layer_info_t)"
  (name "name" (:counted :char 33554392))
  ;; Bounding box of all its features (in m, frame p_MP).
  (extent "extent" playhouse.common:extent2d))

(define-struct (layer-data "vectormap.LayerData")
  "A layer's features. (player_vectormap_layer_data_t)"
  (name "name" (:counted :char 33554392))
  (features "features" (:counted feature-data 1398099 24)))

(define-struct (info "vectormap.Info")
  "List of layers. (player_vectormap_info_t)"
  ;; Id of the spatial reference system; 0: none.
  (srid "srid" :uint32)
  (layers "layers" (:counted layer-info 838859 40))
  ;; Bounding box of all layers (in m, frame p_MP).
  (extent "extent" playhouse.common:extent2d))

;; Requests the list of layers.
(define-message +req-get-map-info+ 63 :req 1 "vectormap.req.get_map_info" info)
;; Requests the features of a layer.
(define-message +req-get-layer-data+ 63 :req 3 "vectormap.req.get_layer_data" layer-data)
;; Replaces the features of a layer.
(define-message +req-write-layer+ 63 :req 4 "vectormap.req.write_layer" layer-data)
