;;;; What a client makes of servers that are slow, silent, busy, faulty or gone.

(in-package #:playhouse-client.tests)

(defun base-data (x)
  (playhouse.position2d:make-data :pos (playhouse.common:make-pose2d :px x)))

(defun put-state (peer x &rest options)
  (apply #'put-data peer playhouse.position2d:+data-state+ (base-data x) options))

(defun data-request-p (header)
  (and (= (header-interface header) 1)
       (= (header-subtype header) (message-type-subtype playhouse.player:+req-data+))))

(defparameter *silence* (rounds (peer header) (leave)) "A script that opens and closes devices, and no more.")

(defparameter *refusing* (rounds (peer header) (answer peer header :kind :nack)))

(defun geom-bytes ()
  (encode (playhouse.position2d:make-geom)))

;;; Connecting

(deftest nobody-there
  (let ((gone nil))
    (with-connection (client #'receive :mode :push)
      (declare (ignorable client))
      (setf gone address))
    (check-error connection-lost (format nil "~a: cannot connect: Connection refused" gone) (connect gone))))

(deftest a-server-of-another-kind
  (with-server (peer address (constantly nil) :banner (bytes-of "220 mail.example.org ESMTP ready now"))
    (check-error connection-lost "not a Player server (it says \"220 mail" (connect address))))

(deftest a-banner-in-pieces
  (with-server (peer address (lambda (peer)
                               (loop for byte across *banner* do (put peer (vector byte)))
                               (receive peer))
                     :banner #())
    (with-client (client address :mode :push)
      (check (string= (banner client) "Player v.3.1.1")))))

(deftest a-server-that-says-nothing
  (with-server (peer address #'receive :banner #())
    (check-error connection-lost "cannot connect: no banner in time" (connect address :timeout 0.02))))

(deftest addresses
  (check-error connection-lost "::1:1: cannot connect" (connect "[::1]:1"))
  (check-error connection-lost "\"[::1]:\" is not HOST or HOST:PORT" (connect "[::1]:"))
  (check-error connection-lost "\"localhost:port\" is not HOST or HOST:PORT" (connect "localhost:port"))
  (check-error connection-lost "is not HOST or HOST:PORT" (connect "localhost:65536"))
  (check-error connection-lost "127.0.0.1:1: cannot connect" (connect ":1"))
  (check-error connection-lost "cannot connect: port must be 0-65535" (connect-to "127.0.0.1" 70000))
  (dolist (host (list "a..b" (make-string 70 :initial-element #\x) (format nil "nul~c" (code-char 0)) "no such host"))
    (check-error connection-lost "cannot connect: Name or service not known" (connect host))))

;;; Reading

(deftest a-round-ends-with-synch-and-brings-everything
  (with-connection (client (rounds (peer header)
                             (answer peer header)
                             (put-state peer 1d0)
                             (put-state peer 2d0 :timestamp 7.5d0)
                             (put-synch peer)))
    (let ((robot (open-device client :position2d)))
      (check (= (read-data client) 2))
      (check (= (pose-x (pose robot)) 2d0))
      (check (= (device-timestamp robot) 7.5d0))
      (check (= (state-time (state robot)) 7.5d0)))))

(deftest messages-in-single-bytes-arrive-whole
  (with-connection (client (rounds (peer header)
                             (loop for byte across (concatenate 'octets
                                                                (message-bytes 1 0 :ack 4 #())
                                                                (data-bytes playhouse.position2d:+data-state+
                                                                            (base-data 3d0))
                                                                (synch-bytes))
                                   do (put peer (vector byte)))))
    (let ((robot (open-device client :position2d)))
      (check (= (read-data client) 1))
      (check (= (pose-x (pose robot)) 3d0)))))

(deftest messages-larger-than-the-buffer-arrive-whole
  (let ((large (make-array 300000 :element-type '(unsigned-byte 8) :initial-element 7)))
    (with-connection (client (rounds (peer header)
                               (answer peer header)
                               (dotimes (i 3)
                                 (put-data peer playhouse.opaque:+data-state+ (playhouse.opaque:make-data :data large)))
                               (put-synch peer)))
      (let ((stream (open-device client :opaque)))
        (check (= (read-data client) 3))
        (check (equalp (take-messages stream) (list large large large)))))))

(deftest a-round-that-ends-while-a-request-waits-is-the-next-read
  (let ((asked 0))
    (with-connection (client (rounds (peer header)
                               (cond ((data-request-p header) ; is acknowledged, and nothing comes
                                      (incf asked)
                                      (answer peer header))
                                     (t (put-state peer 4d0)
                                        (put-synch peer)
                                        (answer peer header :body (geom-bytes))))))
      (let ((robot (open-device client :position2d)))
        (check-error request-timeout "no data in time" (read-data client :timeout 0.02))
        (geometry robot)
        (check (= (read-data client) 1))
        (check (= asked 1))))))

(deftest no-data-in-time-is-an-error-and-the-round-goes-on
  (let ((asked 0))
    (with-connection (client (rounds (peer header)
                               (cond ((data-request-p header)
                                      (incf asked)
                                      (answer peer header))
                                     (t (answer peer header :body (geom-bytes))
                                        (put-state peer 4d0)
                                        (put-synch peer)))))
      (let ((robot (open-device client :position2d)))
        (check-error request-timeout "no data in time" (read-data client :timeout 0.02))
        (geometry robot)
        (check (= (read-data client) 1))
        (check (= (pose-x (pose robot)) 4d0))
        (check (= asked 1))))))

(deftest lost-messages-are-counted-and-not-an-error
  (with-connection (client (rounds (peer header)
                             (answer peer header)
                             (put-state peer 1d0)
                             (put-synch peer 41)))
    (open-device client :position2d)
    (read-data client)
    (check (= (overflow-count client) 41))))

(deftest data-that-come-before-an-answer-wait-for-read-data
  (with-connection (client (rounds (peer header)
                             (put-state peer 5d0)
                             (answer peer header :body (geom-bytes)))
                           :mode :push)
    (let ((robot (open-device client :position2d)))
      (geometry robot)
      (check-error no-data "has sent no data yet" (pose robot))
      (read-data client)
      (check (= (pose-x (pose robot)) 5d0)))))

(deftest more-data-than-wait-for-a-request-are-dropped-and-counted
  (with-connection (client (rounds (peer header)
                             (put peer (apply #'concatenate 'octets
                                              (loop for i below 1030
                                                    collect (data-bytes playhouse.position2d:+data-state+
                                                                        (base-data i)))))
                             (answer peer header :body (geom-bytes)))
                           :mode :push)
    (let ((robot (open-device client :position2d)))
      (geometry robot)
      (check (= (read-data client) 1024))
      (check (= (overflow-count client) 6)))))

(deftest before-the-first-data-there-is-no-value
  (with-connection (client *refusing* :mode :push)
    (let ((robot (open-device client :position2d)) (scanner (open-device client :laser))
          (ring (open-device client :sonar)) (finder (open-device client :fiducial))
          (ranger (open-device client :ranger)) (skirt (open-device client :bumper)))
      (loop for (look device) in `((state ,robot) (pose ,robot) (velocity ,robot) (stalled-p ,robot) (scan ,scanner)
                                   (ranges ,scanner) (intensities ,scanner) (ranges ,ring) (markers ,finder)
                                   (scan ,ranger) (ranges ,ranger) (intensities ,ranger) (pressed ,skirt))
            do (check-error no-data ":0 has sent no data yet; next-data waits for them" (funcall look device)))
      (check (null (latest robot playhouse.position2d:+data-state+)))
      (check (not (device-has-data-p robot))))))

(deftest a-server-that-refuses-data-is-an-error
  (with-connection (client *refusing*)
    (dotimes (i 2)
      (check-error request-refused "refuses to send data" (read-data client)))))

(deftest what-makes-no-sense-is-skipped-and-counted
  (with-connection (client (rounds (peer header)
                             (answer peer header)
                             (put-message peer 4 0 :data 99 #(1 2 3 4)) ; no such kind of data
                             (put-message peer 4 0 :data 1 #(1 2 3 4))  ; too short
                             (put-message peer 4 9 :data 1 (encode (base-data 1d0))) ; a device that is not open
                             (put-message peer 4 0 :nack 5 #())  ; nobody asked
                             (put-message peer 4 0 77 5 #())     ; no such kind of message
                             (put-state peer 6d0)
                             (put-synch peer)))
    (let ((robot (open-device client :position2d)))
      (check (= (read-data client) 1))
      (check (= (pose-x (pose robot)) 6d0))
      (check (= (skipped-count client) 5)))))

(deftest a-size-over-the-limit-ends-the-connection
  (with-connection (client (rounds (peer header)
                             (answer peer header)
                             (put peer (words 0 0 4 0 1 1 0 0 0 #x7fffffff))))
    (open-device client :position2d)
    (check-error connection-lost "a header announces 2147483647 bytes, over the limit" (read-data client))
    (check (not (connectedp client)))))

(deftest callbacks-may-ask-but-not-read
  (let ((faults '()))
    (with-connection (client (rounds (peer header)
                               (answer peer header :body (if (= (header-interface header) 1) #() (geom-bytes)))
                               (when (= (header-interface header) 1)
                                 (put-state peer 1d0)
                                 (put-synch peer))))
      (let ((robot (open-device client :position2d)))
        (on-data robot (lambda (message value timestamp)
                         (declare (ignore message value timestamp))
                         (geometry robot)
                         (handler-case (read-data client)
                           (player-error (problem) (push (princ-to-string problem) faults)))))
        (read-data client)))
    (check (= (length faults) 1))
    (check (search "from a callback" (first faults)))))

(deftest data-of-others-do-not-prolong-the-time-out-of-one
  (with-connection (client (rounds (peer header)
                             (answer peer header)
                             (put-data peer playhouse.laser:+data-scan+ (playhouse.laser:make-data))
                             (put-synch peer)))
    (let ((robot (open-device client :position2d)) (scanner (open-device client :laser)))
      (check-error request-timeout "no data of position2d:0 in 0.5 s" (next-data robot :timeout 0.5))
      (check (device-fresh-p scanner)))))

(deftest a-time-out-may-be-infinite
  (dolist (forever (list :forever +infinity+ 1d300))
    (with-connection (client (rounds (peer header)
                               (answer peer header)
                               (put-state peer 1d0)
                               (put-synch peer))
                             :timeout forever)
      (next-data (open-device client :position2d))
      (check (= (read-data client :timeout forever) 1)))))

;;; Requests

(deftest a-refusal-is-an-error-and-the-connection-stays
  (let ((kinds (list :nack :ack)))
    (with-connection (client (rounds (peer header) (answer peer header :kind (pop kinds) :body (geom-bytes))))
      (let ((robot (open-device client :position2d)))
        (check-error request-refused "position2d.req.get_geom of position2d:0 was refused" (geometry robot))
        (check (geometry robot))))))

(defun late-rounds (&optional sequence)
  "A function of a peer and a request that answers two requests after the second has come."
  (let ((held '()))
    (lambda (peer header)
      (setf held (append held (list header)))
      (when (= (length held) 2)
        (loop for request in held
              for number from 1
              do (answer peer request :body (encode (playhouse.common:make-intprop-req :key #(120 0) :value number))
                                      :sequence (or sequence (header-sequence request))))))))

(deftest a-late-answer-is-not-taken-for-anothers
  (dolist (sequence '(nil 0))             ; of a server that numbers, and of one that does not
    (with-connection (client (let ((answer-late (late-rounds sequence)))
                               (rounds (peer header) (funcall answer-late peer header))))
      (let ((device (open-device client :dio)))
        (check-error request-timeout "no answer to universal.req.get_intprop of dio:0 in 0.02 s"
          (request device playhouse.common:+req-get-intprop+ (playhouse.common:make-intprop-req :key #(120 0)) 0.02d0))
        (check (eql (get-property device "x" :int) 2))))))

(deftest an-interrupt-leaves-the-connection-usable
  (let ((main sb-thread:*current-thread*) (answer-late (late-rounds)) (count 0))
    (with-connection (client (rounds (peer header)
                               (when (= (incf count) 1)
                                 (sb-thread:interrupt-thread main (lambda () (throw 'left :interrupted))))
                               (funcall answer-late peer header)))
      (let ((device (open-device client :dio)))
        (check (eq (catch 'left (get-property device "x" :int)) :interrupted))
        (check (eql (get-property device "x" :int) 2))))))

(deftest an-answer-that-does-not-decode-names-the-fault
  (with-connection (client (rounds (peer header) (answer peer header :body #(1 2 3 4))))
    (check-error wire-error "position2d.Geom: byte 0: 8 bytes expected, 4 are left"
      (geometry (open-device client :position2d)))))

(deftest an-answer-without-contents-is-an-error
  (with-connection (client (rounds (peer header) (answer peer header)))
    (check-error wire-error "an answer came without its contents" (geometry (open-device client :position2d)))))

(deftest a-server-that-goes-is-noticed
  (with-connection (client *silence*)
    (let ((robot (open-device client :position2d)))
      (check-error connection-lost "the server" (geometry robot))
      (check (not (connectedp client)))
      (check-error connection-lost "the server" (drive robot 1)))))

(deftest errors-name-the-device-and-what-was-asked-of-it
  (with-connection (client *refusing* :mode :push)
    (check-error request-refused "position2d.req.get_geom of position2d:3 was refused"
      (geometry (open-device client :position2d 3)))
    (let ((lights (open-device client :dio)))
      (check-error request-refused "dio:0 has no int property \"lamp\"" (get-property lights "lamp" :int))
      (check-error request-refused "dio:0 refuses 7 as \"lamp\"" (set-property lights "lamp" 7))
      (check (not (has-capability-p lights playhouse.common:+req-capabilities+))))
    (check-error request-refused "simulation.req.get_pose2d of model \"nosuch\" was refused"
      (model-pose (open-device client :simulation) "nosuch"))))

(deftest properties-have-four-types
  (with-connection (client (rounds (peer header body)
                             (answer peer header :body body)))
    (let ((device (open-device client :dio)))
      (check (eql (get-property device "x" :int) 0))
      (check (eql (get-property device "x" :bool) nil))
      (check (eql (get-property device "x" :float) 0d0))
      (check (equal (get-property device "x" :string) ""))
      (loop for value in '(t nil 5 0.5d0 "text") do (set-property device "x" value))
      (check (equalp (mapcar (lambda (message) (header-subtype (car message)))
                             (remove 1 (received-of peer) :key (lambda (message) (header-interface (car message)))))
                     (mapcar #'message-type-subtype
                             (list playhouse.common:+req-get-intprop+ playhouse.common:+req-get-boolprop+
                                   playhouse.common:+req-get-dblprop+ playhouse.common:+req-get-strprop+
                                   playhouse.common:+req-set-boolprop+ playhouse.common:+req-set-boolprop+
                                   playhouse.common:+req-set-intprop+ playhouse.common:+req-set-dblprop+
                                   playhouse.common:+req-set-strprop+)))))))

(deftest lost-data-are-the-servers-count-and-those-not-read-here
  (with-connection (client (rounds (peer header)
                             (answer peer header
                                     :body (encode (playhouse.common:make-intprop-req :key #(120 0) :value 41))))
                           :mode :push)
    (check (= (lost-count client) 41))))

(deftest values-that-mean-nothing-are-not-sent
  (with-server (peer address (rounds (peer header) (error "this was sent: ~a" header)))
    (with-client (client address :mode :push)
      (let ((robot (open-device client :position2d)) (simulator (open-device client :simulation))
            (finder (open-device client :fiducial)) (minus (- +infinity+)))
        (macrolet ((not-finite (text form) `(check-error invalid-value ,text ,form)))
          (not-finite "position2d:0: vx is nan, not a finite number" (drive robot *nan*))
          (not-finite "va is inf, not a finite number" (drive robot 0 :va +infinity+))
          (not-finite "vy is -inf, not a finite number" (drive robot 0 :vy minus))
          (not-finite "vx is 1000000" (drive robot (expt 10 400)))
          (not-finite "steering is nan" (drive-car robot 0.1 *nan*))
          (not-finite "x is nan" (go-to robot (make-pose :x *nan*)))
          (not-finite "speed is nan" (go-to robot (make-pose) :speed *nan*))
          (not-finite "a is nan" (set-odometry robot (make-pose :a *nan*)))
          (not-finite "simulation:0: y is nan" (set-model-pose simulator "r0" (make-pose :y *nan*)))
          (not-finite "yaw is nan" (set-model-pose3d simulator "r0" (make-pose3d :yaw *nan*)))
          (not-finite "max_range is inf" (set-field-of-view finder 0 +infinity+ 1)))
        (loop for (ticks text) in `((0 "0") (-1 "-1") (1.5d0 "1.5") (,(1+ (ash 1 20)) "1048577") ("1" "\"1\"")
                                   (nil "NIL"))
              do (check-error invalid-value
                     (format nil "simulation:0: ticks is ~a, not a whole number from 1 to 1048576" text)
                   (step-world simulator ticks)))
        (dolist (seed (list -1 1.5d0 (ash 1 64) "1"))
          (check-error invalid-value "not a whole number from 0 to" (reset-world simulator seed)))
        (dolist (index '(-1 65536))
          (check-error invalid-value (format nil "there is no position2d:~d: indices are 0 to 65535" index)
            (open-device client :position2d index)))
        (dolist (timeout (list -1 *nan* "5"))
          (check-error invalid-value "invalid time-out of" (read-data client :timeout timeout)))
        (macrolet ((refused-each (&rest texts-and-forms)
                     `(progn ,@(loop for (text form) on texts-and-forms by #'cddr
                                     collect `(check-error invalid-value ,text ,form)))))
          (refused-each
           "a mode is :PUSH or :PULL, not :FOO" (set-mode client :foo)
           "a mode is :PUSH or :PULL, not :FOO" (connect address :mode :foo)
           "a mode is :PUSH or :PULL, not NIL" (connect-to "127.0.0.1" 1 :mode nil)
           "a rule is :ACCEPT, :REPLACE or :IGNORE, not :FOO" (set-replace-rule client :foo)
           "an access is :ALL, :READ or :WRITE, not :REED" (open-device client :laser 0 :reed)
           "an interface is a keyword or a string, such as :position2d, not 4" (open-device client 4)
           "such as :position2d, not NIL" (open-device client nil)
           "an address is a string, not 6665" (connect 6665)
           "a host is a string, not :HOST" (connect-to :host 6665)
           "a port is a whole number, not \"6665\"" (connect-to "127.0.0.1" "6665")
           "a name is a string, not :R0" (find-robot client :r0)
           "position2d:0: position2d.cmd.vel takes a playhouse.position2d:cmd-vel, not 3"
           (command robot playhouse.position2d:+cmd-vel+ 3)
           "takes nothing, not 3" (request robot playhouse.position2d:+req-reset-odom+ 3)
           "position2d:0: gripper.cmd.close is a message of another interface"
           (command robot playhouse.gripper:+cmd-close+)
           "position2d:0: a message is that of a constant such as" (request robot 3)
           "a message is that of a constant such as" (latest robot nil)
           "position2d:0: 3 is not a pose" (go-to robot 3)
           "opaque:0: a message is a sequence of bytes, not 3" (send (open-device client :opaque) 3)
           "a message is a sequence of bytes, not \"hi\"" (send-to (open-device client :opaque) "a" "hi")
           "imu:0: a message is that of a constant" (send (open-device client :imu) 3)
           "a text is a string, not :R0" (model-pose simulator :r0)
           "a name is a string, not :R0" (spawn simulator "r0" (make-pose) :r0)
           "position2d:0: vx is FAST, not a finite number" (drive robot 'fast)))
        (check-error invalid-value "a property is a bool" (set-property robot "key" '(1)))
        (check-error invalid-value "a property is a :bool" (get-property robot "key" :list))
        (check-error wire-error "has a NUL in it" (model-pose simulator (format nil "r0~c" (code-char 0))))
        (check-error wire-error "cannot be sent as UTF-8" (model-pose simulator (string (code-char #xdcff))))))))

(deftest a-closed-device-says-so
  (with-server (peer address (rounds (peer header) (error "this was sent: ~a" header)))
    (let (client robot other)
      (with-client (opened address)
        (setf client opened
              robot (open-device client :position2d 0)
              other (open-device client :position2d 1))
        (close-device robot)
        (close-device robot))
      (dolist (closed (list robot other))
        (check (not (device-open-p closed)))
        (dolist (act (list (lambda () (drive closed 0.1)) (lambda () (geometry closed)) (lambda () (next-data closed))))
          (check-error device-closed (format nil "~a is closed" (device-name closed)) (funcall act))))
      (check-error connection-lost "the connection is closed" (read-data client))
      (check-error connection-lost "the connection is closed" (open-device client :position2d)))))

(deftest a-device-that-is-not-there-cannot-be-opened
  (with-connection (client (lambda (peer)
                             (loop for header = (receive peer)
                                   while header
                                   do (answer peer header :kind (if (= (header-subtype header) 3) :nack :ack)))))
    (check-error request-refused "there is no position2d:3 to open" (open-device client :position2d 3))
    (check-error invalid-value "there is no interface \"lazer\" (did you mean \"laser\"?)" (open-device client "lazer"))
    (check-error invalid-value "there is no interface \"xyzzy\"" (open-device client :xyzzy))))

(deftest a-driver-that-refuses-to-start-is-an-error
  (with-connection (client (lambda (peer)
                             (loop for header = (receive peer)
                                   while header
                                   do (answer peer header
                                              :body (if (= (header-subtype header) 3)
                                                        (encode (playhouse.player:make-device-req
                                                                 :access playhouse.player:+error-mode+))
                                                        #())))))
    (check-error request-refused "cannot open position2d:0" (open-device client :position2d))))

;;; The end: a server that ends has often just said the last things; they are delivered before the error.

(defun check-end (mode wanted end &optional (losses 0))
  "END says the last things to a peer with a header."
  (with-connection (client (rounds (peer header)
                             (funcall end peer header)
                             (finish peer))
                           :mode mode)
    (let ((robot (open-device client :position2d)) (seen '()) (counted 0))
      (on-data robot (lambda (message value timestamp)
                       (declare (ignore message timestamp))
                       (push (playhouse.common:pose2d-px (playhouse.position2d:data-pos value)) seen)))
      (when (eq mode :push)
        (drive robot 0.1))                ; anything, for the script to go on
      (check-error run-ended "the run ended: the server closed the connection"
        (loop (incf counted (read-data client))))
      (check (equalp (reverse seen) wanted))
      (check (= counted (length wanted)))
      (check-error run-ended "the server closed the connection" (read-data client))
      (check (not (connectedp client)))
      (check (= (overflow-count client) losses)))))

(deftest a-round-that-is-never-closed-is-delivered
  (check-end :pull '(1d0 2d0) (lambda (peer header)
                                (answer peer header)
                                (put-state peer 1d0)
                                (put-state peer 2d0))))

(deftest data-instead-of-an-answer-are-delivered-and-their-losses-counted
  (let ((wanted (loop for i below 3000 collect (coerce i 'double-float)))) ; more than wait for an ordinary request
    (check-end :pull wanted
               (lambda (peer header)
                 (declare (ignore header))
                 (dolist (x wanted) (put-state peer x))
                 (put-synch peer 551))
               551)))

(deftest pushed-data-are-delivered
  (check-end :push '(1d0 2d0) (lambda (peer header)
                                (declare (ignore header))
                                (put-state peer 1d0)
                                (put-state peer 2d0))))

(deftest data-that-came-before-a-command-failed-can-still-be-read
  (with-connection (client (rounds (peer header)
                             (put-state peer 1d0)
                             (leave))
                           :mode :push)
    (let ((robot (open-device client :position2d)))
      (check-error connection-lost "the server is gone" (loop (drive robot 0.1)))
      (read-data client)
      (check (= (pose-x (pose robot)) 1d0))
      (check-error connection-lost "the server is gone" (read-data client)))))

(deftest updates-end-with-the-last-data
  (with-connection (client (rounds (peer header)
                             (answer peer header)
                             (put-state peer 1d0)
                             (finish peer)))
    (let ((seen '()))
      (check-error connection-lost "the server closed the connection"
        (do-updates (state (open-device client :position2d))
          (push (pose-x (state-pose state)) seen)))
      (check (equal seen '(1d0))))))

;;; Ending

(defun driven (peer)
  "Forward speeds of the commands."
  (loop for (header . body) in (received-of peer)
        when (eq (header-kind header) :cmd)
          collect (playhouse.common:pose2d-px (playhouse.position2d:cmd-vel-vel
                                               (decode 'playhouse.position2d:cmd-vel body)))))

(defparameter *listening* (rounds (peer header) nil) "A script that answers nothing but modes, opening and closing.")

(defun last-access (peer)
  (playhouse.player:device-req-access (decode 'playhouse.player:device-req (cdr (first (last (received-of peer)))))))

(deftest a-moving-robot-is-stopped-before-its-device-is-closed
  (with-server (peer address *listening*)
    (with-client (client address)
      (drive (open-device client :position2d) 0.5 :va 0.1))
    (check (equalp (driven peer) '(0.5d0 0d0)))
    (check (= (last-access peer) playhouse.player:+close-mode+))))

(deftest an-error-stops-the-robot-and-is-the-one-that-leaves
  (with-server (peer address *listening*)
    (check-error error "something else"
      (with-client (client address)
        (with-device (robot client :position2d)
          (drive robot 0.5)
          (error "something else"))))
    (check (equalp (driven peer) '(0.5d0 0d0)))
    (check (= (last-access peer) playhouse.player:+close-mode+))))

(deftest a-robot-that-stands-gets-no-further-command
  (with-server (peer address *listening*)
    (with-client (client address)
      (with-device (robot client :position2d)
        (drive robot 0.5)
        (stop robot)))
    (check (equalp (driven peer) '(0.5d0 0d0)))))

(deftest reading-access-is-asked-for-by-its-character
  (with-server (peer address *listening*)
    (with-client (client address)
      (open-device client :position2d 0 :read)
      (check (= (last-access peer) (char-code #\r))))))

(deftest devices-are-closed-in-reverse-order-of-opening
  (with-server (peer address *listening*)
    (with-client (client address)
      (dolist (interface '(:position2d :laser :sonar))
        (open-device client interface)))
    (check (equalp (loop for (header . body) in (last (received-of peer) 3)
                         collect (playhouse.common:devaddr-interf
                                  (playhouse.player:device-req-addr (decode 'playhouse.player:device-req body))))
                   '(5 6 4)))))
