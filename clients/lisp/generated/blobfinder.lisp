;;;; Interface blobfinder, code 7. Finds regions of one color (blobs) in camera images.
;;;;
;;;; Generated from interfaces/007_blobfinder.toml by codegen; do not edit.

(cl:defpackage #:playhouse.blobfinder
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-blobs+ #:+req-set-color+ #:+req-set-imager-params+ #:+req-get-color+ #:blob
           #:data #:color-config #:imager-config #:make-blob #:copy-blob #:blob-p #:blob-id #:blob-color
           #:blob-area #:blob-x #:blob-y #:blob-left #:blob-right #:blob-top #:blob-bottom #:blob-range
           #:make-data #:copy-data #:data-p #:data-width #:data-height #:data-blobs #:make-color-config
           #:copy-color-config #:color-config-p #:color-config-channel #:color-config-rmin
           #:color-config-rmax #:color-config-gmin #:color-config-gmax #:color-config-bmin
           #:color-config-bmax #:make-imager-config #:copy-imager-config #:imager-config-p
           #:imager-config-brightness #:imager-config-contrast #:imager-config-colormode
           #:imager-config-autogain))

(cl:in-package #:playhouse.blobfinder)

(define-interface +code+ 7 "blobfinder")

(define-struct (blob "blobfinder.Blob")
  "A blob. Pixel coordinates start at the top left corner of the image. (player_blobfinder_blob_t)"
  ;; Channel that detected it.
  (id "id" :uint32)
  ;; 0xRRGGBB, for display.
  (color "color" :uint32)
  ;; Area in pixels (in px).
  (area "area" :uint32)
  ;; Column of its centre (in px).
  (x "x" :uint32)
  ;; Row of its centre (in px).
  (y "y" :uint32)
  ;; First column (in px).
  (left "left" :uint32)
  ;; Last column (in px).
  (right "right" :uint32)
  ;; First row (in px).
  (top "top" :uint32)
  ;; Last row (in px).
  (bottom "bottom" :uint32)
  ;; Distance; 0 if unknown (in m).
  (range "range" :float32))

(define-struct (data "blobfinder.Data")
  "The blobs of one image. (player_blobfinder_data_t)"
  ;; Of the image (in px).
  (width "width" :uint32)
  ;; Of the image (in px).
  (height "height" :uint32)
  (blobs "blobs" (:counted blob 838859 40)))

(define-struct (color-config "blobfinder.ColorConfig")
  "The colors that a channel detects, as ranges of red, green and blue. (player_blobfinder_color_config_t)"
  ;; Channel; -1 means all (signed).
  (channel "channel" :int32)
  (rmin "rmin" :uint32)
  (rmax "rmax" :uint32)
  (gmin "gmin" :uint32)
  (gmax "gmax" :uint32)
  (bmin "bmin" :uint32)
  (bmax "bmax" :uint32))

(define-struct (imager-config "blobfinder.ImagerConfig")
  "Settings of the camera; -1 leaves a setting unchanged. (player_blobfinder_imager_config_t)"
  ;; 0 to 255.
  (brightness "brightness" :int32)
  ;; 0 to 255.
  (contrast "contrast" :int32)
  ;; 0 RGB, 1 RGB without white balance, 2 YUV, 3 YUV without white balance.
  (colormode "colormode" :int32)
  ;; 0 off, 1 on.
  (autogain "autogain" :int32))

;; The blobs of one image.
(define-message +data-blobs+ 7 :data 1 "blobfinder.data.blobs" data)
;; Sets the colors that a channel detects.
(define-message +req-set-color+ 7 :req 1 "blobfinder.req.set_color" color-config)
;; Sets brightness, contrast and other settings of the camera.
(define-message +req-set-imager-params+ 7 :req 2 "blobfinder.req.set_imager_params" imager-config)
;; Requests the colors that a channel detects.
(define-message +req-get-color+ 7 :req 3 "blobfinder.req.get_color" color-config)
