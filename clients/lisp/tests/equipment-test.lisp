;;;; Proxies of batteries, grippers, joints, lamps, blobfinders and radios.

(in-package #:playhouse-client.tests)

(defmacro with-equipment ((device interface answer &rest messages-and-values) &body body)
  "Runs BODY with a device of a server that answers its requests with ANSWER, nil for none, and sends the next of these
data in each round."
  (let ((told (gensym "TOLD")) (answered (gensym "ANSWER")))
    `(let ((,told (list ,@(loop for (message value) in messages-and-values collect `(cons ,message ,value))))
           (,answered ,answer))
       (with-connection (client (rounds (peer header)
                                  (cond ((data-request-p header)
                                         (answer peer header)
                                         (destructuring-bind (message . value) (pop ,told)
                                           (put-data peer message value :timestamp 2.5d0))
                                         (put-synch peer))
                                        ((eq (header-kind header) :req)
                                         (answer peer header :body (if ,answered (encode ,answered) #()))))))
         (with-device (,device client ,interface)
           ,@body)))))

(defun sent-as (peer type code kind subtype)
  "The structures of this type that were sent by messages of this kind and subtype."
  (loop for (each body) in (sent-to peer code kind)
        when (= each subtype) collect (decode type body)))

(deftest a-battery-tells-what-the-server-reports
  (let ((some (logior playhouse.power:+mask-volts+ playhouse.power:+mask-charging+))
        (others (logior playhouse.power:+mask-percent+ playhouse.power:+mask-joules+ playhouse.power:+mask-watts+)))
    (flet ((data (valid volts watts charging)
             (playhouse.power:make-data :valid valid :volts volts :percent 50 :joules 10 :watts watts
                                        :charging charging)))
      (with-equipment (battery :power nil
                               (playhouse.power:+data-state+ (data some 12.5 3 1))
                               (playhouse.power:+data-state+ (data others 12.5 -3 1))
                               (playhouse.power:+data-state+ (data some 12 0 -1)))
        (check-error no-data "power:0 has sent no data yet" (state battery))
        (let ((state (next-update battery)))
          (check (= (power-state-volts state) 12.5))
          (check (eq (power-state-charging state) :yes))
          (check (equal (list (power-state-percent state) (power-state-joules state) (power-state-watts state))
                        '(nil nil nil)))
          (check (= (power-state-time state) 2.5)))
        (let ((state (next-update battery)))
          (check (equalp (list (power-state-percent state) (power-state-joules state) (power-state-watts state))
                         '(50 10 -3)))
          (check (equal (list (power-state-volts state) (power-state-charging state)) '(nil nil))))
        (check (eq (power-state-charging (next-update battery)) :impossible))
        (set-charging-policy battery t nil)
        (check (equalp (sent-as peer 'playhouse.power:chargepolicy-config playhouse.power:+code+ :req 1)
                       (list (playhouse.power:make-chargepolicy-config :enable-input 1 :enable-output 0))))))))

(deftest a-gripper-opens-and-closes-and-tells-what-it-does
  (flet ((data (state beams)
           (playhouse.gripper:make-data :state state :beams beams)))
    (with-equipment (hand :gripper
                          (playhouse.gripper:make-geom
                           :pose (wire-turned3d 0.25d0 0 0.1d0 0 0 0.5d0)
                           :outer-size (playhouse.common:make-bbox3d :sw 0.1d0 :sl 0.2d0 :sh 0.3d0)
                           :inner-size (playhouse.common:make-bbox3d :sl 0.1d0) :num-beams 2)
                          (playhouse.gripper:+data-state+ (data playhouse.gripper:+state-open+ 8))
                          (playhouse.gripper:+data-state+ (data playhouse.gripper:+state-moving+ 0))
                          (playhouse.gripper:+data-state+ (data playhouse.gripper:+state-error+ 4)))
      (flet ((told ()
               (let ((state (next-update hand)))
                 (list (gripper-state-open-p state) (gripper-state-closed-p state) (gripper-state-moving-p state)
                       (gripper-state-beams state)))))
        (check (equal (told) '(t nil nil 8)))
        (check (equal (told) '(nil nil t 0)))
        (check (equal (told) '(nil nil nil 4))))
      (let ((geometry (geometry hand)))
        (check (equalp (gripper-geometry-pose geometry) (make-pose3d :x 0.25d0 :z 0.1d0 :yaw 0.5d0)))
        (check (= (size-x (gripper-geometry-size geometry)) 0.2d0))
        (check (= (size-x (gripper-geometry-gap geometry)) 0.1d0))
        (check (= (gripper-geometry-beam-count geometry) 2)))
      (open-fingers hand)
      (close-fingers hand)
      (stop hand)
      (check (device-open-p hand))
      (request hand playhouse.gripper:+req-get-geom+) ; answered once the commands have come
      (check (equal (mapcar #'first (sent-to peer playhouse.gripper:+code+ :cmd))
                    (mapcar #'message-type-subtype
                            (list playhouse.gripper:+cmd-open+ playhouse.gripper:+cmd-close+
                                  playhouse.gripper:+cmd-stop+)))))))

(deftest an-arm-has-several-joints
  (with-equipment (arm :actarray
                       (playhouse.actarray:make-geom
                        :actuators (list (playhouse.actarray:make-actuatorgeom
                                          :type playhouse.actarray:+type-rotary+ :length 0.5
                                          :orientation (playhouse.common:make-orientation3d :proll 0.1d0 :pyaw 0.3d0)
                                          :axis (playhouse.common:make-point3d :pz 1) :min -1 :max 1 :home 0.25
                                          :config-speed 2 :hasbrakes 1))
                        :base-pos (playhouse.common:make-point3d :px 1 :py 2 :pz 3)
                        :base-orientation (playhouse.common:make-orientation3d :pyaw 0.125d0))
                       (playhouse.actarray:+data-state+
                        (playhouse.actarray:make-data
                         :motor-state 1
                         :actuators (list (playhouse.actarray:make-actuator
                                           :position 1 :speed 0.5 :acceleration 0.25 :current 2
                                           :state playhouse.actarray:+actstate-moving+)
                                          (playhouse.actarray:make-actuator
                                           :current -1 :state playhouse.actarray:+actstate-braked+)))))
    (check (act-array-state-motors-on-p (next-update arm)))
    (destructuring-bind (first second) (joints arm)
      (check (equalp (list (joint-position first) (joint-speed first) (joint-acceleration first) (joint-current first))
                     '(1 0.5 0.25 2)))
      (check (equal (list (joint-moving-p first) (joint-braked-p first) (joint-stalled-p first)) '(t nil nil)))
      (check (equal (list (joint-moving-p second) (joint-braked-p second) (joint-current second)) '(nil t nil))))
    (let* ((geometry (geometry arm)) (joint (first (act-array-geometry-joints geometry))))
      (check (equalp (act-array-geometry-pose geometry) (make-pose3d :x 1 :y 2 :z 3 :yaw 0.125d0)))
      (check (equal (list (joint-geometry-rotary-p joint) (joint-geometry-has-brakes-p joint)) '(t t)))
      (check (equalp (joint-geometry-axis joint) '(0 0 1)))
      (check (equalp (joint-geometry-orientation joint) '(0.1d0 0 0.3d0)))
      (check (equalp (list (joint-geometry-length joint) (joint-geometry-lowest joint) (joint-geometry-highest joint)
                           (joint-geometry-home joint) (joint-geometry-speed joint))
                     '(0.5 -1 1 0.25 2))))))

(deftest an-arm-is-told-where-to-move-and-how-fast
  (with-equipment (arm :actarray nil)
    (move-to arm 1 0.5)
    (move-all-to arm '(0.5 1.5))
    (move-at arm 1 -0.5)
    (move-all-at arm #(0.25))
    (home arm)
    (home arm 2)
    (check-error invalid-value "actarray:0: joint is -1, not a whole number from 0 to 2147483647" (move-to arm -1 1))
    (check-error invalid-value "actarray:0: position is nan, not a finite number" (move-to arm 0 *nan*))
    (check-error invalid-value "actarray:0: position is inf, not a finite number" (move-all-to arm (list 0 +infinity+)))
    (check-error invalid-value "actarray:0: 0.5 is no sequence of numbers" (move-all-at arm 0.5))
    (set-speed arm +actarray-all+ 0.125)
    (set-motor-power arm nil)
    (set-brakes arm t)
    (flet ((commands (type message)
             (sent-as peer type playhouse.actarray:+code+ (message-type-kind message) (message-type-subtype message))))
      (check (equalp (commands 'playhouse.actarray:position-cmd playhouse.actarray:+cmd-pos+)
                     (list (playhouse.actarray:make-position-cmd :joint 1 :position 0.5))))
      (check (equalp (mapcar #'playhouse.actarray:multi-position-cmd-positions
                             (commands 'playhouse.actarray:multi-position-cmd playhouse.actarray:+cmd-multi-pos+))
                     '(#(0.5 1.5))))
      (check (equalp (commands 'playhouse.actarray:speed-cmd playhouse.actarray:+cmd-speed+)
                     (list (playhouse.actarray:make-speed-cmd :joint 1 :speed -0.5))))
      (check (equalp (mapcar #'playhouse.actarray:multi-speed-cmd-speeds
                             (commands 'playhouse.actarray:multi-speed-cmd playhouse.actarray:+cmd-multi-speed+))
                     '(#(0.25))))
      (check (equal (mapcar #'playhouse.actarray:home-cmd-joint
                            (commands 'playhouse.actarray:home-cmd playhouse.actarray:+cmd-home+))
                    '(-1 2)))
      (check (equalp (commands 'playhouse.actarray:speed-config playhouse.actarray:+req-speed+)
                     (list (playhouse.actarray:make-speed-config :joint -1 :speed 0.125))))
      (check (equalp (commands 'playhouse.actarray:power-config playhouse.actarray:+req-power+)
                     (list (playhouse.actarray:make-power-config :value 0))))
      (check (equalp (commands 'playhouse.actarray:brakes-config playhouse.actarray:+req-brakes+)
                     (list (playhouse.actarray:make-brakes-config :value 1)))))))

(deftest a-lamp-is-switched-colored-and-made-to-flash
  (flet ((color (red green blue &optional (alpha 255))
           (playhouse.common:make-color :alpha alpha :red red :green green :blue blue)))
    (with-equipment (lamp :blinkenlight nil
                          (playhouse.blinkenlight:+data-state+
                           (playhouse.blinkenlight:make-data :enable 1 :period 1.5 :dutycycle 0.5
                                                             :color (color 1 2 3 0))))
      (set-light-power lamp nil)
      (set-color lamp '(4 5 6) 3)
      (flash lamp 2)
      (set-light lamp t 1 0.25 '(7 8 9))
      (check-error invalid-value "blinkenlight:0: period is nan, not a finite number" (flash lamp *nan*))
      (check-error invalid-value "a color is red, green and blue, not (1 2)" (set-color lamp '(1 2)))
      (check-error invalid-value "not (1 2 256)" (set-color lamp '(1 2 256)))
      (let ((state (next-update lamp)))
        (check (light-state-on-p state))
        (check (equalp (list (light-state-period state) (light-state-duty-cycle state) (light-state-color state))
                       '(1.5 0.5 (1 2 3)))))
      (flet ((commands (type message)
               (sent-as peer type playhouse.blinkenlight:+code+ :cmd (message-type-subtype message))))
        (check (equalp (commands 'playhouse.blinkenlight:cmd-power playhouse.blinkenlight:+cmd-power+)
                       (list (playhouse.blinkenlight:make-cmd-power))))
        (check (equalp (commands 'playhouse.blinkenlight:cmd-color playhouse.blinkenlight:+cmd-color+)
                       (list (playhouse.blinkenlight:make-cmd-color :id 3 :color (color 4 5 6)))))
        (check (equalp (commands 'playhouse.blinkenlight:cmd-flash playhouse.blinkenlight:+cmd-flash+)
                       (list (playhouse.blinkenlight:make-cmd-flash :period 2 :dutycycle 0.5))))
        (check (equalp (commands 'playhouse.blinkenlight:cmd playhouse.blinkenlight:+cmd-state+)
                       (list (playhouse.blinkenlight:make-cmd :enable 1 :period 1 :dutycycle 0.25
                                                              :color (color 7 8 9)))))))))

(deftest a-blob-has-a-color-of-three-bytes
  (with-equipment (eye :blobfinder nil
                       (playhouse.blobfinder:+data-blobs+
                        (playhouse.blobfinder:make-data
                         :width 160 :height 120
                         :blobs (list (playhouse.blobfinder:make-blob :id 4 :color #x123456 :area 12 :x 1 :y 2 :left 3
                                                                      :right 4 :top 5 :bottom 6 :range 0.5)))))
    (let ((blob (first (next-update eye))))
      (check (equal (blob-color blob) '(#x12 #x34 #x56)))
      (check (equalp (list (blob-channel blob) (blob-area blob) (blob-x blob) (blob-y blob) (blob-left blob)
                           (blob-right blob) (blob-top blob) (blob-bottom blob) (blob-range blob))
                     '(4 12 1 2 3 4 5 6 0.5))))
    (check (= (length (blobs eye)) 1))
    (let ((size (image-size eye)))
      (check (equal (list (image-size-width size) (image-size-height size)) '(160 120))))))

(deftest levels-of-a-radio-are-signed-in-dbm
  (flet ((data (unit)
           (let ((signal -48) (noise -100))
             (playhouse.wifi:make-data
              :links (list (playhouse.wifi:make-link :mac (c-string "a:b") :ip (c-string "1.2") :essid (c-string "net")
                                                     :freq 2412 :encrypt 1 :qual 40 :level signal :noise noise))
              :throughput 1 :bitrate 2 :mode playhouse.wifi:+mode-infra+ :qual-type unit :maxqual 70
              :maxlevel signal :maxnoise noise :ap (c-string "cc")))))
    (with-equipment (radio :wifi (playhouse.wifi:make-mac-req :mac (c-string "c:d"))
                           (playhouse.wifi:+data-state+ (data playhouse.wifi:+qual-dbm+))
                           (playhouse.wifi:+data-state+ (data playhouse.wifi:+qual-rel+)))
      (check-error no-data "wifi:0 has sent no data yet" (links radio))
      (check (string= (mac radio) "c:d"))
      (let* ((state (next-update radio)) (link (first (wifi-state-links state))))
        (check (equal (list (link-mac link) (link-ip link) (link-essid link)) '("a:b" "1.2" "net")))
        (check (link-encrypted-p link))
        (check (equal (list (link-frequency link) (link-quality link) (link-level link) (link-noise link))
                      '(2412 40 -48 -100)))
        (check (equal (list (wifi-state-max-level state) (wifi-state-max-noise state)) '(-48 -100)))
        (check (equal (list (wifi-state-throughput state) (wifi-state-bitrate state) (wifi-state-mode state)
                            (wifi-state-unit state) (wifi-state-max-quality state) (wifi-state-access-point state))
                      (list 1 2 playhouse.wifi:+mode-infra+ playhouse.wifi:+qual-dbm+ 70 "cc"))))
      (next-data radio)
      (check (= (link-level (first (links radio))) (- (ash 1 32) 48))))))
