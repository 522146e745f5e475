;;;; scenarios NAME HOST:PORT does what the program behind a recorded session did. Its twins are
;;;; clients/python/tests/scenarios.py and clients/cpp/tests/scenarios.cc.

(in-package #:playhouse-client.tests)

(defun reads (client count)
  (loop repeat count do (read-data client)))

(defmacro refused (form)
  "Runs FORM, which the server has to refuse."
  `(handler-case (progn ,form (error "the server should have refused this"))
     (request-refused () nil)))

(defun turned (x y a)
  (make-pose :x x :y y :a a))

(defun print-position (address)
  "playerprint -r 5 -c 3 position2d"
  (with-client (client address)
    (with-device (robot client :position2d)
      (declare (ignore robot))
      (set-mode client :pull)
      (set-replace-rule client :accept)
      (reads client 3))))

(defun print-defaults (address)
  "playerprint -c 2 position2d"
  (with-client (client address)
    (with-device (robot client :position2d)
      (declare (ignore robot))
      (reads client 2))))

(defun check-position (address)
  "The original test program, position2d."
  (with-client (client address)
    (with-device (robot client :position2d)
      (reads client 23)
      (set-odometry robot (turned 0.1d0 -0.2d0 pi))
      (reads client 10)
      (set-odometry robot (make-pose))
      (set-motor-power robot t)
      (let ((quarter (/ (* 25 pi) 180)) (half (/ (* 45 pi) 180)))
        (drive robot 0.1d0)
        (drive robot -0.1d0)
        (drive robot 0 :vy 0.1d0)
        (drive robot 0 :vy -0.1d0)
        (drive robot 0 :va (- quarter))
        (drive robot 0 :va quarter)
        (drive robot 0 :vy 0.1d0 :va half)
        (drive robot 0 :vy -0.1d0 :va (- half)))
      (stop robot)
      (set-motor-power robot nil)
      (set-odometry robot (make-pose)))))

(defun check-laser (address)
  "The original test program, laser: it ends at the refusal."
  (with-client (client address)
    (with-device (scanner client :laser)
      (reads client 20)
      (refused (set-config scanner (playhouse.laser:make-config
                                    :min-angle (- (/ pi 2)) :max-angle (/ pi 2) :resolution 100 :max-range 0
                                    :range-res 1 :intensity 1 :scanning-frequency 10))))))

(defun check-ranger (address)
  "The original test program, ranger."
  (with-client (client address)
    (with-device (scanner client :ranger 1)
      (reads client 60)
      (request scanner playhouse.ranger:+req-get-geom+)
      (reads client 3))))

(defun ask-map (address)
  (with-client (client address :mode :push)
    (with-device (device client :map)
      (request device playhouse.map:+req-get-info+)
      (request device playhouse.map:+req-get-data+ (playhouse.map:make-data :col 0 :row 0 :width 20 :height 10))
      (request device playhouse.map:+req-get-data+ (playhouse.map:make-data :col 495 :row 0 :width 50 :height 3))
      (refused (request device playhouse.map:+req-get-vector+)))))

(defun ask-simulation (address)
  (with-client (client address :mode :push)
    (with-device (simulator client :simulation)
      (model-pose simulator "r0")
      (set-model-pose simulator "r0" (turned -6 -6 0.5d0))
      (refused (model-pose simulator "nosuch"))
      (model-pose3d simulator "r0"))))

(defun ask-properties (address)
  (with-client (client address :mode :push)
    (let ((lights (open-device client :dio 0)) (stream (open-device client :opaque 1)))
      (get-property lights "skip_lines" :int)
      (set-property lights "skip_lines" 7)
      (get-property lights "skip_lines" :int)
      (get-property lights "max_diff_pixels" :float)
      (set-property lights "max_diff_pixels" 0.25d0)
      (get-property lights "max_diff_pixels" :float)
      (get-property lights "max_diff_pixels" :int)
      (refused (get-property lights "nope" :int))
      (has-capability-p lights playhouse.common:+req-capabilities+)
      (get-property stream "ip" :string)
      (set-property stream "ip" "127.0.0.2")
      (get-property stream "ip" :string)
      (refused (get-property stream "nobool" :bool)))))

(defparameter *scenarios*
  '(("05_playerprint_position2d" . print-position)
    ("06_playerprint_defaults" . print-defaults)
    ("10_cxxtest_position2d" . check-position)
    ("11_cxxtest_laser" . check-laser)
    ("12_cxxtest_ranger" . check-ranger)
    ("13_raw_map" . ask-map)
    ("14_raw_simulation" . ask-simulation)
    ("15_raw_properties" . ask-properties)))

(defun play-scenario (words)
  (destructuring-bind (name address) words
    (funcall (cdr (assoc name *scenarios* :test #'string=)) address)
    0))
