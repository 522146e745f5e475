;;;; Wanders about by laser and runs into nothing.
;;;;
;;;;     wander [HOST:PORT [INDEX [SECONDS]]]      robot and laser INDEX (0), for SECONDS (0: until Ctrl-C)

(in-package #:playhouse-client.examples)

(defparameter *wander-speed* 0.4d0) ; m/s
(defparameter *wander-turn* 0.8d0)  ; rad/s
(defparameter *front* 0.5d0)        ; rad to either side that the robot needs to pass
(defparameter *near* 0.6d0)         ; m

(define-example wander "wander [HOST:PORT [INDEX [SECONDS]]]" (client index clock more)
  (playhouse:with-device (robot client :position2d index)
    (playhouse:with-device (laser client :laser index)
      (let ((turning nil))
        (playhouse:do-updates (scan laser)
          (unless (timep clock)
            (return))
          (let ((ahead (playhouse:nearest scan (- *front*) *front*))
                (left (playhouse:nearest scan *front* 1.5d0))
                (right (playhouse:nearest scan -1.5d0 (- *front*))))
            (cond ((< ahead *near*) ; turns one way until the way ahead is clear
                   (unless turning
                     (setf turning (if (> left right) *wander-turn* (- *wander-turn*))))
                   (playhouse:drive robot 0 :va turning))
                  (t (setf turning nil)
                     (let ((sway (if (< (min left right) *near*) (* 0.5d0 (- left right)) 0)))
                       (playhouse:drive robot (min *wander-speed* (+ (- ahead *near*) 0.1d0))
                                        :va (clamped sway *wander-turn*)))))))))))
