;;;; Images of cameras, and the pixels of raw ones.

(in-package #:playhouse-client)

(defstruct (image (:constructor make-image (width height format jpeg-p data time)))
  "An image: rows from the top, pixels from the left. `format' is one of playhouse.camera:+format-mono8+,
+format-mono16+ (of Playhouse: depth in mm, little-endian, 0 if nothing is in range), +format-rgb565+ and
+format-rgb888+. `data' is the pixels, or a JPEG file if `jpeg-p'. `time' is the server's, in s."
  width height format jpeg-p data time)

(defun pixel (image column row)
  "A list: red, green, blue, or the brightness, or the depth in mm. Signals invalid-value for a JPEG file, for other
formats, outside the image, and if the data are shorter than the image."
  (multiple-value-bind (bytes-of-channel channels) (channels-of image)
    (unless (and (< -1 column (image-width image)) (< -1 row (image-height image)))
      (fail 'invalid-value "pixel ~d, ~d is outside the ~d x ~d picture" column row (image-width image)
            (image-height image)))
    (let* ((size (* bytes-of-channel channels))
           (first (* size (+ column (* row (image-width image)))))
           (data (image-data image)))
      (when (> (+ first size) (length data))
        (fail 'invalid-value "the picture has fewer bytes than pixels: ~d" (length data)))
      (loop repeat channels
            for at from first by bytes-of-channel
            collect (loop for i below bytes-of-channel sum (ash (elt data (+ at i)) (* 8 i)))))))

(defun channels-of (image)
  "Bytes of a channel and channels of a pixel."
  (let ((format (image-format image)))
    (cond ((image-jpeg-p image) (refuse-pixels))
          ((= format playhouse.camera:+format-mono8+) (values 1 1))
          ((= format playhouse.camera:+format-mono16+) (values 2 1))
          ((= format playhouse.camera:+format-rgb888+) (values 1 3))
          (t (refuse-pixels)))))

(defun refuse-pixels ()
  (fail 'invalid-value "pixels can be told of raw MONO8, MONO16 and RGB888 alone"))

(defun model-at (image column row)
  "For images of a camera with `image \"segmentation\"': the id of the model at the pixel, as in list-models, up to 24
bits; nil without a model. Signals invalid-value as pixel, and for other formats."
  (let ((channels (pixel image column row)))
    (unless (= (length channels) 3)
      (fail 'invalid-value "which model a pixel shows is told by RGB888 alone"))
    (destructuring-bind (red green blue) channels
      (let ((number (logior (ash red 16) (ash green 8) blue)))
        (and (plusp number) (1- number))))))
