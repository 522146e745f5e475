;;;; Follows a marker and keeps a metre away from it.
;;;;
;;;;     follow [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]
;;;;
;;;; Robot INDEX (0), for SECONDS (0: until Ctrl-C), after the marker of number MARKER (the nearest of any number), seen
;;;; by the fiducial finder FINDER (INDEX).

(in-package #:playhouse-client.examples)

(defparameter *distance* 1d0)        ; m
(defparameter *follow-speed* 0.5d0)  ; m/s
(defparameter *follow-turn* 1d0)     ; rad/s

(define-example follow "follow [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]" (client index clock more)
  (destructuring-bind (&optional wanted (finder-index index) &rest ignored) more
    (declare (ignore ignored))
    (playhouse:with-device (robot client :position2d index)
      (playhouse:with-device (finder client :fiducial finder-index)
        (let ((lost-to-the-left t))
          (playhouse:do-updates (markers finder)
            (unless (timep clock)
              (return))
            (let ((marker (choose markers wanted)))
              (cond (marker
                     (setf lost-to-the-left (plusp (playhouse:marker-bearing marker)))
                     (approach robot marker))
                    ;; Marker lost: search, turning first to the side where it was last seen.
                    (t (playhouse:drive robot 0 :va (* (if lost-to-the-left 0.5d0 -0.5d0) *follow-turn*)))))))))))

(defun choose (markers wanted)
  "The nearest marker of the wanted number, nil if there is none."
  (let ((fitting (remove-if-not (lambda (marker) (or (null wanted) (= (playhouse:marker-id marker) wanted))) markers)))
    (first (sort fitting #'< :key #'playhouse:marker-distance))))

(defun approach (robot marker)
  (let ((bearing (playhouse:marker-bearing marker)))
    (playhouse:drive robot
                     (if (< (abs bearing) 1)
                         (clamped (- (playhouse:marker-distance marker) *distance*) *follow-speed*)
                         0)
                     :va (clamped (* 2 bearing) *follow-turn*))))
