;;;; Markers in view of a fiducial finder.

(in-package #:playhouse-client)

(defstruct (marker (:constructor make-marker (id pose)))
  "A marker in view: its id, and its pose, a pose3d in the sensor's frame."
  id pose)

(defun marker-distance (marker)
  "In m, in the sensor's plane."
  (let ((pose (marker-pose marker)))
    (without-float-traps (abs (complex (pose3d-x pose) (pose3d-y pose))))))

(defun marker-bearing (marker)
  "In rad, to the left of the sensor's x axis."
  (let ((pose (marker-pose marker)))
    (without-float-traps (atan (pose3d-y pose) (pose3d-x pose)))))
