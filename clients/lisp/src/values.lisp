;;;; Values in SI units and radians; x forward, y left, z up, angles counter-clockwise.

(in-package #:playhouse-client)

(defstruct pose
  "A pose in the plane: x, y (m), a (heading in rad, counter-clockwise, 0 along the frame's x, in (-pi, pi] as servers
report it). The frame is documented where a pose is returned."
  (x 0d0 :type real) (y 0d0 :type real) (a 0d0 :type real))

(defstruct pose3d
  "A pose in space: x, y, z (m), then roll, pitch, yaw (rad): rotations about z by yaw, then about the new y by pitch,
then about the new x by roll. The frame is documented where a pose is returned."
  (x 0d0 :type real) (y 0d0 :type real) (z 0d0 :type real)
  (roll 0d0 :type real) (pitch 0d0 :type real) (yaw 0d0 :type real))

(defstruct size
  "Extents in m along x, y and z."
  x y z)

(defstruct velocity
  "x and y in m/s, a in rad/s, in the robot's frame."
  x y a)

(defstruct geometry
  "Pose of a device on its robot (for a base: its own centre), a pose3d, and its size."
  pose size)

(defstruct (state (:constructor make-state (pose velocity stalled-p time)))
  "The data of a base: pose estimate, velocity, and whether it is blocked. `pose' is in the frame of the estimate: with
odometry that of the start pose, or as set by set-odometry; with localization by gps the world. `time' is the server's,
in s."
  pose velocity stalled-p time)

(defstruct (state3d (:constructor make-state3d (pose velocity stalled-p time)))
  "The data of a base that moves in space: pose estimate, velocity (a pose3d; m/s and rad/s along and about its own
axes), and whether it is blocked. `time' is the server's, in s."
  pose velocity stalled-p time)

;;; From and to the structures of the wire

(defun pose-of (wire)
  (make-pose :x (playhouse.common:pose2d-px wire) :y (playhouse.common:pose2d-py wire)
             :a (playhouse.common:pose2d-pa wire)))

(defun pose3d-of (wire)
  (make-pose3d :x (playhouse.common:pose3d-px wire) :y (playhouse.common:pose3d-py wire)
               :z (playhouse.common:pose3d-pz wire)
               :roll (playhouse.common:pose3d-proll wire) :pitch (playhouse.common:pose3d-ppitch wire)
               :yaw (playhouse.common:pose3d-pyaw wire)))

(defun wire-pose (pose)
  (playhouse.common:make-pose2d :px (pose-x pose) :py (pose-y pose) :pa (pose-a pose)))

(defun wire-pose3d (pose)
  (playhouse.common:make-pose3d :px (pose3d-x pose) :py (pose3d-y pose) :pz (pose3d-z pose)
                                :proll (pose3d-roll pose) :ppitch (pose3d-pitch pose) :pyaw (pose3d-yaw pose)))

(defun size-of (wire)
  (make-size :x (playhouse.common:bbox3d-sl wire) :y (playhouse.common:bbox3d-sw wire)
             :z (playhouse.common:bbox3d-sh wire)))

(defun insist-on-type (device value type)
  (unless (typep value type)
    (fail 'invalid-value "~a: ~s is not a ~(~a~)" (device-name device) value type)))

(defun insist-on-pose (device pose)
  (insist-on-type device pose 'pose)
  (insist-on-finite device "x" (pose-x pose) "y" (pose-y pose) "a" (pose-a pose)))

(defun insist-on-pose3d (device pose)
  (insist-on-type device pose 'pose3d)
  (insist-on-finite device "x" (pose3d-x pose) "y" (pose3d-y pose) "z" (pose3d-z pose)
                           "roll" (pose3d-roll pose) "pitch" (pose3d-pitch pose) "yaw" (pose3d-yaw pose)))

;;; What several interfaces have

(define-operation state (device)
  "The newest data of a base or a planner. Signals no-data before the first.")

(define-operation pose (device)
  "The newest pose estimate: of position2d its state's, of imu a pose3d, of localize that of the most
likely hypothesis, on the map. Signals no-data.")

(define-operation velocity (device)
  "The newest velocity estimate: of position2d its state's, of imu a pose3d. Signals no-data.")

(define-operation geometry (device)
  "Where the device is on its robot, and its size.")

(define-operation ranges (device)
  "The newest ranges in m, in the order of measurement. Signals no-data.")

(define-operation intensities (device)
  "The newest intensities, one per range, in the device's unit. Signals no-data, of a ranger also if it
measures none; of a laser they are then empty.")

(define-operation scan (device)
  "The newest ranges with their directions. Signals no-data.")

(define-operation set-power (device on)
  "Switches a ranger or sonar on or off.")

(define-operation set-config (device config)
  "Requests another configuration of a laser or ranger.")

(define-operation config (device)
  "The configuration of a laser (a playhouse.laser:config) or ranger (a playhouse.ranger:config).")

(define-operation stop (device)
  "Stops a base; of a planner: stops the robot until resume, the planner keeps its goal.")

(define-operation go-to (device pose &key)
  "Drives to a pose: position2d in the frame of its pose, by the driver's position control (:speed 0:
the driver's choice); position3d the same with a pose3d; planner by a path on the map, after stop from resume on.")

(define-operation points (thing)
  "Of a scan the end points of its beams, a list of x and y in the sensor's frame each; of a
pointcloud3d its newest points. Signals no-data.")

(define-operation send (device message)
  "Of an opaque device: sends bytes to the driver; a radio broadcasts them to all radios in range. Of an
imu: selects the data message, one of playhouse.imu:+data-state+ (pose), +data-calib+ (inertia), +data-quat+ (inertia
and quaternion), +data-euler+ (inertia and attitude) and +data-fullstate+ (pose and velocity), for all subscribers.")

(defmacro define-updates (class reader)
  "next-update of a proxy: waits for new data, then calls READER."
  `(defmethod next-update ((device ,class) &key timeout)
     (next-data device :timeout timeout)
     (,reader device)))

(defmacro define-geometry (class message pose size)
  "The geometry of a proxy, from the answer to a request."
  `(defmethod geometry ((device ,class))
     (let ((answer (answer-of device ,message)))
       (make-geometry :pose (pose3d-of (,pose answer)) :size (size-of (,size answer))))))
