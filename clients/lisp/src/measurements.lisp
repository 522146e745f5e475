;;;; What measures without ranges or images: bumper, imu, gps, pointcloud3d and aio.

(in-package #:playhouse-client)

(defclass bumper (device) ()
  (:documentation "Contact switches."))

(defclass imu (device) ()
  (:documentation "An inertial unit. send selects the data message; initially it is that of its pose."))

(defclass gps (device) ()
  (:documentation "A satellite receiver."))

(defclass pointcloud3d (device) ()
  (:documentation "A 3D point cloud, such as that of a lidar with several rings."))

(defclass aio (device) ()
  (:documentation "Analog inputs and outputs; in Playhouse a custom model: its readings are inputs, its commands
outputs."))

;;; bumper

(defstruct (face (:constructor make-face (pose length radius)))
  "The face of a bumper switch: pose of its centre on the robot, a pose3d (yaw: outward direction), and its length.
`radius' is its radius of curvature, 0 if it is straight. In m."
  pose length radius)

(define-operation pressed ((bumper bumper))
  "Whether each switch is pressed, a list in the order of the faces. Signals no-data."
  (map 'list (lambda (state) (/= state 0))
       (playhouse.bumper:data-bumpers (newest bumper playhouse.bumper:+data-state+))))

(define-updates bumper pressed)

(define-operation faces ((bumper bumper))
  "Faces of the switches on the robot, a list."
  (map 'list (lambda (one)
               (make-face (pose3d-of (playhouse.bumper:define-pose one)) (playhouse.bumper:define-length one)
                          (playhouse.bumper:define-radius one)))
       (playhouse.bumper:geom-bumper-def (answer-of bumper playhouse.bumper:+req-get-geom+))))

;;; imu

(defstruct (inertia (:constructor make-inertia (acceleration turn-rate field)))
  "Measurements of an inertial unit along and about its own axes, lists of three: specific force in m/s^2, 0, 0, 9.81
when level and at rest; turn rates in rad/s; magnetic field, in a unit of the server."
  acceleration turn-rate field)

(defmethod send ((imu imu) datatype)
  (insist-on-message imu datatype)
  (request imu playhouse.imu:+req-set-datatype+
           (playhouse.imu:make-datatype-config :value (message-type-subtype datatype))))

(defmethod lack-of ((imu imu) message)
  (let ((name (message-type-name message)))
    (format nil "~a~@[; (send imu playhouse.imu:+~a+) selects it~]" (call-next-method)
            (and (device-has-data-p imu) (substitute #\- #\. (subseq name (1+ (position #\. name))))))))

(defun newest-of (device &rest messages)
  "The newest value of several data messages. Signals no-data before the first."
  (let ((best nil) (best-time nil))
    (dolist (message messages (or best (newest device (first messages))))
      (multiple-value-bind (value time) (latest device message)
        (when (and value (or (null best) (> time best-time)))
          (setf best value best-time time))))))

(defmethod pose ((imu imu))
  (let ((data (newest-of imu playhouse.imu:+data-state+ playhouse.imu:+data-fullstate+)))
    (pose3d-of (etypecase data
                 (playhouse.imu:data-state (playhouse.imu:data-state-pose data))
                 (playhouse.imu:data-fullstate (playhouse.imu:data-fullstate-pose data))))))

(defmethod velocity ((imu imu))
  (pose3d-of (playhouse.imu:data-fullstate-vel (newest imu playhouse.imu:+data-fullstate+))))

(define-operation inertia ((imu imu))
  "The newest measurements. Signals no-data."
  (let* ((data (newest-of imu playhouse.imu:+data-calib+ playhouse.imu:+data-quat+ playhouse.imu:+data-euler+))
         (one (etypecase data
                (playhouse.imu:data-calib data)
                (playhouse.imu:data-quat (playhouse.imu:data-quat-calib-data data))
                (playhouse.imu:data-euler (playhouse.imu:data-euler-calib-data data)))))
    (make-inertia (list (playhouse.imu:data-calib-accel-x one) (playhouse.imu:data-calib-accel-y one)
                        (playhouse.imu:data-calib-accel-z one))
                  (list (playhouse.imu:data-calib-gyro-x one) (playhouse.imu:data-calib-gyro-y one)
                        (playhouse.imu:data-calib-gyro-z one))
                  (list (playhouse.imu:data-calib-magn-x one) (playhouse.imu:data-calib-magn-y one)
                        (playhouse.imu:data-calib-magn-z one)))))

(define-operation attitude ((imu imu))
  "Roll, pitch and yaw in rad, a list. Signals no-data."
  (let ((turns (playhouse.imu:data-euler-orientation (newest imu playhouse.imu:+data-euler+))))
    (list (playhouse.common:orientation3d-proll turns) (playhouse.common:orientation3d-ppitch turns)
          (playhouse.common:orientation3d-pyaw turns))))

(define-operation quaternion ((imu imu))
  "Orientation, a list of four with the real part first. Signals no-data."
  (let ((data (newest imu playhouse.imu:+data-quat+)))
    (list (playhouse.imu:data-quat-q0 data) (playhouse.imu:data-quat-q1 data) (playhouse.imu:data-quat-q2 data)
          (playhouse.imu:data-quat-q3 data))))

(define-operation reset-orientation ((imu imu) &optional all-axes)
  "Makes the current heading, or the whole current orientation, the reference."
  (request imu playhouse.imu:+req-reset-orientation+
           (playhouse.imu:make-reset-orientation-config :value (if all-axes 1 0))))

(define-operation reset-attitude ((imu imu) roll pitch yaw)
  "Sets the current orientation, in rad."
  (insist-on-finite imu "roll" roll "pitch" pitch "yaw" yaw)
  (request imu playhouse.imu:+req-reset-euler+
           (playhouse.imu:make-reset-euler-config
            :orientation (playhouse.common:make-pose3d :proll roll :ppitch pitch :pyaw yaw))))

;;; gps

(defstruct fix
  "A fix of a satellite receiver: latitude and longitude in degrees, altitude in m above the ellipsoid (WGS84), UTM
easting and northing in m; speed in m/s, course in rad, clockwise from north; expected errors in m. `quality' is 0
without a fix, and then the rest is invalid. `time' is the server's, in s."
  latitude longitude altitude easting northing speed course quality satellites horizontal-error vertical-error time)

(define-operation fix ((receiver gps))
  "The newest fix. Signals no-data."
  (multiple-value-bind (data time) (newest receiver playhouse.gps:+data-state+)
    (make-fix :latitude (* (playhouse.gps:data-latitude data) 1d-7)
              :longitude (* (playhouse.gps:data-longitude data) 1d-7)
              :altitude (* (playhouse.gps:data-altitude data) 1d-3)
              :easting (playhouse.gps:data-utm-e data) :northing (playhouse.gps:data-utm-n data)
              :speed (playhouse.gps:data-speed data) :course (playhouse.gps:data-course data)
              :quality (playhouse.gps:data-quality data) :satellites (playhouse.gps:data-num-sats data)
              :horizontal-error (playhouse.gps:data-err-horz data) :vertical-error (playhouse.gps:data-err-vert data)
              :time time)))

(define-updates gps fix)

;;; pointcloud3d

(defstruct (point (:constructor make-point (x y z color)))
  "A point of a cloud, in m in the sensor's frame, and its color, a list: red, green, blue, alpha from 0 to 255."
  x y z color)

(defmethod points ((cloud pointcloud3d))
  (map 'list (lambda (one)
               (let ((at (playhouse.pointcloud3d:element-point one)) (color (playhouse.pointcloud3d:element-color one)))
                 (make-point (playhouse.common:point3d-px at) (playhouse.common:point3d-py at)
                             (playhouse.common:point3d-pz at)
                             (list (playhouse.common:color-red color) (playhouse.common:color-green color)
                                   (playhouse.common:color-blue color) (playhouse.common:color-alpha color)))))
       (playhouse.pointcloud3d:data-points (newest cloud playhouse.pointcloud3d:+data-state+))))

(define-updates pointcloud3d points)

;;; aio

(define-operation voltages ((device aio))
  "One per input, in V, a vector. Signals no-data."
  (playhouse.aio:data-voltages (newest device playhouse.aio:+data-state+)))

(define-updates aio voltages)

(define-operation set-voltage ((device aio) output voltage)
  "Sets one output, in V."
  (insist-on-finite device "voltage" voltage)
  (command device playhouse.aio:+cmd-state+ (playhouse.aio:make-cmd :id output :voltage voltage)))
