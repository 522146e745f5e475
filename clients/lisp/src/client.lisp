;;;; A connection to a Player server, and requests to the server itself.

(in-package #:playhouse-client)

(defparameter *default-host* "127.0.0.1" "Not localhost: a machine without /etc/hosts cannot resolve it.")
(defconstant +default-port+ 6665)
(defconstant +closing-seconds+ 1)
(defconstant +token-bytes+ 32)

(defgeneric mode (client)
  (:documentation "How data are delivered: :push or :pull. The initial mode of a server is :push."))

(defclass client ()
  ((session :accessor session-of)
   (mode :initform :push :reader mode :writer note-mode)
   (devices :initform (make-hash-table) :reader open-devices :documentation "By address: the oldest first.")
   (places :initform '() :accessor places-of :documentation "The addresses of open devices, the newest first.")
   (families :initform '() :accessor families-of :documentation "As of the last query.")
   (robots :initform (make-hash-table :test #'equal) :reader robots-of :documentation "By name and devices.")
   (reading :initform nil :accessor readingp))
  (:documentation "One connection, for one thread, made by connect."))

(defstruct device-entry
  "One entry of the server's device list. `interface' is a name, or a number if it has no known name; `model' is the
full name of the model behind the device and `robot' that of its top-level model, both empty if the server does not
report them."
  interface index driver (model "") (robot ""))

(defun device-entry-name (entry)
  "INTERFACE:INDEX, for instance position2d:0."
  (format nil "~a:~d" (device-entry-interface entry) (device-entry-index entry)))

;;; Connecting and closing

(defun connect (address &key (mode :pull) (timeout 5) (token ""))
  "Connects to \"host\", \"host:port\", \":port\" or \"[::1]:port\"; the defaults are 127.0.0.1 and 6665. MODE is :pull
or :push. TIMEOUT (s) applies to connecting, to every request, and to every read-data without a timeout of its own.
TOKEN is a guest's, for a run with --guests. Signals connection-lost, invalid-value, and request-refused for a wrong
token."
  (insist-on-text "an address" address)
  (multiple-value-bind (host port) (split-address address)
    (unless (and (digits-p port) (< 0 (parse-integer port) 65536))
      (fail 'connection-lost "~s is not HOST or HOST:PORT" address))
    (connect-to (if (string= host "") *default-host* host) (parse-integer port) :mode mode :timeout timeout
                :token token)))

(defun connect-to (host port &key (mode :pull) (timeout 5) (token ""))
  "As connect, with the host and the port apart."
  (insist-on-word "a mode" mode :push :pull)
  (insist-on-text "a host" host)
  (insist-on-text "a token" token)
  (unless (integerp port)
    (fail 'invalid-value "a port is a whole number, not ~s" port))
  (let ((client (make-instance 'client)) (done nil))
    (setf (session-of client)
          (make-instance 'session :connection (make-connection host port timeout) :timeout timeout
                                  :retire (lambda (interface index port)
                                            (dolist (device (devices-at client interface index))
                                              (retire device port)))))
    (unwind-protect (progn (unless (string= token "") (authenticate client token))
                           (when (eq mode :pull) (set-mode client mode))
                           (setf done t)
                           client)
      (unless done (close-client client)))))

(defun authenticate (client token)
  (let ((key (utf-8-octets token)))
    (unless (and key (<= (length key) +token-bytes+))
      (fail 'invalid-value "a token has ~d letters at most, not ~s" +token-bytes+ token))
    (handler-case (request-answer (session-of client) playhouse.player:+code+ 0 playhouse.player:+req-auth+
                                  (playhouse.player:make-device-auth-req :auth-key key))
      (request-refused ()
        (fail 'request-refused "~a: the token is refused; a run without --guests needs none" (peer client))))))

(defun split-address (address)
  "Host and port of an address; an IPv6 host is in brackets."
  (let ((colon (position #\: address :from-end t)) (bracket (position #\] address)))
    (cond ((and (plusp (length address)) (char= (char address 0) #\[) bracket)
           (let ((rest (subseq address (1+ bracket))))
             (values (subseq address 1 bracket)
                     (if (string= rest "") (princ-to-string +default-port+) (subseq rest 1)))))
          (colon (values (subseq address 0 colon) (subseq address (1+ colon))))
          (t (values address (princ-to-string +default-port+))))))

(defun close-client (client)
  "Closes all devices in reverse order of opening, and waits until the server has read everything."
  (dolist (device (loop for place in (places-of client) append (reverse (gethash place (open-devices client)))))
    (handler-case (close-device device)
      (player-error () nil)))             ; closing the connection closes it as well
  (close-connection (connection-of (session-of client)) +closing-seconds+)
  (values))

(defmacro with-client ((variable &rest arguments) &body body)
  "Connects as connect does with ARGUMENTS, binds VARIABLE to the client while BODY runs, and closes it, however BODY
ends."
  `(call-with-closing (connect ,@arguments) #'close-client (lambda (,variable) ,@body)))

;;; What the connection says

(defmethod peer ((client client))
  (peer (session-of client)))

(defun banner (client)
  "The server's greeting, for instance \"Player v.3.1\"."
  (banner-of (connection-of (session-of client))))

(defun connectedp (client)
  "Whether the connection can be used."
  (and (alivep (connection-of (session-of client))) t))

(defmethod overflow-count ((client client))
  (overflow-count (session-of client)))

(defmethod skipped-count ((client client))
  (skipped-count (session-of client)))

(defun lost-count (client)
  "Queries the number of data messages lost on the way to this client, in any mode: the server's count plus those not
read here in time. Signals request-refused if the server does not report it."
  (let ((question (playhouse.common:make-intprop-req :key (c-string "lost"))))
    (+ (playhouse.common:intprop-req-value
        (request-of-server (session-of client) playhouse.common:+req-get-intprop+ question
                           'playhouse.common:intprop-req))
       (unread-count (session-of client)))))

(defun set-mode (client mode)
  "Delivery of data: immediately (:push), or in rounds requested by the client (:pull)."
  (insist-on-word "a mode" mode :push :pull)
  (let ((number (ecase mode
                  (:push playhouse.player:+datamode-push+)
                  (:pull playhouse.player:+datamode-pull+))))
    (request-answer (session-of client) playhouse.player:+code+ 0 playhouse.player:+req-datamode+
                    (playhouse.player:make-device-datamode-req :mode number))
    (note-mode mode client)
    mode))

(defun set-replace-rule (client rule &key (interface -1) (index -1) (kind -1) (subtype -1))
  "Sets the server's rule for messages queued for this client: :accept, :replace or :ignore a message while an older one
of the same type is queued. Codes are those of headers; -1 matches any."
  (insist-on-word "a rule" rule :accept :replace :ignore)
  (let ((number (ecase rule
                  (:accept playhouse.player:+msg-replace-rule-accept+)
                  (:replace playhouse.player:+msg-replace-rule-replace+)
                  (:ignore playhouse.player:+msg-replace-rule-ignore+))))
    (request-answer (session-of client) playhouse.player:+code+ 0 playhouse.player:+req-add-replace-rule+
                    (playhouse.player:make-add-replace-rule-req :interf interface :index index :type kind
                                                                :subtype subtype :replace number))
    rule))

;;; Opening devices

(defun interface-word (interface)
  "The name of an interface in Player: :speech-recognition is \"speech_recognition\". Signals invalid-value."
  (unless (and interface (typep interface '(or string symbol)))
    (fail 'invalid-value "an interface is a keyword or a string, such as :position2d, not ~s" interface))
  (substitute #\_ #\- (string-downcase (string interface))))

(defun open-device (client interface &optional (index 0) (access :all))
  "Opens a device of any interface, such as :laser or \"laser\", as the proxy of that interface if there is one. ACCESS
is :all, :read or :write; the server drops commands over a device opened for reading. Signals request-refused,
invalid-value."
  (insist-on-word "an access" access :all :read :write)
  (let* ((name (interface-word interface)) (code (interface-code-of name)))
    (unless (typep index '(integer 0 65535))
      (fail 'invalid-value "there is no ~a:~a: indices are 0 to 65535" name index))
    (let ((device (make-instance (or (cdr (assoc name *proxies* :test #'string=)) 'device)
                                 :client client :session (session-of client) :interface name :code code :index index
                                 :access access)))
      (when (some #'device-gone-p (devices-at client code index))
        (drop-waiting (session-of client) code index))
      (remember client device)
      (handler-case (prepare device)
        (request-refused () nil)          ; works without the results
        (player-error (problem)
          (close-device device)
          (error problem)))
      device)))

(defun place-of (code index)
  (logior (ash code 16) index))

(defun devices-at (client code index)
  "The open devices with this address, the oldest first."
  (values (gethash (place-of code index) (open-devices client))))

(defun remember (client device)
  "Adds an opened device to the list."
  (let ((place (place-of (device-code device) (device-index device))))
    (pushnew place (places-of client))
    (setf (gethash place (open-devices client)) (append (gethash place (open-devices client)) (list device)))))

(defun forget (client device)
  "Removes a closed device from the list."
  (let* ((place (place-of (device-code device) (device-index device)))
         (others (remove device (gethash place (open-devices client)))))
    (setf (gethash place (open-devices client)) others)
    (unless others
      (remhash place (open-devices client))
      (setf (places-of client) (remove place (places-of client)))
      (when (device-gone-p device)
        (drop-waiting (session-of client) (device-code device) (device-index device))))))

;;; Reading

(defun read-data (client &key timeout)
  "Waits for data and delivers them to the devices; returns the number of messages. In pull mode this is one round:
everything the server has queued for this client. In push mode it is what has arrived, at least one message, or none if
a device was retired before (device-gone-p). Signals request-timeout without data; the next read-data continues to wait.
If the server disconnects, data it had sent are delivered first; the next read-data signals connection-lost."
  (read-until client (deadline-after (timeout-or-own (session-of client) timeout))))

(defun read-until (client deadline)
  (when (readingp client)
    (fail 'player-error "read-data was called from a callback that read-data itself is running"))
  (let ((session (session-of client)))
    (setf (readingp client) t
          (told-p session) nil)
    (unwind-protect
         (if (eq (mode client) :pull)
             (read-round client deadline)
             (receive client deadline (lambda (delivered)
                                        (or (zerop delivered) (buffered-message-p (connection-of session))))))
      (setf (readingp client) nil))))

(defun read-round (client deadline)
  (let ((session (session-of client)))
    (begin-round session)
    (let ((delivered (receive client deadline (lambda (delivered)
                                                (declare (ignore delivered))
                                                (round-open-p session)))))
      (when (and (round-refused-p session) (zerop delivered))
        (fail 'request-refused "~a: the server refuses to send data" (peer client)))
      delivered)))

(defun receive (client deadline more)
  "Delivers queued messages, and new ones while MORE holds for the count so far; returns the number of messages. A
disconnection after data is left to the next call, so that the data are delivered first."
  (let* ((session (session-of client)) (delivered (deliver client)))
    (loop while (and (funcall more delivered) (not (and (told-p session) (zerop delivered))))
          do (handler-case (sort-next session deadline)
               (request-timeout ()
                 (when (plusp delivered) (return))
                 (fail 'request-timeout "~a: no data in time" (peer client)))
               (connection-lost (problem)
                 (when (plusp delivered) (return))
                 (error problem)))
             (incf delivered (deliver client)))
    delivered))

(defun deliver (client)
  "Gives queued data to their devices; returns the number of messages."
  (let ((waiting (waiting (session-of client))))
    (loop until (queue-empty-p waiting)
          count (deliver-message client (dequeue waiting)))))

(defun deliver-message (client message)
  "Whether a device took the message."
  (let* ((header (message-header message))
         (row (find-message (header-interface header) :data (header-subtype header)))
         (takers (devices-at client (header-interface header) (header-index header)))
         (time (header-timestamp header))
         (value (and row takers (message-type-payload row)
                     (handler-case (decode (message-type-payload row) (message-body message))
                       (wire-error () nil)))))
    (cond (value
           ;; Another client restarted or rewound the run.
           (when (some (lambda (device) (goes-back-p device row time)) takers)
             (forget-later client time))
           ;; The last data of a retired device belong to it, unless a new device has its address.
           (dolist (device (or (remove-if #'device-gone-p takers) takers) t)
             (take device row value time)))
          (t (incf (skipped-count (session-of client)))
             nil))))

(defun forget-later (client time)
  "Drops the data of devices whose last are later than this time (s): of a run that is over when time goes back."
  (forget-data-if client (lambda (device) (without-float-traps (> (device-timestamp device) time)))))

(defun forget-run (client)
  "Drops all data received so far: the run that they are of is over."
  (take-all (waiting (session-of client)))
  (forget-data-if client #'identity))

(defun forget-data-if (client test)
  (loop for devices being the hash-values of (open-devices client)
        do (mapc #'forget-data (remove-if-not test devices))))

(defun deliver-pushed (client)
  "In push mode, delivers data that have arrived to the devices, without waiting for more."
  (when (and (eq (mode client) :push) (not (readingp client)))
    (setf (readingp client) t)
    (unwind-protect (deliver client)
      (setf (readingp client) nil))))

;;; Lists of devices, models and robots

(defun list-devices (client)
  "The devices of the server, in its own order, with the driver and the model behind each: a list of device-entry."
  (let* ((listed (coerce (playhouse.player:device-devlist-devices
                          (request-of-server (session-of client) playhouse.player:+req-devlist+ nil
                                             'playhouse.player:device-devlist))
                         'list))
         (owners (if (find playhouse.simulation:+code+ listed :key #'playhouse.common:devaddr-interf)
                     (find-owners client)
                     (make-hash-table))))
    (loop for address in listed collect (describe-device client address owners))))

(defun describe-device (client address owners)
  (let* ((code (playhouse.common:devaddr-interf address)) (index (playhouse.common:devaddr-index address))
         (interface (or (interface-name code) (princ-to-string code))))
    (destructuring-bind (model robot)
        (gethash (list (playhouse.common:devaddr-robot address) interface index) owners '("" ""))
      (make-device-entry :interface interface :index index :driver (driver-of client code index)
                         :model model :robot robot))))

(defun driver-of (client code index)
  (let ((question (playhouse.player:make-device-driverinfo
                   :addr (playhouse.common:make-devaddr :interf code :index index))))
    (handler-case (text (playhouse.player:device-driverinfo-driver-name
                         (request-of-server (session-of client) playhouse.player:+req-driverinfo+ question
                                            'playhouse.player:device-driverinfo)))
      ((or request-refused wire-error) () ""))))

(defun find-owners (client)
  "By port, interface and index of each device: its model and the top-level model of that. Empty if the server does not
report models."
  (let ((owners (make-hash-table :test #'equal)))
    (dolist (family (handler-case (list-families client) (request-refused () '())) owners)
      (when (top-level-p family)
        (dolist (at (devices-of family))
          (setf (gethash (list (device-address-port at) (device-address-interface at) (device-address-index at)) owners)
                (list (device-address-model at) (model-name (first family)))))))))

(defun top-level-p (family)
  (string= (model-parent (first family)) ""))

(defun list-models (client)
  "All models in the simulated world now, with their devices, parents before children. Signals request-refused if the
server does not report models (not every simulator does, and no real robot)."
  (mapcar #'first (list-families client)))

(defun find-robot (client name)
  "The robot, or any other model, of this name, with the devices of all its descendants. It is looked up in the last
list of models, and if it is not there, in a new list. The same name gives the same robot while its devices are the
same; of several models with one name it is the last. Signals request-refused if there is none, and as list-models."
  (insist-on-text "a name" name)
  (flet ((named (families)
           (find name families :key (lambda (family) (model-name (first family))) :test #'string= :from-end t)))
    (let ((family (or (named (families-of client)) (named (list-families client)))))
      (unless family
        (fail 'request-refused "there is no robot ~s at ~a~a" name (peer client)
              (did-you-mean name (mapcar (lambda (each) (model-name (first each))) (families-of client)))))
      (robot-of client family))))

(defun list-robots (client)
  "The top-level models with devices on this connection, of their own or of descendants, in the order of the world file.
Signals request-refused as list-models."
  (let ((robots (loop for family in (list-families client)
                      when (top-level-p family) collect (robot-of client family)))
        (port (server-port (session-of client))))
    (remove-if-not (lambda (robot) (find port (robot-devices robot) :key #'device-address-port)) robots)))

(defun list-families (client)
  "All current models, each with its descendants."
  (setf (families-of client)
        (handler-case (with-device (simulator client :simulation) (families (ask-models simulator)))
          (request-refused ()
            (fail 'request-refused "~a: this server does not tell the names of models; open devices by number"
                  (peer client))))))

(defun robot-of (client family)
  (let ((key (cons (model-name (first family)) (mapcar #'address-key (devices-of family)))))
    (or (gethash key (robots-of client))
        (setf (gethash key (robots-of client))
              (make-instance 'robot :client client :models family :port (server-port (session-of client)))))))
