;;;; Bases: position2d and position3d. Closing one while it moves stops it first.

(in-package #:playhouse-client)

(defclass base (device)
  ((moving :initform nil :accessor movingp :documentation "Whether the last command was a motion."))
  (:documentation "What drives."))

(defclass position2d (base) ()
  (:documentation "A mobile base."))

(defclass position3d (base) ()
  (:documentation "A mobile base in space."))

(define-operation drive (base vx &key)
  "Forward and to the left (vx, :vy) in m/s, turning (:va) in rad/s, until the next command; a
position3d also upwards (:vz) in m/s.")

(define-operation set-motor-power (base on)
  "Switches the motors on or off.")

(define-operation set-odometry (base pose)
  "Sets the pose estimate; the robot does not move.")

(define-operation reset-odometry (base)
  "Makes the current pose the origin of the pose estimate.")

(defmethod close-device :before ((base base))
  (when (and (device-open-p base) (movingp base) (not (device-gone-p base)) (reachablep base))
    (stop base)))

(defmethod stop ((base base))
  (drive base 0))

(define-updates base state)

;;; In the plane

(defmethod state ((base position2d))
  (multiple-value-bind (data time) (newest base playhouse.position2d:+data-state+)
    (let ((velocity (playhouse.position2d:data-vel data)))
      (make-state (pose-of (playhouse.position2d:data-pos data))
                  (make-velocity :x (playhouse.common:pose2d-px velocity) :y (playhouse.common:pose2d-py velocity)
                                 :a (playhouse.common:pose2d-pa velocity))
                  (/= 0 (playhouse.position2d:data-stall data))
                  time))))

(defmethod pose ((base position2d))
  (state-pose (state base)))

(defmethod velocity ((base position2d))
  (state-velocity (state base)))

(define-operation stalled-p ((base position2d))
  "Whether a position2d is blocked. Signals no-data."
  (state-stalled-p (state base)))

(defmethod drive ((base position2d) vx &key (va 0) (vy 0))
  (insist-on-finite base "vx" vx "va" va "vy" vy)
  (setf (movingp base) (notevery #'zerop (list vx vy va)))
  (command base playhouse.position2d:+cmd-vel+
           (playhouse.position2d:make-cmd-vel :vel (playhouse.common:make-pose2d :px vx :py vy :pa va) :state 1)))

(define-operation drive-car ((base position2d) speed steering)
  "For a position2d with car steering: speed in m/s, and steering angle in rad, positive to the left."
  (insist-on-finite base "speed" speed "steering" steering)
  (setf (movingp base) (not (zerop speed)))
  (command base playhouse.position2d:+cmd-car+
           (playhouse.position2d:make-cmd-car :velocity speed :angle steering)))

(defmethod go-to ((base position2d) pose &key (speed 0))
  (insist-on-pose base pose)
  (insist-on-finite base "speed" speed)
  (setf (movingp base) t)
  (command base playhouse.position2d:+cmd-pos+
           (playhouse.position2d:make-cmd-pos :pos (wire-pose pose) :vel (playhouse.common:make-pose2d :px speed)
                                              :state 1)))

(defmethod set-motor-power ((base position2d) on)
  (request base playhouse.position2d:+req-motor-power+
           (playhouse.position2d:make-power-config :state (if on 1 0))))

(defmethod set-odometry ((base position2d) pose)
  (insist-on-pose base pose)
  (request base playhouse.position2d:+req-set-odom+ (playhouse.position2d:make-set-odom-req :pose (wire-pose pose))))

(defmethod reset-odometry ((base position2d))
  (request base playhouse.position2d:+req-reset-odom+))

(define-geometry position2d playhouse.position2d:+req-get-geom+
  playhouse.position2d:geom-pose playhouse.position2d:geom-size)

;;; In space

(defmethod state ((base position3d))
  (multiple-value-bind (data time) (newest base playhouse.position3d:+data-state+)
    (make-state3d (pose3d-of (playhouse.position3d:data-pos data))
                  (pose3d-of (playhouse.position3d:data-vel data))
                  (/= 0 (playhouse.position3d:data-stall data))
                  time)))

(defmethod drive ((base position3d) vx &key (va 0) (vy 0) (vz 0))
  (insist-on-finite base "vx" vx "va" va "vy" vy "vz" vz)
  (setf (movingp base) (notevery #'zerop (list vx vy vz va)))
  (command base playhouse.position3d:+cmd-set-vel+
           (playhouse.position3d:make-cmd-vel
            :vel (playhouse.common:make-pose3d :px vx :py vy :pz vz :pyaw va) :state 1)))

(defmethod go-to ((base position3d) pose &key)
  (insist-on-pose3d base pose)
  (setf (movingp base) t)
  (command base playhouse.position3d:+cmd-set-pos+
           (playhouse.position3d:make-cmd-pos :pos (wire-pose3d pose) :state 1)))

(defmethod set-motor-power ((base position3d) on)
  (request base playhouse.position3d:+req-motor-power+
           (playhouse.position3d:make-power-config :state (if on 1 0))))

(defmethod set-odometry ((base position3d) pose)
  (insist-on-pose3d base pose)
  (request base playhouse.position3d:+req-set-odom+
           (playhouse.position3d:make-set-odom-req :pos (wire-pose3d pose))))

(defmethod reset-odometry ((base position3d))
  (request base playhouse.position3d:+req-reset-odom+))

(define-geometry position3d playhouse.position3d:+req-get-geom+
  playhouse.position3d:geom-pose playhouse.position3d:geom-size)
