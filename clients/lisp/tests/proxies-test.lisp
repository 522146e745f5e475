;;;; What the proxies make of their interfaces' values.

(in-package #:playhouse-client.tests)

(defun wire-turned (x y a)
  (playhouse.common:make-pose2d :px x :py y :pa a))

(defun wire-turned3d (x y z roll pitch yaw)
  (playhouse.common:make-pose3d :px x :py y :pz z :proll roll :ppitch pitch :pyaw yaw))

(defmacro with-data ((client &rest messages-and-values) &body body)
  "Runs BODY with a client of a server that acknowledges everything and sends these data in each round."
  `(with-connection (,client (rounds (peer header)
                               (answer peer header)
                               (when (data-request-p header)
                                 ,@(loop for (message value . options) in messages-and-values
                                         collect `(put-data peer ,message ,value ,@options))
                                 (put-synch peer))))
     ,@body))

(defun sent-to (peer code kind)
  "Subtype and body of the messages of this kind to devices of an interface."
  (loop for (header . body) in (received-of peer)
        when (and (= (header-interface header) code) (eq (header-kind header) kind))
          collect (list (header-subtype header) body)))

(deftest states-and-scans-tell-their-time
  (with-data (client (playhouse.position2d:+data-state+ (base-data 1d0) :timestamp 7.5d0)
                     (playhouse.laser:+data-scan+
                      (playhouse.laser:make-data :ranges '(1 2 4) :min-angle -1 :max-angle 1 :max-range 8)
                      :timestamp 8.5d0))
    (let ((robot (open-device client :position2d)) (scanner (open-device client :laser)))
      (read-data client)
      (let ((scan (scan scanner)))
        (check (= (state-time (state robot)) 7.5d0))
        (check (= (scan-time scan) 8.5d0))
        (check (equalp (scan-ranges scan) #(1 2 4)))
        (check (equalp (scan-angles scan) #(-1 0 1)))
        (check (= (nearest scan) 1))
        (check (= (nearest scan -0.5 0.5) 2))
        (check (= (nearest scan 2 3) 8))
        (check (= (nearest scan 0 0) 2))
        (check-error invalid-value "from the lower to the higher, not from 1.0 to 0.5" (nearest scan 1.0 0.5))
        (check-error invalid-value "not from nan to " (nearest scan *nan*))
        (check-error invalid-value "not from FAR to " (nearest scan 'far))
        (check-error invalid-value "nearest is a function of scan, not of laser:0" (nearest scanner))
        (check (equalp (second (points scan)) '(2 0)))))))

(deftest ranges-that-are-not-numbers-do-no-harm
  (with-data (client (playhouse.laser:+data-scan+
                      (playhouse.laser:make-data :ranges (list *nan* 3 +infinity+) :min-angle -1 :max-angle 1
                                                 :max-range 8)))
    (let ((scanner (open-device client :laser)))
      (read-data client)
      (check (= (nearest (scan scanner) -0.5 1) 3))
      (check (not (finitep (first (first (points (scan scanner))))))))))

(deftest a-ranger-has-the-directions-of-its-elements
  (let ((config (playhouse.ranger:make-config :min-angle -1 :max-angle 1 :max-range 5))
        (geom (playhouse.ranger:make-geom :element-poses (list (wire-turned3d 0 0 0 0 0 0.5d0)
                                                                (wire-turned3d 0 0 0 0 0 -2))))
        (told (list '(1 2) '(1 2 3))))
    (with-connection (client (rounds (peer header)
                               (answer peer header :body (cond ((/= (header-interface header) 62) #())
                                                               ((= (header-subtype header) 5) (encode config))
                                                               (t (encode geom))))
                               (when (data-request-p header)
                                 (put-data peer playhouse.ranger:+data-range+
                                           (playhouse.ranger:make-data-range :ranges (pop told)))
                                 (put-synch peer))))
      (let ((ranger (open-device client :ranger)))
        (check (equalp (scan-angles (next-update ranger)) #(0.5 -2)))
        (check (equalp (scan-angles (next-update ranger)) #(-1 0 1)))
        (check (= (scan-max-range (scan ranger)) 5))))))

(deftest a-camera-tells-its-pixels
  (let ((pictures
          (loop for (width height format compression bytes) in
                `((2 1 ,playhouse.camera:+format-rgb888+ 0 #(1 2 3 4 5 6))
                  (1 2 ,playhouse.camera:+format-mono16+ 0 #(#x34 #x12 0 0))
                  (2 1 ,playhouse.camera:+format-rgb888+ 1 #(255 216))
                  (2 1 ,playhouse.camera:+format-rgb888+ 0 #(1 2 3 4 5))
                  (2 1 ,playhouse.camera:+format-rgb888+ 0 #(0 0 0 0 0 1)))
                collect (playhouse.camera:make-data :width width :height height :format format :compression compression
                                                    :image bytes))))
    (with-data (client (playhouse.camera:+data-state+ (pop pictures) :timestamp 2.5d0))
      (let ((eye (open-device client :camera)))
        (read-data client)
        (check (equal (pixel (image eye) 0 0) '(1 2 3)))
        (check (equal (pixel (image eye) 1 0) '(4 5 6)))
        (check (= (image-time (image eye)) 2.5d0))
        (check (= (model-at (image eye) 1 0) #x040505))
        (check-error invalid-value "pixel 2, 0 is outside the 2 x 1 picture" (pixel (image eye) 2 0))
        (read-data client)
        (check (equal (pixel (image eye) 0 0) '(#x1234)))
        (check (equal (pixel (image eye) 0 1) '(0)))
        (check-error invalid-value "RGB888 alone" (model-at (image eye) 0 0))
        (read-data client)
        (check (image-jpeg-p (image eye)))
        (check-error invalid-value "raw MONO8, MONO16 and RGB888 alone" (pixel (image eye) 0 0))
        (read-data client)
        (check (equal (pixel (image eye) 0 0) '(1 2 3)))
        (check-error invalid-value "fewer bytes than pixels: 5" (pixel (image eye) 1 0))
        (read-data client)
        (check (equal (list (model-at (image eye) 0 0) (model-at (image eye) 1 0)) '(nil 0)))))))

(deftest a-bumper-tells-which-switches-are-pressed-and-where-they-are
  (let ((front (playhouse.bumper:make-define :pose (wire-turned3d 0.25d0 0 0.1d0 0 0 0.5d0) :length 0.5d0)))
    (with-connection (client (rounds (peer header)
                               (answer peer header :body (encode (playhouse.bumper:make-geom :bumper-def (list front))))
                               (when (data-request-p header)
                                 (put-data peer playhouse.bumper:+data-state+
                                           (playhouse.bumper:make-data :bumpers #(0 1 255)))
                                 (put-synch peer))))
      (with-device (skirt client :bumper)
        (check (equal (next-update skirt) '(nil t t)))
        (check (equal (pressed skirt) '(nil t t)))
        (let ((face (first (faces skirt))))
          (check (equalp (face-pose face) (make-pose3d :x 0.25d0 :z 0.1d0 :yaw 0.5d0)))
          (check (= (face-length face) 0.5))
          (check (= (face-radius face) 0)))))))

(deftest data-of-another-kind-are-named
  (with-data (client (playhouse.imu:+data-state+ (playhouse.imu:make-data-state)))
    (with-device (unit client :imu)
      (next-data unit)
      (check-error no-data "imu:0 sends imu.data.state, not imu.data.calib; (send imu playhouse.imu:+data-calib+) selects it"
        (inertia unit)))))

(deftest an-inertial-unit-tells-what-it-feels-and-how-it-stands
  (let ((felt (playhouse.imu:make-data-calib :accel-x 0.5 :accel-y 0.25 :accel-z 9.75 :gyro-z 1.5 :magn-y 0.5
                                            :magn-z -0.5))
        (at (wire-turned3d 1 2 3 0 0 0.5d0)))
    (with-data (client (playhouse.imu:+data-state+ (playhouse.imu:make-data-state) :timestamp 1d0)
                       (playhouse.imu:+data-euler+
                        (playhouse.imu:make-data-euler
                         :calib-data felt
                         :orientation (playhouse.common:make-orientation3d :proll 0.1d0 :ppitch 0.2d0 :pyaw 0.3d0))
                        :timestamp 2d0)
                       (playhouse.imu:+data-quat+ (playhouse.imu:make-data-quat :calib-data felt :q0 1) :timestamp 3d0)
                       (playhouse.imu:+data-fullstate+
                        (playhouse.imu:make-data-fullstate :pose at :vel (playhouse.common:make-pose3d :px 0.25d0))
                        :timestamp 4d0))
      (with-device (unit client :imu)
        (check-error no-data "imu:0 has sent no data yet" (inertia unit))
        (send unit playhouse.imu:+data-euler+)
        (check (= (next-update unit) 4d0))
        (let ((inertia (inertia unit)))
          (check (equalp (inertia-acceleration inertia) '(0.5 0.25 9.75)))
          (check (equalp (inertia-turn-rate inertia) '(0 0 1.5)))
          (check (equalp (inertia-field inertia) '(0 0.5 -0.5))))
        (check (equalp (attitude unit) '(0.1d0 0.2d0 0.3d0)))
        (check (equalp (quaternion unit) '(1 0 0 0)))
        (check (equalp (pose unit) (make-pose3d :x 1 :y 2 :z 3 :yaw 0.5d0))) ; the newer of two kinds of data
        (check (= (pose3d-x (velocity unit)) 0.25))
        (reset-orientation unit)
        (check-error invalid-value "yaw is nan" (reset-attitude unit 0 0 *nan*))
        (check (equalp (mapcar #'second (sent-to peer 60 :req)) (list (words 4) (words 0))))))))

(deftest a-receiver-tells-degrees-and-metres-and-a-cloud-points
  (with-data (client (playhouse.gps:+data-state+
                      (playhouse.gps:make-data :latitude 507747000 :longitude -60839000 :altitude 220500 :quality 1
                                               :num-sats 8 :err-horz 2))
                     (playhouse.pointcloud3d:+data-state+
                      (playhouse.pointcloud3d:make-data
                       :points (list (playhouse.pointcloud3d:make-element
                                      :point (playhouse.common:make-point3d :px 1 :py 2 :pz 3)
                                      :color (playhouse.common:make-color :alpha 255 :red 200)))))
                     (playhouse.position3d:+data-state+
                      (playhouse.position3d:make-data :pos (wire-turned3d 1 2 3 0.1d0 0.2d0 0.3d0) :stall 1)))
    (let ((receiver (open-device client :gps)) (cloud (open-device client :pointcloud3d))
          (base (open-device client :position3d)))
      (let ((fix (next-update receiver)))
        (check (< (abs (- (fix-latitude fix) 50.7747d0)) 1d-9))
        (check (< (abs (- (fix-longitude fix) -6.0839d0)) 1d-9))
        (check (equalp (list (fix-altitude fix) (fix-quality fix) (fix-satellites fix) (fix-horizontal-error fix))
                       '(220.5d0 1 8 2))))
      (let ((point (first (points cloud))))
        (check (equalp (list (point-x point) (point-y point) (point-z point) (point-color point))
                       '(1 2 3 (200 0 0 255)))))
      (check (= (pose3d-roll (state3d-pose (state base))) 0.1d0))
      (check (state3d-stalled-p (state base)))
      (check-error invalid-value "vz is inf" (drive base 0.1 :vz +infinity+))
      (drive base 0.5 :va 0.25)
      (close-device base)
      (check (equalp (loop for (subtype body) in (sent-to peer 30 :cmd)
                           for vel = (playhouse.position3d:cmd-vel-vel (decode 'playhouse.position3d:cmd-vel body))
                           collect (list subtype (playhouse.common:pose3d-px vel) (playhouse.common:pose3d-pyaw vel)))
                     '((1 0.5 0.25) (1 0 0)))))))  ; stopped as it closes

(deftest analog-inputs-are-voltages-and-outputs-are-set-one-by-one
  (with-data (client (playhouse.aio:+data-state+ (playhouse.aio:make-data :voltages '(0.5 -3))))
    (with-device (box client :aio)
      (check (equalp (next-update box) #(0.5 -3)))
      (check (equalp (voltages box) #(0.5 -3)))
      (set-voltage box 1 0.25)
      (check-error invalid-value "voltage is nan, not a finite number" (set-voltage box 1 *nan*)))
    (check (equalp (sent-to peer 21 :cmd) (list (list 1 (words 1 #x3e800000)))))))

(deftest messages-are-kept-until-they-are-taken
  (let ((texts (list "a" "b" "c")))
    (with-data (client (playhouse.speech-recognition:+data-string+
                        (playhouse.speech-recognition:make-data :text (c-string (or (pop texts) "more"))))
                       (playhouse.speech-recognition:+data-string+
                        (playhouse.speech-recognition:make-data :text (c-string (or (pop texts) "more")))))
      (let ((ears (open-device client :speech-recognition)))
        (check (equal (next-update ears) "a"))
        (check (equal (next-update ears) "b"))
        (check (equal (take-texts ears) '()))
        (read-data client)
        (check (equal (take-texts ears) '("c" "more")))
        (dotimes (i 600) (read-data client))
        (check (= (length (take-texts ears)) 1024))))))

(defun kind-for (asked)
  "Of the answer to a request for a pose: a variance that is negative is refused."
  (if (minusp (elt (playhouse.localize:set-pose-cov asked) 0)) :nack :ack))

(deftest a-localization-tells-where-the-robot-may-be-and-is-told
  (let ((told (list (list (playhouse.localize:make-hypoth :mean (wire-turned 1 2 0.5d0)
                                                          :cov '(0.25d0 0.5d0 0.125d0 0.1d0 0.2d0 0.3d0) :alpha 0.75d0)
                          (playhouse.localize:make-hypoth :alpha 0.25d0))
                    '()))
        (particle (playhouse.localize:make-particle :pose (wire-turned 3 4 1) :alpha 0.5d0)))
    (with-connection (client (rounds (peer header body)
                               (cond ((data-request-p header)
                                      (answer peer header)
                                      (put-data peer playhouse.localize:+data-hypoths+
                                                (playhouse.localize:make-data :hypoths (pop told)))
                                      (put-synch peer))
                                     ((= (header-subtype header) 2)
                                      (answer peer header
                                              :body (encode (playhouse.localize:make-get-particles
                                                             :particles (list particle)))))
                                     (t (let ((asked (decode 'playhouse.localize:set-pose body)))
                                          (answer peer header :kind (kind-for asked)))))))
      (with-device (place client :localize)
        (check-error no-data "localize:0 has sent no data yet" (pose place))
        (let ((found (next-update place)))
          (check (= (length found) 2))
          (check (equalp (hypothesis-pose (first found)) (turned 1 2 0.5d0)))
          (check (equalp (hypothesis-covariance (first found))
                         (make-covariance :xx 0.25d0 :yy 0.5d0 :aa 0.125d0 :xy 0.1d0 :ya 0.2d0 :xa 0.3d0)))
          (check (= (hypothesis-weight (second found)) 0.25d0)))
        (check (equalp (pose place) (turned 1 2 0.5d0)))
        (read-data client)
        (check-error no-data "localize:0 has no hypothesis" (pose place))
        (set-pose place (turned 1 2 0.5d0) (covariance-of-deviations 0.5d0 2 3))
        (check-error request-refused "localize.req.set_pose of localize:0 was refused"
          (set-pose place (turned 1 2 0.5d0) (make-covariance :xx -1)))
        (check-error invalid-value "localize:0: y is nan, not a finite number"
          (set-pose place (turned 1 *nan* 0) (make-covariance)))
        (check-error invalid-value "localize:0: xa is inf, not a finite number"
          (set-pose place (make-pose) (make-covariance :xa +infinity+)))
        (let ((particle (first (particles place))))
          (check (equalp (particle-pose particle) (turned 3 4 1)))
          (check (= (particle-weight particle) 0.5d0)))
        (let ((sent (remove 1 (sent-to peer 25 :req) :key #'first :test #'/=)))
          (check (= (length sent) 2))
          (check (equalp (playhouse.localize:set-pose-cov (decode 'playhouse.localize:set-pose (second (first sent))))
                         #(0.25 4 9 0 0 0))))))))

(deftest a-planner-goes-to-a-goal-and-tells-when-the-robot-is-there
  (let* ((goal (wire-turned 6 4 1.5d0)) (way (wire-turned 2 1 0))
         (told (list (playhouse.planner:make-data :valid 1 :done 1 :waypoint-idx -1) ; of a goal before
                     (playhouse.planner:make-data :valid 1 :pos (wire-turned 0.5d0 0 0) :goal goal :waypoint way
                                                  :waypoint-idx 1 :waypoints-count 3)
                     (playhouse.planner:make-data :valid 1 :done 1 :pos goal :goal goal :waypoint-idx -1
                                                  :waypoints-count 3))))
    (with-connection (client (rounds (peer header)
                               (cond ((data-request-p header)
                                      (answer peer header)
                                      (put-data peer playhouse.planner:+data-state+ (pop told) :timestamp 2.5d0)
                                      (put-synch peer))
                                     ((eq (header-kind header) :req)
                                      (answer peer header
                                              :body (if (= (header-subtype header) 1)
                                                        (encode (playhouse.planner:make-waypoints-req
                                                                 :waypoints-distance 7.5d0 :waypoints (list way goal)))
                                                        #()))))))
      (with-device (guide client :planner)
        (check-error no-data "planner:0 has sent no data yet" (state guide))
        (check (not (arrivedp guide)))
        (go-to guide (turned 6 4 (+ 1.5d0 (* 4 pi))))
        (let ((states '()))
          (do-updates (state guide)
            (push state states)
            (when (arrivedp guide) (return)))
          (check (= (length states) 3))
          (let ((state (second states)))
            (check (planner-state-valid-p state))
            (check (not (planner-state-done-p state)))
            (check (equalp (planner-state-pose state) (turned 0.5d0 0 0)))
            (check (equalp (planner-state-goal state) (turned 6 4 1.5d0)))
            (check (equalp (planner-state-waypoint state) (turned 2 1 0)))
            (check (equalp (list (planner-state-index state) (planner-state-count state) (planner-state-time state))
                           '(1 3 2.5d0)))))
        (stop guide)
        (resume guide)
        (check (equalp (path-waypoints (path guide)) (list (turned 2 1 0) (turned 6 4 1.5d0))))
        (check (= (path-length (path guide)) 7.5d0))
        (go-to guide (turned 6 4 0))
        (check (not (arrivedp guide)))    ; another heading
        (check-error invalid-value "planner:0: y is inf, not a finite number" (go-to guide (turned 0 +infinity+ 0)))
        (check (equalp (remove 1 (sent-to peer 44 :req) :key #'first)
                       (list (list 2 (words 0)) (list 2 (words 1)))))))))

;;; Maps

(defun map-script (infos tiles)
  "Answers with the next info, and with what TILES makes of the tile that is asked for."
  (rounds (peer header body)
    (answer peer header
            :body (encode (if (= (header-subtype header) (message-type-subtype playhouse.map:+req-get-info+))
                              (pop infos)
                              (funcall tiles (decode 'playhouse.map:data body)))))))

(defun cell-value (column row)
  (- (mod (+ column (* 3 row)) 201) 100))

(defun tile-values (tile)
  (let ((width (playhouse.map:data-width tile)) (values '()))
    (dotimes (i (* width (playhouse.map:data-height tile)) (coerce (nreverse values) 'octets))
      (multiple-value-bind (row column) (floor i width)
        (push (ldb (byte 8 0) (cell-value (+ column (playhouse.map:data-col tile))
                                          (+ row (playhouse.map:data-row tile))))
              values)))))

(deftest a-map-comes-whole-in-tiles
  (let ((width 600) (height 514))
    (with-connection (client (map-script (list (playhouse.map:make-info :scale 0.5 :width width :height height
                                                                         :origin (wire-turned -1 2 0)))
                                         (lambda (tile)
                                           (setf (playhouse.map:data-data tile) (tile-values tile)
                                                 (playhouse.map:data-data-range tile) 100)
                                           (when (zerop (playhouse.map:data-row tile)) ; others as a server without zlib
                                             (setf (playhouse.map:data-data tile)
                                                   (stored-zlib (playhouse.map:data-data tile))))
                                           tile))
                             :mode :push)
      (let* ((cells (cells (open-device client :map))) (wrong 0))
        (check (equal (array-dimensions cells) (list height width)))
        (dotimes (row height)
          (dotimes (column width)
            (let ((value (cell-value column row)))
              (unless (= (aref cells row column) (cond ((> value 50) 1) ((< value -50) -1) (t 0)))
                (incf wrong)))))
        (check (= wrong 0))
        (check (equalp (loop for (nil body) in (remove 1 (sent-to peer 42 :req) :key #'first)
                             for tile = (decode 'playhouse.map:data body)
                             collect (list (playhouse.map:data-col tile) (playhouse.map:data-row tile)
                                           (playhouse.map:data-width tile) (playhouse.map:data-height tile)))
                       '((0 0 512 512) (512 0 88 512) (0 512 512 2) (512 512 88 2))))))))

(defun stored-zlib (octets)
  "A zlib stream of blocks that are not compressed."
  (let ((a 1) (b 0) (blocks '()))
    (loop for byte across octets do (setf a (mod (+ a byte) 65521) b (mod (+ a b) 65521)))
    (loop for start from 0 below (length octets) by 65535
          do (let* ((end (min (length octets) (+ start 65535))) (size (- end start)) (rest (logxor size #xffff)))
               (push (concatenate 'octets
                                  (list (if (= end (length octets)) 1 0) (ldb (byte 8 0) size) (ash size -8)
                                        (ldb (byte 8 0) rest) (ash rest -8))
                                  (subseq octets start end))
                     blocks)))
    (apply #'concatenate 'octets #(#x78 1) (append (reverse blocks) (list (words (logior (ash b 16) a)))))))

(defparameter *three-ones* #(120 156 99 100 100 4 0 0 9 0 4) "Three bytes of 1, as zlib compresses them.")

(deftest compressed-bytes-are-inflated
  (check (equalp (playhouse-client::uncompressed (coerce *three-ones* 'octets) 3) #(1 1 1)))
  (check (= (length (playhouse-client::uncompressed (stored-zlib (make-array 1000 :element-type '(unsigned-byte 8)
                                                                                  :initial-element 1))
                                                    4))
            5))
  (check (equalp (playhouse-client::uncompressed (coerce #(1 2 3 4) 'octets) 4) #(1 2 3 4))))

(deftest maps-that-make-no-sense-are-an-error
  (flet ((info (scale width height &optional (x 0))
           (playhouse.map:make-info :scale scale :width width :height height :origin (wire-turned x 0 0))))
    (let ((tiles (list (coerce *three-ones* 'octets)
                       (stored-zlib (make-array 100000 :element-type '(unsigned-byte 8) :initial-element 0)))))
      (with-connection (client (map-script (list (info 0 2 2) (info *nan* 2 2) (info 0.5 2 2 +infinity+)
                                                 (info 0.5 (ash 1 14) (1+ (ash 1 12))) (info 0.5 2 2) (info 0.5 2 2)
                                                 (info 0.5 0 (ash 1 31)))
                                           (lambda (tile)
                                             (setf (playhouse.map:data-data tile) (pop tiles))
                                             tile))
                               :mode :push)
        (let ((plan (open-device client :map)))
          (dolist (text '("map:0: invalid map: cells of 0.0 m from (0.0, 0.0, 0.0) on" "cells of nan m"
                          "from (inf, 0.0, 0.0)"
                          "16384 x 4097 cells are over the limit of 67108864"
                          "a tile of 2 x 2 cells is damaged" "a tile of 2 x 2 cells is damaged"))
            (check-error wire-error text (cells plan)))
          (check (equal (array-dimensions (cells plan)) '(0 0))))))))

(deftest a-point-of-the-world-is-in-a-cell-or-beyond-the-map
  (let ((grid (make-grid :cell-size 0.5d0 :width 4 :height 2 ; columns go along y, rows against x
                         :origin (turned 10d0 20d0 (/ pi 2)))))
    (check (equal (multiple-value-list (cell-of grid 9.9d0 20.1d0)) '(0 0)))
    (check (equal (multiple-value-list (cell-of grid 9.4d0 21.9d0)) '(3 1)))
    (loop for (x y) in `((10.1d0 20.1d0) (9.9d0 19.9d0) (9.9d0 22.1d0) (8.9d0 20.1d0) (,*nan* 20.1d0)
                         (9.9d0 ,+infinity+))
          do (check (null (cell-of grid x y))))))

;;; The simulation

(deftest the-world-is-stepped-reset-and-given-robots
  (let ((answers (list '(:ack "") '(:ack "") '(:ack "r7") '(:ack "") '(:nack "no reason")
                       '(:nack "the run has ended"))))
    (with-connection (client (rounds (peer header body)
                               (destructuring-bind (kind text) (pop answers)
                                 (let ((asked (decode 'playhouse.simulation:property-req body)))
                                   (setf (playhouse.simulation:property-req-value asked) (c-string text))
                                   (when (eq kind :ack) ; data of the tick come before the answer
                                     (put-state peer 1d0))
                                   (answer peer header :kind kind :body (encode asked)))))
                             :mode :push)
      (let ((simulator (open-device client :simulation)) (robot (open-device client :position2d)))
        (join simulator "me")
        (check (not (device-has-data-p robot)))
        (step-world simulator 3)
        (check (device-has-data-p robot))
        (check (string= (spawn simulator "r0" (turned 1 2 0.5d0) "r7") "r7"))
        (reset-world simulator 258)
        (check-error request-refused "remove was refused: no reason" (remove-model simulator "r9"))
        (check-error run-ended "the run has ended" (step-world simulator))
        (check (equalp (loop for (nil body) in (sent-to peer 31 :req)
                             for asked = (decode 'playhouse.simulation:property-req body)
                             collect (list (text (playhouse.simulation:property-req-prop asked))
                                           (text (playhouse.simulation:property-req-name asked))
                                           (playhouse.simulation:property-req-value asked)))
                       `(("join" "" ,(c-string "me"))
                         ("step" "" #(3 0 0 0))
                         ("spawn" "r0" ,(concatenate 'octets #(0 0 0 0 0 0 #xf0 #x3f) #(0 0 0 0 0 0 0 #x40)
                                                     #(0 0 0 0 0 0 #xe0 #x3f) (c-string "r7")))
                         ("reset" "" #(2 1 0 0 0 0 0 0))
                         ("remove" "r9" #())
                         ("step" "" #(1 0 0 0)))))))))

(deftest a-reset-drops-what-came-before-its-answer-and-keeps-what-comes-after
  (with-connection (client (rounds (peer header body)
                             (put-state peer 2d0 :timestamp 2d0)
                             (put-data peer playhouse.opaque:+data-state+
                                       (playhouse.opaque:make-data :data (bytes-of "old")) :timestamp 2d0)
                             (answer peer header :body body)
                             (put-state peer 3d0 :timestamp 0.5d0))
                           :mode :push)
    (let ((robot (open-device client :position2d)) (radio (open-device client :opaque))
          (simulator (open-device client :simulation)))
      (step-world simulator)
      (check (device-has-data-p robot))
      (check (device-has-data-p radio))
      (reset-world simulator 7)
      (dolist (device (list robot radio))
        (check (not (device-has-data-p device)))
        (check (not (device-fresh-p device)))
        (check (zerop (device-timestamp device))))
      (check (null (take-messages radio)))
      (check-error no-data "position2d:0 has sent no data yet" (state robot))
      (next-data robot)
      (check (= (pose-x (state-pose (state robot))) 3)))))

(deftest a-refused-reset-drops-nothing
  (with-connection (client (rounds (peer header)
                             (put-state peer 2d0)
                             (answer peer header :kind :nack))
                           :mode :push)
    (let ((robot (open-device client :position2d)) (simulator (open-device client :simulation)))
      (check-error request-refused "reset was refused" (reset-world simulator 7))
      (read-data client)
      (check (device-has-data-p robot)))))

(deftest a-time-that-goes-back-drops-what-other-devices-have-of-a-later-one
  (with-connection (client (rounds (peer header body)
                             (put-state peer 1d0 :index 0 :timestamp 0.5d0)
                             (put-state peer 2d0 :index 1 :timestamp 1d0)
                             (put-state peer 3d0 :index 2 :timestamp 2d0)
                             (put-state peer 4d0 :index 1 :timestamp 0.5d0)
                             (answer peer header :body body))
                           :mode :push)
    (let ((before (open-device client :position2d 0)) (back (open-device client :position2d 1))
          (later (open-device client :position2d 2)))
      (step-world (open-device client :simulation))
      (check (= (pose-x (state-pose (state before))) 1))
      (check (= (pose-x (state-pose (state back))) 4))
      (check (not (device-has-data-p later))))))

;; It is compared, and SBCL traps that by default.
(deftest a-time-that-is-not-a-number-does-no-harm
  (with-data (client (playhouse.position2d:+data-state+ (base-data 1d0) :timestamp *nan*)
                     (playhouse.position2d:+data-state+ (base-data 2d0) :timestamp 1d0)
                     (playhouse.position2d:+data-state+ (base-data 3d0) :timestamp 0.5d0))
    (let ((robot (open-device client :position2d)))
      (check (= (read-data client) 3))
      (check (= (pose-x (state-pose (state robot))) 3)))))

;;; Functions of other interfaces

(defun required-count (function)
  (let ((names (sb-mop:generic-function-lambda-list function)))
    (or (position-if (lambda (name) (member name lambda-list-keywords)) names) (length names))))

(deftest functions-of-other-interfaces-are-invalid-and-send-nothing
  (with-connection (client (rounds (peer header) (error "this was sent: ~a" header)))
    (let ((base (open-device client :position2d)) (laser (open-device client :laser)) (other (open-device client :dio))
          (count 0))
      (macrolet ((refused-each (device &rest calls)
                   `(progn ,@(loop for (name . arguments) in calls
                                   collect `(check-error invalid-value
                                                (format nil "~(~a~) is a function of " ',name)
                                              (,name ,device ,@arguments))
                                   collect `(check-error invalid-value (format nil ", not of ~a" (device-name ,device))
                                              (,name ,device ,@arguments))))))
        (refused-each base
          (model-pose "r0") (set-model-pose "r0" (make-pose)) (model-pose3d "r0") (set-model-pose3d "r0" (make-pose3d))
          (pause) (save-world) (reset-world) (reset-world 3) (join "me") (step-world) (step-world 3)
          (spawn "r0" (make-pose)) (remove-model "r0") (image) (view) (look 1) (turn 1 2) (set-velocity-control t)
          (send-to "a" #(1)) (take-messages) (take-texts) (say "hi") (faces) (inertia) (attitude) (quaternion)
          (reset-orientation) (reset-attitude 0 0 0) (fix) (voltages) (set-voltage 0 3) (hypotheses)
          (set-pose (make-pose) (make-covariance)) (particles) (arrivedp) (resume) (path) (grid) (set-intensities t)
          (poses) (markers) (field-of-view) (set-field-of-view 0 1 1) (ranges) (send #(1)))
        (refused-each laser
          (cells) (pressed) (drive-car 1 0) (stalled-p) (drive 1 :va 0) (state) (stop) (go-to (make-pose) :speed 1)))
      (do-external-symbols (name '#:playhouse-client)
        (when (and (fboundp name) (typep (fdefinition name) 'playhouse.base:operation))
          (incf count)
          (check-error invalid-value (format nil "~(~a~) is a function of " name)
            (apply name other (make-list (1- (required-count (fdefinition name))))))))
      (check (> count 60))
      (check-error invalid-value "set-power is a function of ranger and sonar, not of position2d:0" (set-power base t))
      (check-error invalid-value "go-to is a function of planner, position2d and position3d, not of #<"
        (go-to client (make-pose)))
      (check-error invalid-value "pause is a function of simulation, not of NIL" (pause nil))
      (check (typep (nth-value 1 (ignore-errors (apply #'drive base '(1 :speed 2)))) 'program-error)))))

(deftest functions-that-only-do-something-return-nothing
  (with-connection (client (rounds (peer header body)
                             (when (eq (header-kind header) :req)
                               (answer peer header :body body)))
                           :mode :push)
    (let ((simulator (open-device client :simulation)) (robot (open-device client :position2d)))
      (macrolet ((nothing (&rest forms)
                   `(progn ,@(loop for form in forms collect `(check (null (multiple-value-list ,form)))))))
        (nothing (pause simulator) (save-world simulator) (reset-world simulator) (reset-world simulator 1)
                 (join simulator "me") (step-world simulator) (remove-model simulator "r0")
                 (set-model-pose simulator "r0" (make-pose)) (set-model-pose3d simulator "r0" (make-pose3d))
                 (drive robot 1) (close-device robot) (close-device robot)
                 (close-client client) (close-client client))))))
