;;;; Sends a robot to two places on the map of worlds/navigate.cfg, one after the other.
;;;;
;;;;     navigate [HOST:PORT [INDEX [SECONDS]]]      planner INDEX (0), for at most SECONDS (0: until it is done)

(in-package #:playhouse-client.examples)

(defparameter *places*           ; m, m, rad
  (list (playhouse:make-pose :x 6d0 :y 4d0 :a 1.5d0) (playhouse:make-pose :x -5.8d0 :y 5d0 :a 3d0)))

(define-example navigate "navigate [HOST:PORT [INDEX [SECONDS]]]" (client index clock more)
  (playhouse:with-device (planner client :planner index)
    (dolist (place *places*)
      (playhouse:go-to planner place)
      (playhouse:do-updates (state planner)
        (unless (timep clock)
          (return-from navigate))
        (when (playhouse:arrivedp planner)
          (let ((pose (playhouse:planner-state-pose state)))
            (format t "arrived at (~,2f, ~,2f) m~%" (playhouse:pose-x pose) (playhouse:pose-y pose))
            (finish-output))
          (return))))))
