;;;; Localization of a robot on a map, and planners that drive it there.

(in-package #:playhouse-client)

(defclass localize (device) ()
  (:documentation "Localization of a robot on a map."))

(defclass planner (device)
  ((goal :initform nil :accessor goal-of))
  (:documentation "A planner, which drives a robot to goals on a map. It goes on while any client has it open; wavefront
cancels the goal when the last one closes it."))

;;; localize

(defstruct covariance
  "Covariance of a pose in the plane: of x, y (m) and a (rad). xx, yy, aa are variances."
  (xx 0d0 :type real) (yy 0d0 :type real) (aa 0d0 :type real)
  (xy 0d0 :type real) (ya 0d0 :type real) (xa 0d0 :type real))

(defun covariance-of-deviations (x y a)
  "That of independent errors with these standard deviations, in m, m and rad."
  (make-covariance :xx (* x x) :yy (* y y) :aa (* a a)))

(defstruct (hypothesis (:constructor make-hypothesis (pose covariance weight)))
  "A hypothesis about where the robot is: the mean pose on the map, its covariance, and its weight; the weights of all
sum to 1."
  pose covariance weight)

(defstruct (particle (:constructor make-particle (pose weight)))
  "A particle of the localization's filter: a possible pose of the robot on the map, and its weight."
  pose weight)

(defun numbers-of (covariance)
  "Those of the wire, in its order."
  (list (covariance-xx covariance) (covariance-yy covariance) (covariance-aa covariance)
        (covariance-xy covariance) (covariance-ya covariance) (covariance-xa covariance)))

(defun covariance-of (numbers)
  (destructuring-bind (xx yy aa xy ya xa) (coerce numbers 'list)
    (make-covariance :xx xx :yy yy :aa aa :xy xy :ya ya :xa xa)))

(define-operation hypotheses ((localize localize))
  "Where the robot may be, a list, the most likely first. Signals no-data."
  (map 'list (lambda (one)
               (make-hypothesis (pose-of (playhouse.localize:hypoth-mean one))
                                (covariance-of (playhouse.localize:hypoth-cov one))
                                (playhouse.localize:hypoth-alpha one)))
       (playhouse.localize:data-hypoths (newest localize playhouse.localize:+data-hypoths+))))

(define-updates localize hypotheses)

(defmethod pose ((localize localize))
  (let ((hypotheses (hypotheses localize)))
    (unless hypotheses
      (fail 'no-data "~a: ~a has no hypothesis" (peer localize) (device-name localize)))
    (hypothesis-pose (first hypotheses))))

(define-operation set-pose ((localize localize) pose covariance)
  "Sets the estimate of the pose on the map; the robot does not move. Signals request-refused if the driver takes none
of this covariance."
  (insist-on-pose localize pose)
  (insist-on-type localize covariance 'covariance)
  (apply #'insist-on-finite localize
         (mapcan #'list (list "xx" "yy" "aa" "xy" "ya" "xa") (numbers-of covariance)))
  (request localize playhouse.localize:+req-set-pose+
           (playhouse.localize:make-set-pose :mean (wire-pose pose) :cov (numbers-of covariance))))

(define-operation particles ((localize localize))
  "All particles of the filter, a list; none before its first step."
  (map 'list (lambda (one)
               (make-particle (pose-of (playhouse.localize:particle-pose one)) (playhouse.localize:particle-alpha one)))
       (playhouse.localize:get-particles-particles (answer-of localize playhouse.localize:+req-get-particles+))))

;;; planner

(defstruct planner-state
  "The data of a planner, poses on the map: whether there is a path to the goal (`valid-p'), whether the goal is reached
(`done-p'), the robot's pose, the goal, the waypoint that the robot drives to, its index in the path (-1 if there is
none) and the number of waypoints of the path. `time' is the server's, in s."
  valid-p done-p pose goal waypoint index count time)

(defstruct (path (:constructor make-path (waypoints length)))
  "A planned path: its waypoints on the map, a list of poses from the robot to the goal, and its length in m."
  waypoints length)

(defmethod state ((planner planner))
  (multiple-value-bind (data time) (newest planner playhouse.planner:+data-state+)
    (make-planner-state :valid-p (/= 0 (playhouse.planner:data-valid data))
                        :done-p (/= 0 (playhouse.planner:data-done data))
                        :pose (pose-of (playhouse.planner:data-pos data))
                        :goal (pose-of (playhouse.planner:data-goal data))
                        :waypoint (pose-of (playhouse.planner:data-waypoint data))
                        :index (playhouse.planner:data-waypoint-idx data)
                        :count (playhouse.planner:data-waypoints-count data)
                        :time time)))

(define-updates planner state)

(define-operation arrivedp ((planner planner))
  "Whether the last data say that the goal of the last go-to is reached; data of another goal do not count."
  (let ((data (latest planner playhouse.planner:+data-state+)) (goal (goal-of planner)))
    (and data goal
         (/= 0 (playhouse.planner:data-done data))
         (same-pose-p (pose-of (playhouse.planner:data-goal data)) goal))))

(defun same-pose-p (one other)
  "Whether two poses are the same, whole turns aside, which drivers drop."
  (without-float-traps
    (let ((turn (/ (- (pose-a one) (pose-a other)) (* 2 pi))))
      (and (= (pose-x one) (pose-x other))
           (= (pose-y one) (pose-y other))
           (finitep turn)
           (< (abs (* 2 pi (- turn (fround turn)))) 1d-6)))))

(defmethod go-to ((planner planner) pose &key)
  (insist-on-pose planner pose)
  (setf (goal-of planner) (copy-pose pose))
  (command planner playhouse.planner:+cmd-goal+ (playhouse.planner:make-cmd :goal (wire-pose pose))))

(defmethod stop ((planner planner))
  (request planner playhouse.planner:+req-enable+ (playhouse.planner:make-enable-req :state 0)))

(define-operation resume ((planner planner))
  "Ends stop."
  (request planner playhouse.planner:+req-enable+ (playhouse.planner:make-enable-req :state 1)))

(define-operation path ((planner planner))
  "The path as it was planned last; without waypoints if there is none."
  (let ((answer (answer-of planner playhouse.planner:+req-get-waypoints+)))
    (make-path (map 'list #'pose-of (playhouse.planner:waypoints-req-waypoints answer))
               (playhouse.planner:waypoints-req-waypoints-distance answer))))
