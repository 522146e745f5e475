;;;; One session with a server: matches answers to requests, queues data, and tracks rounds of data.

(in-package #:playhouse-client)

(defconstant +waiting-limit+ 1024
  "Limit on data queued for the next read-data while a request waits for its answer: the queue length of a server per
client. The oldest are dropped and counted.")

(defconstant +retired+ (char-code #\e)
  "Access in an unrequested answer to an open request: the device was retired. (Failed open requests have
+error-mode+.)")

(defgeneric overflow-count (client)
  (:documentation "Data messages dropped because they were not read in time, here or in the server."))

(defgeneric skipped-count (client)
  (:documentation "Messages without a recipient, and invalid messages."))

(defclass session ()
  ((connection :initarg :connection :reader connection-of)
   (timeout :initarg :timeout :reader timeout-of)
   (retire :initarg :retire :reader retire-function
           :documentation "Called with interface, index and port of a device that the server has retired.")
   (waiting :initform (make-queue) :reader waiting)
   (round-open :initform nil :accessor round-open-p)
   (round-refused :initform nil :accessor round-refused-p)
   (round-waits :initform nil :accessor round-waits-p :documentation "It ended during a request: its data are queued.")
   (told :initform nil :accessor told-p :documentation "A device was retired.")
   (overflow-count :initform 0 :accessor overflow-count)
   (unread-count :initform 0 :accessor unread-count :documentation "Those of them lost here.")
   (skipped-count :initform 0 :accessor skipped-count)
   (server-port :initform 0 :accessor answering-port)
   (abandoned :initform '() :accessor abandoned)
   (sequence :initform 0 :accessor sequence-of))
  (:documentation "Dispatches received messages: answers to the pending request, data to the queue; others are
skipped."))

(defmethod peer ((session session))
  (peer (connection-of session)))

(defun device-name-of (interface index)
  "For instance position2d:0; with a number if the interface has no known name."
  (format nil "~a:~d" (or (interface-name interface) interface) index))

(defun timeout-or-own (session timeout)
  "The timeout (s) of the caller, or the session's own."
  (if timeout (checked-seconds timeout) (timeout-of session)))

(defun server-port (session)
  "The server's port as reported in its answers; the connected port may be that of a forwarder."
  (if (zerop (answering-port session)) (connected-port (connection-of session)) (answering-port session)))

(defun send-payload (session interface index message payload &optional (sequence 0))
  "Sends a message with PAYLOAD as its body, nil for none."
  (let ((body (if payload (encode payload) (vector))) (connection (connection-of session)))
    (send-message connection
                  (make-header :interface interface :index index
                               :kind (message-type-kind message) :subtype (message-type-subtype message)
                               :timestamp (wall-clock) :sequence sequence :size (length body)
                               ;; As in libplayerc: the port in messages to a device, 0 in messages to the server.
                               :robot (if (= interface playhouse.player:+code+) 0 (connected-port connection)))
                  body)))

(defun request-answer (session interface index message &optional payload timeout)
  "Sends and waits for the ACK, which is returned. Signals request-refused on NACK, request-timeout on silence."
  (let ((seconds (timeout-or-own session timeout))
        (key (list interface index (message-type-subtype message)))
        (whose (format nil "~a of ~a" (message-type-name message) (device-name-of interface index))))
    (let ((answer (handler-case (exchange session key seconds
                                          (lambda ()
                                            (send-payload session interface index message payload
                                                          (sequence-of session))))
                    (request-timeout ()
                      (fail 'request-timeout "~a: no answer to ~a in ~a s" (peer session) whose
                            (seconds-text seconds))))))
      (setf (answering-port session) (header-robot (message-header answer)))
      (when (eq (header-kind (message-header answer)) :nack)
        (error 'request-refused :text (format nil "~a: ~a was refused" (peer session) whose)
                                :body (message-body answer)))
      answer)))

(defun request-of-server (session message payload answer-type)
  "Requests of the server itself and decodes the answer's body."
  (decode answer-type (message-body (request-answer session playhouse.player:+code+ 0 message payload))))

(defun begin-round (session)
  "Requests a round of data, unless one is open or has ended with its data queued; it ends with the SYNCH that clears
round-open-p, or is refused."
  (let ((here (and (round-waits-p session) (not (queue-empty-p (waiting session))))))
    (setf (round-waits-p session) nil)
    (unless (or (round-open-p session) here)
      (setf (round-open-p session) t
            (round-refused-p session) nil)
      ;; After a disconnection, data from before it are still to be received; then the same error follows.
      (handler-case (send-payload session playhouse.player:+code+ 0 playhouse.player:+req-data+ nil
                                  (sequence-of session))
        (connection-lost () nil)))))

(defun sort-next (session deadline)
  "Receives one message outside a request and dispatches it."
  (let ((message (receive-message (connection-of session) deadline)))
    (unless (take-notice session message)
      (sort-message session message))))

(defun drop-waiting (session interface index)
  "Drops queued data of a retired device, so that they are not delivered to a new device at its address."
  (incf (skipped-count session)
        (remove-from-queue (lambda (message)
                             (let ((header (message-header message)))
                               (and (= (header-interface header) interface) (= (header-index header) index))))
                           (waiting session))))

(defun exchange (session key seconds send)
  "Calls SEND, which sends a request, and returns its answer."
  (let* ((connection (connection-of session)) (before (sent-count connection)) (settled nil) (answer nil))
    (unwind-protect
         (loop with deadline = (progn (funcall send) (deadline-after seconds))
               until answer
               do (let ((message (receive-message connection deadline)))
                    (cond ((take-notice session message))
                          ((not (answers-p (message-header message) key)) (sort-message session message))
                          ((ours-p session (header-sequence (message-header message)) key) (setf answer message))
                          (t (setf settled (or (settle session key) settled))))))
      ;; After a timeout or Ctrl-C, requests are numbered, so that a late answer to this one is not matched to another.
      ;; If the answer to an abandoned request of this type arrived meanwhile, as many answers are missing as before.
      (unless (or answer (= before (sent-count connection)))
        (incf (sequence-of session))
        (unless settled
          (push key (abandoned session)))))
    answer))

(defun settle (session key)
  "Skips an answer to an abandoned request; returns whether one of this type was missing."
  (incf (skipped-count session))
  (when (member key (abandoned session) :test #'equal)
    (setf (abandoned session) (remove key (abandoned session) :test #'equal :count 1))
    t))

(defun ours-p (session sequence key)
  "0 is the number of requests before the first timeout, and of servers that do not return numbers."
  (if (zerop sequence)
      (not (member key (abandoned session) :test #'equal))
      (= sequence (sequence-of session))))

(defun answers-p (header key)
  (and (member (header-kind header) '(:ack :nack))
       (equal (list (header-interface header) (header-index header) (header-subtype header)) key)))

(defun answers-server-request-p (header message)
  (answers-p header (list playhouse.player:+code+ 0 (message-type-subtype message))))

(defun take-notice (session message)
  "Processes the notice that a device was retired; nil for any other message."
  (when (and (eq (header-kind (message-header message)) :ack)
             (answers-server-request-p (message-header message) playhouse.player:+req-dev+))
    (let ((notice (handler-case (decode 'playhouse.player:device-req (message-body message))
                    (wire-error () nil))))
      (when (and notice (= (playhouse.player:device-req-access notice) +retired+))
        (let ((address (playhouse.player:device-req-addr notice)))
          (setf (told-p session) t)
          (funcall (retire-function session)
                   (playhouse.common:devaddr-interf address)
                   (playhouse.common:devaddr-index address)
                   (playhouse.common:devaddr-robot address))
          t)))))

(defun sort-message (session message)
  (let ((header (message-header message)))
    (cond ((eq (header-kind header) :data) (keep-data session message))
          ((eq (header-kind header) :synch) (end-round session message))
          ((answers-server-request-p header playhouse.player:+req-data+)
           (when (eq (header-kind header) :nack)
             (setf (round-open-p session) nil
                   (round-refused-p session) t)))
          (t (incf (skipped-count session))))))

(defun keep-data (session message)
  (when (= (queue-count (waiting session)) +waiting-limit+)
    (dequeue (waiting session))
    (incf (overflow-count session))
    (incf (unread-count session)))
  (enqueue message (waiting session)))

(defun end-round (session message)
  (setf (round-open-p session) nil
        (round-waits-p session) (not (queue-empty-p (waiting session))))
  (when (= (header-subtype (message-header message))
           (message-type-subtype playhouse.player:+synch-overflow+))
    (incf (overflow-count session) (max 1 (lost-in-round message)))))

(defun lost-in-round (message)
  (handler-case (playhouse.common:uint32-value (decode 'playhouse.common:uint32 (message-body message)))
    (wire-error () 0)))
