;;;; Tells the other robots by radio where it is, twice a second, and prints what it hears of them.
;;;;
;;;;     talk [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0) with radio INDEX, for SECONDS (0: until Ctrl-C)
;;;;
;;;; Start it once for each robot that is to talk: it only looks at the robot, and whoever drives it goes on.

(in-package #:playhouse-client.examples)

(defparameter *period* 0.5d0) ; s, simulated

(define-example talk "talk [HOST:PORT [INDEX [SECONDS]]]" (client index clock more)
  (playhouse:with-device (robot client :position2d index :read)
    (playhouse:with-device (radio client :opaque index)
      (let ((next-time 0))
        (playhouse:do-updates (state robot)
          (unless (timep clock)
            (return))
          (let ((time (playhouse:state-time state)) (pose (playhouse:state-pose state)))
            (dolist (message (playhouse:take-messages radio))
              (format t "~,1f s: ~a~%" time (playhouse.wire:text message))
              (finish-output))
            (when (>= time next-time)
              (playhouse:send radio (said index pose))
              (setf next-time (+ time *period*)))))))))

(defun said (index pose)
  "The bytes of a message."
  (map 'vector #'char-code
       (format nil "robot ~d is at ~,2f ~,2f" index (playhouse:pose-x pose) (playhouse:pose-y pose))))
