;;;; Interface planner, code 44. Plans and follows a path to a goal.
;;;;
;;;; Generated from interfaces/044_planner.toml by codegen; do not edit.

(cl:defpackage #:playhouse.planner
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-state+ #:+cmd-goal+ #:+cmd-start+ #:+req-get-waypoints+ #:+req-enable+ #:data
           #:cmd #:waypoints-req #:enable-req #:make-data #:copy-data #:data-p #:data-valid #:data-done
           #:data-pos #:data-goal #:data-waypoint #:data-waypoint-idx #:data-waypoints-count #:make-cmd
           #:copy-cmd #:cmd-p #:cmd-goal #:make-waypoints-req #:copy-waypoints-req #:waypoints-req-p
           #:waypoints-req-waypoints-distance #:waypoints-req-waypoints #:make-enable-req #:copy-enable-req
           #:enable-req-p #:enable-req-state))

(cl:in-package #:playhouse.planner)

(define-interface +code+ 44 "planner")

(define-struct (data "planner.Data")
  "Progress of the robot along its path. (player_planner_data_t)"
  ;; 1 if there is a path to the goal.
  (valid "valid" :uint8)
  ;; 1 if the goal is reached.
  (done "done" :uint8)
  ;; The robot (in m, m, rad, frame X_MR).
  (pos "pos" playhouse.common:pose2d)
  ;; The goal (in m, m, rad, frame X_MG).
  (goal "goal" playhouse.common:pose2d)
  ;; Current waypoint of the robot (in m, m, rad, frame X_MP).
  (waypoint "waypoint" playhouse.common:pose2d)
  ;; Index of that waypoint in the path; -1 if there is none.
  (waypoint-idx "waypoint_idx" :int32)
  ;; Number of waypoints of the path.
  (waypoints-count "waypoints_count" :uint32))

(define-struct (cmd "planner.Cmd")
  "A goal. (player_planner_cmd_t)"
  ;; Goal pose (in m, m, rad, frame X_MG).
  (goal "goal" playhouse.common:pose2d))

(define-struct (waypoints-req "planner.WaypointsReq")
  "The planned path. (player_planner_waypoints_req_t)"
  ;; Length of the path (in m).
  (waypoints-distance "waypoints_distance" :float64)
  ;; From the robot to the goal (in m, m, rad, frame X_MP).
  (waypoints "waypoints" (:counted playhouse.common:pose2d 1398099 24)))

(define-struct (enable-req "planner.EnableReq")
  "The planner's switch. (player_planner_enable_req_t)"
  ;; 1: may move, 0: stop.
  (state "state" :uint8))

;; Progress of the robot along its path.
(define-message +data-state+ 44 :data 1 "planner.data.state" data)
;; Sets the goal.
(define-message +cmd-goal+ 44 :cmd 1 "planner.cmd.goal" cmd)
;; Sets the goal and starts to move.
(define-message +cmd-start+ 44 :cmd 2 "planner.cmd.start" cmd)
;; Requests the planned path.
(define-message +req-get-waypoints+ 44 :req 1 "planner.req.get_waypoints" waypoints-req)
;; Enables or stops the robot.
(define-message +req-enable+ 44 :req 2 "planner.req.enable" enable-req)
