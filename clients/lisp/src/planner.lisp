;;;; Planners, which drive robots to goals on a map.

(in-package #:playhouse-client)

(defclass planner (device)
  ((goal :initform nil :accessor goal-of))
  (:documentation "A planner, which drives a robot to goals on a map. It goes on while any client has it open; wavefront
cancels the goal when the last one closes it."))

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
