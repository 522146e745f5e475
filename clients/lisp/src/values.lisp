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

(defun velocity-of (wire)
  (make-velocity :x (playhouse.common:pose2d-px wire) :y (playhouse.common:pose2d-py wire)
                 :a (playhouse.common:pose2d-pa wire)))

(defun attitude-of (wire)
  (list (playhouse.common:orientation3d-proll wire) (playhouse.common:orientation3d-ppitch wire)
        (playhouse.common:orientation3d-pyaw wire)))

(defun vector-of (wire)
  (list (playhouse.common:point3d-px wire) (playhouse.common:point3d-py wire) (playhouse.common:point3d-pz wire)))

(defun pose3d-at (point orientation)
  (destructuring-bind ((x y z) (roll pitch yaw)) (list (vector-of point) (attitude-of orientation))
    (make-pose3d :x x :y y :z z :roll roll :pitch pitch :yaw yaw)))

(defun rgb-of (wire)
  (list (playhouse.common:color-red wire) (playhouse.common:color-green wire) (playhouse.common:color-blue wire)))

(defun rgba-of (wire)
  (append (rgb-of wire) (list (playhouse.common:color-alpha wire))))

(defun wire-rgb (rgb)
  (destructuring-bind (red green blue) (coerce rgb 'list)
    (playhouse.common:make-color :alpha 255 :red red :green green :blue blue)))

(defun packed-rgb (color)
  (list (ldb (byte 8 16) color) (ldb (byte 8 8) color) (ldb (byte 8 0) color)))

(defun charging (state)
  ":yes, :no, or :impossible."
  (cond ((plusp state) :yes) ((minusp state) :impossible) (t :no)))

(defun level (value unit)
  "Levels in dBm are signed, all others are not."
  (if (= unit playhouse.wifi:+qual-dbm+) value (ldb (byte 32 0) value)))

(defun unless-number (absent value)
  "VALUE, nil if it is the number that stands for none."
  (unless (and (finitep value) (= value absent))
    value))

(defun first-of (device values what)
  "The first of VALUES. Signals no-data if there is none."
  (or (first values)
      (fail 'no-data "~a: ~a has no ~a" (peer device) (device-name device) what)))

;;; Checks of arguments

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

(defun insist-on-numbers (device name numbers)
  (unless (typep numbers 'sequence)
    (fail 'invalid-value "~a: ~s is no sequence of numbers" (device-name device) numbers))
  (map nil (lambda (number) (insist-on-finite device name number)) numbers))

(defun insist-on-octets (device message)
  (unless (and (typep message 'sequence) (every (lambda (octet) (typep octet '(unsigned-byte 8))) message))
    (fail 'invalid-value "~a: a message is a sequence of bytes, not ~s" (device-name device) message)))

(defun insist-on-rgb (device color)
  (insist-on-octets device color)
  (unless (= (length color) 3)
    (fail 'invalid-value "~a: a color is red, green and blue, not ~s" (device-name device) color)))
