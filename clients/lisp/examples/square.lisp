;;;; Drives once around a square of 1.5 m, by odometry: forward, left, and back to where it began.
;;;;
;;;;     square [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0), for at most SECONDS (0: until it is done)

(in-package #:playhouse-client.examples)

(defparameter *side* 1.5d0)      ; m
(defparameter *reached* 0.03d0)  ; m
(defparameter *aligned* 0.02d0)  ; rad
(defparameter *square-speed* 0.4d0) ; m/s
(defparameter *square-turn* 1d0)    ; rad/s

(define-example square "square [HOST:PORT [INDEX [SECONDS]]]" (client index clock more)
  (playhouse:with-device (robot client :position2d index)
    (playhouse:next-data robot)
    (let ((start (playhouse:pose robot)))
      (go-round-corners robot start clock)
      (turn-back robot start clock))))

(defun go-round-corners (robot start clock)
  (let ((corners (list (list *side* 0) (list *side* *side*) (list 0 *side*) (list 0 0))) (passed 0))
    (playhouse:do-updates (state robot)
      (unless (and (timep clock) corners)
        (return))
      (let* ((here (seen-from start (playhouse:state-pose state)))
             (ahead (- (first (first corners)) (playhouse:pose-x here)))
             (left (- (second (first corners)) (playhouse:pose-y here)))
             (distance (sqrt (+ (* ahead ahead) (* left left)))))
        (cond ((< distance *reached*)
               (format t "corner ~d at (~,2f, ~,2f) m~%" (incf passed) (playhouse:pose-x here) (playhouse:pose-y here))
               (finish-output)
               (pop corners)
               (playhouse:stop robot))
              (t (go-towards robot distance (normalized (- (atan left ahead) (playhouse:pose-a here))))))))))

(defun go-towards (robot distance aside)
  "Drives to a point at DISTANCE (m) that is ASIDE (rad) of the heading."
  (playhouse:drive robot
                   (if (> (abs aside) 0.15) 0 (min *square-speed* (max 0.05d0 distance)))
                   :va (clamped (* 2 aside) *square-turn*)))

(defun turn-back (robot start clock)
  "Turns to the first heading."
  (playhouse:do-updates (state robot)
    (let ((aside (normalized (- (playhouse:pose-a start) (playhouse:pose-a (playhouse:state-pose state))))))
      (when (or (not (timep clock)) (< (abs aside) *aligned*))
        (return))
      (playhouse:drive robot 0 :va (clamped (* 2 aside) *square-turn*)))))

(defun seen-from (origin pose)
  "The same place in the frame of ORIGIN."
  (let ((dx (- (playhouse:pose-x pose) (playhouse:pose-x origin)))
        (dy (- (playhouse:pose-y pose) (playhouse:pose-y origin)))
        (c (cos (playhouse:pose-a origin)))
        (s (sin (playhouse:pose-a origin))))
    (playhouse:make-pose :x (+ (* c dx) (* s dy)) :y (- (* c dy) (* s dx))
                         :a (normalized (- (playhouse:pose-a pose) (playhouse:pose-a origin))))))

(defun normalized (angle)
  (atan (sin angle) (cos angle)))

(defun clamped (value limit)
  (max (- limit) (min limit value)))
