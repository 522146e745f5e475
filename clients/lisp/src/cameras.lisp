;;;; Cameras and their mounts.

(in-package #:playhouse-client)

(defclass camera (device) ()
  (:documentation "A camera."))

(defclass ptz (device) ()
  (:documentation "A pan-tilt-zoom mount of a camera."))

(defstruct (view (:constructor make-view (pan tilt zoom pan-speed tilt-speed)))
  "State of a camera mount: pan to the left, tilt upwards and horizontal field of view, in rad; speeds in rad/s."
  pan tilt zoom pan-speed tilt-speed)

(define-operation image ((camera camera))
  "The newest image. Signals no-data."
  (multiple-value-bind (data time) (newest camera playhouse.camera:+data-state+)
    (make-image (playhouse.camera:data-width data) (playhouse.camera:data-height data)
                (playhouse.camera:data-format data)
                (= (playhouse.camera:data-compression data) playhouse.camera:+compress-jpeg+)
                (playhouse.camera:data-image data)
                time)))

(define-updates camera image)

(define-operation view ((mount ptz))
  "The current direction and field of view. Signals no-data."
  (let ((data (newest mount playhouse.ptz:+data-state+)))
    (make-view (playhouse.ptz:data-pan data) (playhouse.ptz:data-tilt data) (playhouse.ptz:data-zoom data)
               (playhouse.ptz:data-panspeed data) (playhouse.ptz:data-tiltspeed data))))

(define-updates ptz view)

(define-operation look ((mount ptz) pan &optional (tilt 0) (zoom 0))
  "Turns to these angles, in position control; a zoom of 0 keeps the field of view."
  (insist-on-finite mount "pan" pan "tilt" tilt "zoom" zoom)
  (command mount playhouse.ptz:+cmd-state+ (playhouse.ptz:make-cmd :pan pan :tilt tilt :zoom zoom)))

(define-operation turn ((mount ptz) pan-speed &optional (tilt-speed 0))
  "Turns at these speeds; requires velocity control."
  (insist-on-finite mount "pan_speed" pan-speed "tilt_speed" tilt-speed)
  (command mount playhouse.ptz:+cmd-state+ (playhouse.ptz:make-cmd :panspeed pan-speed :tiltspeed tilt-speed)))

(define-operation set-velocity-control ((mount ptz) on)
  "Selects velocity control, or position control."
  (request mount playhouse.ptz:+req-control-mode+
           (playhouse.ptz:make-req-control-mode
            :mode (if on playhouse.ptz:+velocity-control+ playhouse.ptz:+position-control+))))

(define-geometry ptz playhouse.ptz:+req-geom+ playhouse.ptz:geom-pos playhouse.ptz:geom-size)
