;;;; An open device of any interface, base of the proxies for specific interfaces.

(in-package #:playhouse-client)

(defclass device ()
  ((client :initarg :client :reader client-of)
   (session :initarg :session :reader session-of)
   (interface :initarg :interface :reader device-interface :documentation "Its name in Player, a string.")
   (code :initarg :code :reader device-code)
   (index :initarg :index :reader device-index)
   (access :initarg :access :reader device-access)
   (driver :initform "" :accessor device-driver :documentation "Name of the driver behind the device.")
   (timestamp :initform 0d0 :accessor device-timestamp
              :documentation "The server's time (s) at the last data, 0 before the first.")
   (fresh :initform nil :accessor device-fresh-p
          :documentation "Whether data have arrived since the last next-data.")
   (latest :initform '() :accessor latest-of :documentation "Subtype, value and time of the newest data of each kind.")
   (callback :initform nil :accessor callback-of)
   (open :initform nil :accessor device-open-p :documentation "False after it or its client was closed.")
   (gone :initform nil :accessor gone-text :documentation "Why requests are refused."))
  (:documentation "Opened by open-device or robot-device; closed by close-device or at the end of with-device."))

(defgeneric next-update (device &key timeout)
  (:documentation "Waits for new data of the device and returns what they say: of position2d a state, of laser and
ranger a scan, and so on for each proxy; of opaque and speech-recognition the next message; of other devices their time
(s). Signals request-timeout after TIMEOUT seconds.")
  (:method (device &key timeout)
    (next-data device :timeout timeout)
    (device-timestamp device)))

(defgeneric prepare (device)
  (:documentation "Requests constant data for a proxy. Called after opening.")
  (:method (device) (declare (ignore device)) nil))

(defgeneric take (device message value timestamp)
  (:documentation "Receives data from read-data."))

(defgeneric lack-of (device message)
  (:documentation "Why there is no value of a data message.")
  (:method (device message)
    (if (device-has-data-p device)
        (format nil "sends ~{~a~^, ~}, not ~a"
                (loop for (subtype) in (reverse (latest-of device))
                      collect (message-type-name (find-message (device-code device) :data subtype)))
                (message-type-name message))
        "has sent no data yet; next-data waits for them")))

(defgeneric forget-data (device)
  (:documentation "Drops all data, as before the first: the run that they are of is over."))

(defgeneric close-device (device)
  (:documentation "Closes the device; a second call has no effect. A base that moves is stopped first."))

(defmethod print-object ((device device) stream)
  (print-unreadable-object (device stream :type t)
    (format stream "~a~:[, closed~;~]" (device-name device) (device-open-p device))))

(defmethod peer ((device device))
  (peer (session-of device)))

(defun device-name (device)
  "INTERFACE:INDEX, for instance position2d:0."
  (device-name-of (device-code device) (device-index device)))

(defun device-gone-p (device)
  "Whether read-data has received the notice that the server retired the device. From then on its use signals
device-gone, its last data remain, and closing it sends nothing. Before, the server refuses requests and drops
commands."
  (and (gone-text device) t))

(defun device-has-data-p (device)
  "Whether any data have arrived since this device was opened, and since the run was restarted."
  (and (latest-of device) t))

(defun request (device message &optional payload timeout)
  "Sends a request and waits for the answer, nil if it has no body. Signals request-refused or request-timeout."
  (insist-on-message device message payload)
  (insist-on-open device)
  (let* ((answer (request-answer (session-of device) (device-code device) (device-index device) message payload
                                 timeout))
         (body (message-body answer)))
    (and (message-type-payload message) (plusp (length body))
         (decode (message-type-payload message) body))))

(defun answer-of (device message &optional payload)
  "The answer to a request that cannot come without contents."
  (or (request device message payload)
      (fail 'wire-error "an answer came without its contents")))

(defun command (device message &optional payload)
  "Sends a command; commands have no answer."
  (insist-on-message device message payload)
  (insist-on-open device)
  (send-payload (session-of device) (device-code device) (device-index device) message payload)
  (values))

(defun latest (device message)
  "The newest value of a data message, nil before the first; and its time (s)."
  (insist-on-message device message)
  (let ((entry (assoc (message-type-subtype message) (latest-of device))))
    (values (second entry) (third entry))))

(defun newest (device message)
  "The newest value of a data message and its time (s). Signals no-data before the first."
  (multiple-value-bind (value timestamp) (latest device message)
    (unless value
      (fail 'no-data "~a: ~a ~a" (peer device) (device-name device) (lack-of device message)))
    (values value timestamp)))

(defun on-data (device function)
  "Sets a callback, called within read-data with message type, value and time (s) of all data of this device; nil:
none."
  (setf (callback-of device) function))

(defun next-data (device &key timeout)
  "Waits for data newer than those of the last call. Signals request-timeout after TIMEOUT seconds."
  (let* ((seconds (timeout-or-own (session-of device) timeout)) (deadline (deadline-after seconds)))
    (flet ((late ()
             (fail 'request-timeout "~a: no data of ~a in ~a s" (peer device) (device-name device)
                   (seconds-text seconds))))
      (loop until (device-fresh-p device)
            do (insist-on-open device)
               (handler-case (read-until (client-of device) deadline)
                 (request-timeout () (late)))
               (when (and (not (device-fresh-p device)) (passedp deadline)) ; it reads data of other devices only
                 (late)))
      (setf (device-fresh-p device) nil))))

(defmacro do-updates ((variable device &key timeout) &body body)
  "Reads until BODY leaves the block nil, as by RETURN: runs BODY with VARIABLE bound to each next-update of DEVICE."
  (let ((whose (gensym "DEVICE")) (seconds (gensym "TIMEOUT")))
    `(let ((,whose ,device) (,seconds ,timeout))
       (loop (let ((,variable (next-update ,whose :timeout ,seconds)))
               ,@body)))))

;;; Properties

(defparameter *property-kinds*
  `((:bool ,playhouse.common:+req-get-boolprop+ ,playhouse.common:+req-set-boolprop+
           playhouse.common:make-boolprop-req playhouse.common:boolprop-req-value
           ,(lambda (value) (if value 1 0)) ,(lambda (value) (/= value 0)))
    (:int ,playhouse.common:+req-get-intprop+ ,playhouse.common:+req-set-intprop+
          playhouse.common:make-intprop-req playhouse.common:intprop-req-value identity identity)
    (:float ,playhouse.common:+req-get-dblprop+ ,playhouse.common:+req-set-dblprop+
            playhouse.common:make-dblprop-req playhouse.common:dblprop-req-value identity identity)
    (:string ,playhouse.common:+req-get-strprop+ ,playhouse.common:+req-set-strprop+
             playhouse.common:make-strprop-req playhouse.common:strprop-req-value c-string text))
  "For each type of property: messages that get and set it, constructor and value of their payload, and conversions of a
value to the wire and back.")

(defun property-row (kind)
  (or (rest (assoc kind *property-kinds*))
      (fail 'invalid-value "a property is a :bool, an :int, a :float or a :string, not ~s" kind)))

(defun kind-of-property (value)
  (typecase value
    ((member t nil) :bool)
    (integer :int)
    (float :float)
    (string :string)
    (t (fail 'invalid-value "a property is a bool, an int, a float or a string, not ~s" value))))

(defun get-property (device key kind)
  "A property by its key and type: :bool, :int, :float or :string. Signals request-refused if there is none."
  (destructuring-bind (get set make value wrap unwrap) (property-row kind)
    (declare (ignore set wrap))
    (let ((answer (handler-case (request device get (funcall make :key (c-string key)))
                    (request-refused () nil))))
      (unless answer
        (fail 'request-refused "~a: ~a has no ~(~a~) property ~s" (peer device) (device-name device) kind key))
      (funcall unwrap (funcall value answer)))))

(defun why-refused (device)
  "Why the driver of a position2d or planner does not drive to the goal that it was given last, as its log says; empty if
it does, has arrived, has not planned yet, or gives no reasons."
  (handler-case (get-property device "refusal" :string)
    (request-refused () "")))

(defun set-property (device key value)
  "Sets a property to t or nil, an integer, a float or a string. Signals request-refused."
  (destructuring-bind (get set make accessor wrap unwrap) (property-row (kind-of-property value))
    (declare (ignore get accessor unwrap))
    (let ((body (funcall make :key (c-string key) :value (funcall wrap value))))
      (handler-case (request device set body)
        (request-refused ()
          (fail 'request-refused "~a: ~a refuses ~a as ~s" (peer device) (device-name device)
                (if (realp value) (number-text value) (prin1-to-string value)) key))))
    value))

(defun has-capability-p (device message)
  "Whether the driver reports that it supports a message. Many drivers never do."
  (handler-case
      (progn (request device playhouse.common:+req-capabilities+
                      (playhouse.common:make-capabilities-req :type (kind-number (message-type-kind message))
                                                              :subtype (message-type-subtype message)))
             t)
    (request-refused () nil)))

;;; Opening and closing; read-data

(defun access-number (access)
  "The letters are those of Player's first servers."
  (ecase access
    (:all playhouse.player:+open-mode+)
    (:read (char-code #\r))
    (:write (char-code #\w))
    (:close playhouse.player:+close-mode+)))

(defun set-access (device access)
  "Opens or closes the device; returns the name of its driver."
  (let ((body (playhouse.player:make-device-req
               :addr (playhouse.common:make-devaddr :interf (device-code device) :index (device-index device))
               :access (access-number access)))
        (verb (if (eq access :close) "close" "open")))
    (let ((granted (handler-case (request-of-server (session-of device) playhouse.player:+req-dev+ body
                                                    'playhouse.player:device-req)
                     (request-refused ()
                       (fail 'request-refused "~a: there is no ~a to ~a" (peer device) (device-name device) verb))
                     (request-timeout ()
                       (fail 'request-timeout "~a: no answer in time: ~a ~a" (peer device) verb
                             (device-name device))))))
      (when (= (playhouse.player:device-req-access granted) playhouse.player:+error-mode+)
        (fail 'request-refused "~a: cannot ~a ~a" (peer device) verb (device-name device)))
      (text (playhouse.player:device-req-driver-name granted)))))

(defun interface-code-of (interface)
  "The code of an interface by its name in Player. Signals invalid-value."
  (or (interface-code interface)
      (fail 'invalid-value "there is no interface ~s~a" interface (did-you-mean interface (interface-names)))))

(defmethod initialize-instance :after ((device device) &key)
  (setf (device-driver device) (set-access device (device-access device))
        (device-open-p device) t))

(defmethod take ((device device) message value timestamp)
  (let* ((subtype (message-type-subtype message)) (entry (assoc subtype (latest-of device))))
    (if entry
        (setf (rest entry) (list value timestamp))
        (push (list subtype value timestamp) (latest-of device))))
  (setf (device-timestamp device) timestamp
        (device-fresh-p device) t)
  (when (callback-of device)
    (funcall (callback-of device) message value timestamp)))

(defun goes-back-p (device message timestamp)
  "Whether data of this time are earlier than the last of their kind: the simulated time went back."
  (let ((entry (assoc (message-type-subtype message) (latest-of device))))
    (and entry (without-float-traps (< timestamp (third entry)))))) ; a server may send a NaN

(defmethod forget-data ((device device))
  (setf (latest-of device) '()
        (device-timestamp device) 0d0
        (device-fresh-p device) nil))

(defun retire (device port)
  "Marks the device as retired by the server, whose own port number is PORT."
  (unless (gone-text device)
    (setf (gone-text device) (format nil "~d:~a is gone: the server retired it" port (device-name device)))))

(defmethod close-device ((device device))
  (when (device-open-p device)
    (setf (device-open-p device) nil)
    (forget (client-of device) device)
    (when (and (reachablep device) (not (device-gone-p device)))
      (set-access device :close)))
  (values))

(defun reachablep (device)
  (alivep (connection-of (session-of device))))

(defun call-with-closing (thing close function)
  "Calls FUNCTION with THING and then CLOSE. Errors of closing do not replace an error that ends FUNCTION."
  (let ((done nil))
    (unwind-protect (multiple-value-prog1 (funcall function thing)
                      (setf done t))
      (if done
          (funcall close thing)
          (handler-case (funcall close thing)
            (player-error () nil))))))

(defmacro with-device ((variable client interface &optional (index 0) (access :all)) &body body)
  "Opens a device as open-device does, binds VARIABLE to it while BODY runs, and closes it, however BODY ends."
  `(call-with-closing (open-device ,client ,interface ,index ,access) #'close-device
                      (lambda (,variable) ,@body)))

;;; Checks of arguments

(defun insist-on-word (what word &rest words)
  "Checks that WORD is one of WORDS. WHAT is for instance \"a mode\"."
  (unless (member word words)
    (fail 'invalid-value "~a is ~{~s~#[~; or ~:;, ~]~}, not ~s" what words word)))

(defun insist-on-text (what text)
  (unless (stringp text)
    (fail 'invalid-value "~a is a string, not ~s" what text)))

(defun insist-on-message (device message &optional payload)
  "Messages of interface 0 are for every device."
  (unless (message-type-p message)
    (fail 'invalid-value "~a: a message is that of a constant such as playhouse.position2d:+cmd-vel+, not ~s"
          (device-name device) message))
  (unless (member (message-type-interface message) (list 0 (device-code device)))
    (fail 'invalid-value "~a: ~a is a message of another interface" (device-name device) (message-type-name message)))
  (let ((type (message-type-payload message)))
    (unless (or (null payload) (and type (typep payload type)))
      (fail 'invalid-value "~a: ~a takes ~:[nothing~;~:*a ~(~s~)~], not ~s" (device-name device)
            (message-type-name message) type payload))))

(defun insist-on-open (device)
  (unless (device-open-p device)
    (fail 'device-closed "~a: ~a is closed" (peer device) (device-name device)))
  (when (gone-text device)
    (fail 'device-gone "~a" (gone-text device))))

(defun insist-on-finite (device &rest names-and-values)
  (loop for (name value) on names-and-values by #'cddr
        unless (finitep value)
          do (fail 'invalid-value "~a: ~a is ~a, not a finite number" (device-name device) name (number-text value))))

(defun insist-on-whole (device name value least most)
  (unless (and (integerp value) (<= least value most))
    (fail 'invalid-value "~a: ~a is ~a, not a whole number from ~d to ~d" (device-name device) name
          (if (realp value) (number-text value) (prin1-to-string value)) least most)))

;;; Functions of the proxies

(defmacro define-operation (name (first &rest others) documentation &body body)
  "Defines a function of devices, or of scans, whose use with others signals invalid-value. With (VARIABLE CLASS) as
FIRST it is for that class alone, with this BODY; else methods define it for their classes."
  `(progn
     (defgeneric ,name (,(if (consp first) (first first) first)
                        ,@(mapcar (lambda (other) (if (consp other) (first other) other)) others))
       (:documentation ,documentation)
       (:generic-function-class operation))
     ,@(when (consp first)
         `((defmethod ,name (,first ,@others) ,@body)))))

(defmethod no-applicable-method ((function operation) &rest arguments)
  (let ((thing (first arguments)))
    (fail 'invalid-value "~(~a~) is a function of ~{~a~#[~; and ~:;, ~]~}, not of ~a" (operation-name function)
          (sort (mapcar #'string-downcase (operation-classes function)) #'string<)
          (if (typep thing 'device) (device-name thing) (prin1-to-string thing)))))
