;;;; Interface localize, code 25. Localization on a map: weighted hypotheses of the robot's pose.
;;;;
;;;; Generated from interfaces/025_localize.toml by codegen; do not edit.

(cl:defpackage #:playhouse.localize
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+data-hypoths+ #:+req-set-pose+ #:+req-get-particles+ #:hypoth #:data #:set-pose
           #:particle #:get-particles #:make-hypoth #:copy-hypoth #:hypoth-p #:hypoth-mean #:hypoth-cov
           #:hypoth-alpha #:make-data #:copy-data #:data-p #:data-pending-count #:data-pending-time
           #:data-hypoths #:make-set-pose #:copy-set-pose #:set-pose-p #:set-pose-mean #:set-pose-cov
           #:make-particle #:copy-particle #:particle-p #:particle-pose #:particle-alpha
           #:make-get-particles #:copy-get-particles #:get-particles-p #:get-particles-mean
           #:get-particles-variance #:get-particles-particles))

(cl:in-package #:playhouse.localize)

(define-interface +code+ 25 "localize")

(define-struct (hypoth "localize.Hypoth")
  "A hypothesis. (player_localize_hypoth_t)"
  ;; Mean of the hypothesis (in m, m, rad, frame X_MR).
  (mean "mean" playhouse.common:pose2d)
  ;; Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad).
  (cov "cov" (:array :float64 6))
  ;; Weight; the weights sum to 1.
  (alpha "alpha" :float64))

(define-struct (data "localize.Data")
  "The hypotheses. (player_localize_data_t)"
  ;; Number of queued sensor readings.
  (pending-count "pending_count" :uint32)
  ;; Time of the last processed reading (in s).
  (pending-time "pending_time" :float64)
  (hypoths "hypoths" (:counted hypoth 419429 80)))

(define-struct (set-pose "localize.SetPose")
  "Pose of the robot. (player_localize_set_pose_t)"
  ;; Mean of the hypothesis (in m, m, rad, frame X_MR).
  (mean "mean" playhouse.common:pose2d)
  ;; Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad).
  (cov "cov" (:array :float64 6)))

(define-struct (particle "localize.Particle")
  "One particle. (player_localize_particle_t)"
  ;; The particle's estimate of the robot's pose (in m, m, rad, frame X_MR).
  (pose "pose" playhouse.common:pose2d)
  ;; Weight.
  (alpha "alpha" :float64))

(define-struct (get-particles "localize.GetParticles")
  "The particles of the filter. (player_localize_get_particles_t)"
  ;; Of the most likely hypothesis (in m, m, rad, frame X_MR).
  (mean "mean" playhouse.common:pose2d)
  ;; Of the most likely hypothesis (in m^2).
  (variance "variance" :float64)
  (particles "particles" (:counted particle 1048574 32)))

;; The hypotheses, the most likely first.
(define-message +data-hypoths+ 25 :data 1 "localize.data.hypoths" data)
;; Sets the robot's pose estimate.
(define-message +req-set-pose+ 25 :req 1 "localize.req.set_pose" set-pose)
;; Requests the particles of the driver's filter.
(define-message +req-get-particles+ 25 :req 2 "localize.req.get_particles" get-particles)
