;;;; Scans: ranges and their directions.

(in-package #:playhouse-client)

(defstruct (scan (:constructor make-scan (ranges angles max-range time)))
  "Ranges in m and their directions in rad, two vectors of equal length, in the order of measurement. Directions are
counter-clockwise from the sensor's x axis. `time' is the server's, in s."
  ranges angles max-range time)

(define-operation nearest ((scan scan) &optional (low (- pi)) (high pi))
  "The minimum range between two directions; max-range if no beam is there. Signals invalid-value if LOW is not at most
HIGH."
  (without-float-traps
    (unless (and (realp low) (realp high) (<= low high))
      (fail 'invalid-value "nearest: directions are from the lower to the higher, not from ~a to ~a"
            (if (realp low) (number-text low) low) (if (realp high) (number-text high) high)))
    (let ((found nil))
      (map nil (lambda (range angle)
                 (when (and (<= low angle high) (or (null found) (< range found)))
                   (setf found range)))
           (scan-ranges scan) (scan-angles scan))
      (or found (scan-max-range scan)))))

(defmethod points ((scan scan))
  (without-float-traps
    (map 'list (lambda (range angle) (list (* range (cos angle)) (* range (sin angle))))
         (scan-ranges scan) (scan-angles scan))))

(defun spread (low high count)
  "COUNT angles from LOW to HIGH, as float64."
  (without-float-traps
    (let* ((first (coerce low 'double-float))
           (step (if (> count 1) (/ (- (coerce high 'double-float) first) (1- count)) 0d0))
           (angles (make-array count :element-type 'double-float)))
      (dotimes (i count angles)
        (setf (aref angles i) (+ first (* i step)))))))

(defun directions (low high ranges &optional elements)
  "The direction of each range: those of the elements if there is one per range, else spread from LOW to HIGH."
  (if (and (= (length elements) (length ranges)) (> (length ranges) 1))
      (map 'vector #'playhouse.common:pose3d-pyaw elements)
      (spread low high (length ranges))))
