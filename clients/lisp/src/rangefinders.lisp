;;;; Range finders: ranger, laser, sonar, and the fiducial finder.

(in-package #:playhouse-client)

(defclass ranger (device)
  ((config :initform (playhouse.ranger:make-config) :accessor config)
   (geom :initform (playhouse.ranger:make-geom) :accessor geom-of))
  (:documentation "A range finder: a laser scanner, or a ring of sonars. Opening requests its configuration."))

(defclass laser (device) ()
  (:documentation "A laser scanner; its data include the directions of the beams."))

(defclass sonar (device) ()
  (:documentation "A ring of sonars."))

(defclass fiducial (device) ()
  (:documentation "A fiducial finder."))

;;; ranger

(defmethod prepare ((ranger ranger))
  (setf (config ranger) (answer-of ranger playhouse.ranger:+req-get-config+)
        (geom-of ranger) (answer-of ranger playhouse.ranger:+req-get-geom+)))

(defmethod ranges ((ranger ranger))
  (playhouse.ranger:data-range-ranges (newest ranger playhouse.ranger:+data-range+)))

(defmethod intensities ((ranger ranger))
  (playhouse.ranger:data-intns-intensities (newest ranger playhouse.ranger:+data-intns+)))

(defmethod scan ((ranger ranger))
  "Directions are those of the elements if there is one per range, else spread over the field of view."
  (multiple-value-bind (data time) (newest ranger playhouse.ranger:+data-range+)
    (let* ((ranges (playhouse.ranger:data-range-ranges data))
           (poses (playhouse.ranger:geom-element-poses (geom-of ranger)))
           (config (config ranger))
           (angles (if (and (= (length poses) (length ranges)) (> (length ranges) 1))
                       (map 'vector #'playhouse.common:pose3d-pyaw poses)
                       (spread (playhouse.ranger:config-min-angle config) (playhouse.ranger:config-max-angle config)
                               (length ranges)))))
      (make-scan ranges angles (playhouse.ranger:config-max-range config) time))))

(define-updates ranger scan)

(defmethod geometry ((ranger ranger))
  (let ((geom (geom-of ranger)))
    (make-geometry :pose (pose3d-of (playhouse.ranger:geom-pose geom))
                   :size (size-of (playhouse.ranger:geom-size geom)))))

(defmethod set-power ((ranger ranger) on)
  (request ranger playhouse.ranger:+req-power+ (playhouse.ranger:make-power-config :state (if on 1 0))))

(define-operation set-intensities ((ranger ranger) on)
  "Enables or disables intensities."
  (request ranger playhouse.ranger:+req-intns+ (playhouse.ranger:make-intns-config :state (if on 1 0))))

(defmethod set-config ((ranger ranger) config)
  "The configuration of RANGER then has the values in effect."
  (request ranger playhouse.ranger:+req-set-config+ config)
  (setf (config ranger) (answer-of ranger playhouse.ranger:+req-get-config+)))

;;; laser

(defmethod scan ((laser laser))
  (multiple-value-bind (data time) (newest laser playhouse.laser:+data-scan+)
    (let ((ranges (playhouse.laser:data-ranges data)))
      (make-scan ranges
                 (spread (playhouse.laser:data-min-angle data) (playhouse.laser:data-max-angle data) (length ranges))
                 (playhouse.laser:data-max-range data)
                 time))))

(define-updates laser scan)

(defmethod ranges ((laser laser))
  (scan-ranges (scan laser)))

(defmethod intensities ((laser laser))
  (playhouse.laser:data-intensity (newest laser playhouse.laser:+data-scan+)))

(defmethod config ((laser laser))
  (answer-of laser playhouse.laser:+req-get-config+))

(defmethod set-config ((laser laser) config)
  (request laser playhouse.laser:+req-set-config+ config))

(define-geometry laser playhouse.laser:+req-get-geom+ playhouse.laser:geom-pose playhouse.laser:geom-size)

;;; sonar

(defmethod ranges ((sonar sonar))
  (playhouse.sonar:data-ranges (newest sonar playhouse.sonar:+data-ranges+)))

(define-updates sonar ranges)

(define-operation poses ((sonar sonar))
  "Poses of the sonars on the robot, in the order of the ranges: a list of pose3d."
  (map 'list #'pose3d-of (playhouse.sonar:geom-poses (answer-of sonar playhouse.sonar:+req-get-geom+))))

(defmethod set-power ((sonar sonar) on)
  (request sonar playhouse.sonar:+req-power+ (playhouse.sonar:make-power-config :state (if on 1 0))))

;;; fiducial

(defstruct (marker (:constructor make-marker (id pose)))
  "A marker in view: its id, and its pose, a pose3d in the sensor's frame."
  id pose)

(defun marker-distance (marker)
  "In m, in the sensor's plane."
  (let ((pose (marker-pose marker)))
    (without-float-traps (abs (complex (pose3d-x pose) (pose3d-y pose))))))

(defun marker-bearing (marker)
  "In rad, to the left of the sensor's x axis."
  (let ((pose (marker-pose marker)))
    (without-float-traps (atan (pose3d-y pose) (pose3d-x pose)))))

(define-operation markers ((finder fiducial))
  "The markers in view, a list. Signals no-data."
  (map 'list (lambda (item)
               (make-marker (playhouse.fiducial:item-id item) (pose3d-of (playhouse.fiducial:item-pose item))))
       (playhouse.fiducial:data-fiducials (newest finder playhouse.fiducial:+data-scan+))))

(define-updates fiducial markers)

(define-operation field-of-view ((finder fiducial))
  "A playhouse.fiducial:fov."
  (answer-of finder playhouse.fiducial:+req-get-fov+))

(define-operation set-field-of-view ((finder fiducial) min-range max-range view-angle)
  "Ranges in m, the full field of view in rad."
  (insist-on-finite finder "min_range" min-range "max_range" max-range "view_angle" view-angle)
  (request finder playhouse.fiducial:+req-set-fov+
           (playhouse.fiducial:make-fov :min-range min-range :max-range max-range :view-angle view-angle)))

(define-geometry fiducial playhouse.fiducial:+req-get-geom+
  playhouse.fiducial:geom-pose playhouse.fiducial:geom-size)
