;;;; Interface camera, code 40. Images.
;;;;
;;;; Generated from interfaces/040_camera.toml by codegen; do not edit.

(cl:defpackage #:playhouse.camera
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+format-mono8+ #:+format-mono16+ #:+format-rgb565+ #:+format-rgb888+ #:+compress-raw+
           #:+compress-jpeg+ #:+data-state+ #:+req-get-source+ #:+req-set-source+ #:+req-get-image+ #:data
           #:source #:make-data #:copy-data #:data-p #:data-width #:data-height #:data-bpp #:data-format
           #:data-fdiv #:data-compression #:data-image #:make-source #:copy-source #:source-p #:source-norm
           #:source-source))

(cl:in-package #:playhouse.camera)

(define-interface +code+ 40 "camera")

;;; Values of Data.format.
(define-constants
  (+format-mono8+ 1)
  (+format-mono16+ 2)
  (+format-rgb565+ 4)
  (+format-rgb888+ 5))

;;; Values of Data.compression.
(define-constants
  (+compress-raw+ 0)
  (+compress-jpeg+ 1))

(define-struct (data "camera.Data")
  "One image. (player_camera_data_t)"
  ;; In px.
  (width "width" :uint32)
  ;; In px.
  (height "height" :uint32)
  ;; Per pixel (in bit).
  (bpp "bpp" :uint32)
  ;; Order and size of the colors.
  (format "format" :uint32)
  ;; Divides the values of a disparity image; 1 otherwise.
  (fdiv "fdiv" :uint32)
  ;; Raw or JPEG.
  (compression "compression" :uint32)
  ;; Rows from the top, pixels from the left, or a JPEG file.
  (image "image" (:counted :uint8 33554392)))

(define-struct (source "camera.Source")
  "An input of the camera. (player_camera_source_t)"
  ;; Video norm, such as PAL or NTSC, NUL-terminated.
  (norm "norm" (:counted :char 33554392))
  ;; Index of the input.
  (source "source" :int32))

;; One image.
(define-message +data-state+ 40 :data 1 "camera.data.state" data)
;; Requests the camera's input and norm.
(define-message +req-get-source+ 40 :req 1 "camera.req.get_source" source)
;; Selects the input and norm.
(define-message +req-set-source+ 40 :req 2 "camera.req.set_source" source)
;; Requests one image now.
(define-message +req-get-image+ 40 :req 3 "camera.req.get_image" data)
