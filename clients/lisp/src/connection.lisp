;;;; One TCP connection to a Player server: banner, framing, deadlines. It interprets headers only.

(in-package #:playhouse-client)

(defconstant +banner-bytes+ 32)
(defconstant +chunk+ 65536)

(defstruct message "A header and the undecoded body." header body)

(defclass connection ()
  ((peer :initarg :peer :reader peer :documentation "HOST:PORT of the server.")
   (port :initarg :port :reader connected-port)
   (timeout :initarg :timeout :reader timeout-of)
   (socket :initform nil :accessor socket-of)
   (buffer :initform (make-array +chunk+ :element-type '(unsigned-byte 8)) :accessor buffer-of)
   (sent-count :initform 0 :accessor sent-count :documentation "Messages that were sent whole.")
   (start :initform 0 :accessor buffer-start)
   (end :initform 0 :accessor buffer-end)
   (fault :initform nil :accessor fault-of :documentation "Why nothing can be sent.")
   (ended :initform nil :accessor ended-p :documentation "By the server, in order.")
   (banner :initform "" :accessor banner-of))
  (:documentation "Sends and receives complete messages. A timeout keeps partially read bytes, so reading can continue.

Deadlines are times of (clock), nil for none. If the server disconnects, messages it had sent can still be received;
then every call signals the reason."))

(defun make-connection (host port timeout)
  "Connects and reads the banner. Signals connection-lost."
  (let ((connection (make-instance 'connection :peer (format nil "~a:~d" host port) :port port
                                               :timeout (checked-seconds timeout))))
    (handler-case
        (let ((deadline (deadline-after timeout)))
          (setf (socket-of connection) (connect-socket host port (seconds-until deadline)))
          (read-banner connection deadline)
          connection)
      (socket-fault (problem) (error (drop connection "cannot connect: ~a" (socket-fault-text problem))))
      (request-timeout () (error (drop connection "cannot connect: no banner in time"))))))

(defun alivep (connection)
  (and (socket-of connection) (null (fault-of connection))))

(defun send-message (connection header body)
  "Signals connection-lost, or wire-error if the message is too long."
  (when (> (length body) +max-body-bytes+)
    (fail 'wire-error "a message of ~d bytes is over the wire's limit of ~d" (length body) +max-body-bytes+))
  (unless (alivep connection)
    (error (lost connection)))
  (handler-case (send-octets connection (concatenate 'octets (encode-header header) body))
    (socket-fault (problem)
      (setf (fault-of connection) (format nil "the server is gone: ~a" (socket-fault-text problem)))
      (error (lost connection)))))

(defun send-octets (connection octets)
  "Sends all of it. A message that was sent in part cannot be continued: if that is left, nothing can be sent any more."
  (let ((deadline (deadline-after (timeout-of connection))) (sent 0) (socket (socket-of connection)))
    (with-interrupts-in-waits
      (unwind-protect
           (loop (incf sent (send-some socket octets sent))
                 (when (= sent (length octets)) (return))
                 (unless (wait-for-socket socket :output (seconds-until deadline))
                   (error 'socket-fault :text "timed out")))
        (if (= sent (length octets))
            (incf (sent-count connection))
            (setf (fault-of connection) "a message was sent in part"))))))

(defun receive-message (connection deadline)
  "The next message. Signals request-timeout or connection-lost."
  (need connection +header-bytes+ deadline)
  (let* ((header (buffered-header connection)) (end (+ +header-bytes+ (header-size header))))
    (when (> (header-size header) +max-body-bytes+)
      (error (drop connection "a header announces ~d bytes, over the limit" (header-size header))))
    (need connection end deadline)
    (let ((octets (take-octets connection end)))
      (make-message :header header :body (subseq octets +header-bytes+)))))

(defun buffered-message-p (connection)
  "Whether a complete message is buffered, so that receive-message returns without waiting."
  (and (>= (buffered-count connection) +header-bytes+)
       (let ((size (header-size (buffered-header connection))))
         (or (> size +max-body-bytes+) (>= (buffered-count connection) (+ +header-bytes+ size))))))

(defun close-connection (connection timeout)
  "Ends sending and waits up to TIMEOUT seconds until the server has read everything. Closing with unread data makes TCP
discard data in transit, such as a last stop command."
  (let ((socket (socket-of connection)) (deadline (deadline-after timeout)))
    (when socket
      (handler-case
          (loop initially (end-sending socket)
                for count = (receive-some socket (buffer-of connection) 0)
                until (or (eql count 0) (passedp deadline))
                do (unless count
                     (with-interrupts-in-waits (wait-for-socket socket :input (seconds-until deadline)))))
        (socket-fault () nil))            ; it disconnects already
      (drop connection "the connection is closed"))))

(defun read-banner (connection deadline)
  (need connection +banner-bytes+ deadline)
  (let ((banner (string-right-trim (string #\Nul) (map 'string #'code-char (take-octets connection +banner-bytes+))))
        (wanted "Player v."))
    (unless (eql (mismatch wanted banner) (length wanted))
      (error (drop connection "not a Player server (it says ~s)" banner)))
    (setf (banner-of connection) banner)))

(defun buffered-count (connection)
  (- (buffer-end connection) (buffer-start connection)))

(defun buffered-header (connection)
  (let ((start (buffer-start connection)))
    (decode-header (subseq (buffer-of connection) start (+ start +header-bytes+)))))

(defun take-octets (connection count)
  "The first bytes of the buffer, which are then no longer in it."
  (let* ((start (buffer-start connection)) (end (+ start count)))
    (prog1 (subseq (buffer-of connection) start end)
      (setf (buffer-start connection) end))))

(defun need (connection count deadline)
  "Receives until the buffer has this many bytes."
  (loop while (< (buffered-count connection) count)
        do (unless (socket-of connection)
             (error (lost connection)))
           (handler-case (receive-chunk connection deadline)
             (socket-fault (problem)
               (error (drop connection "the server is gone: ~a" (socket-fault-text problem)))))))

(defun receive-chunk (connection deadline)
  "Receives what has arrived, and if that is nothing, waits."
  (ecase (with-interrupts-in-waits (try-to-receive connection deadline))
    (:more nil)
    (:late (fail 'request-timeout "~a: no message in time" (peer connection)))
    (:gone (error (drop connection "the server is gone")))
    (:end (setf (ended-p connection) (null (fault-of connection)))
          (error (drop connection "the run ended: the server closed the connection")))))

(defun try-to-receive (connection deadline)
  "What came of it: :more, :late, :gone, or the :end of the stream."
  (make-room connection)
  (let* ((socket (socket-of connection))
         (count (receive-some socket (buffer-of connection) (buffer-end connection))))
    (cond ((eql count 0) :end)
          (count (incf (buffer-end connection) count)
                 :more)
          ((fault-of connection) :gone)   ; after a fault of sending nothing new is expected
          ((wait-for-socket socket :input (seconds-until deadline)) :more)
          (t :late))))

(defun make-room (connection)
  "Moves what is buffered to the front, into a larger buffer if this one is full. It grows with what arrives, not with
what a header announces."
  (let* ((buffer (buffer-of connection)) (count (buffered-count connection)) (size (length buffer)))
    (when (= (buffer-end connection) size)
      (let ((target (if (> count (floor size 2)) (make-array (* 2 size) :element-type '(unsigned-byte 8)) buffer)))
        (replace target buffer :start2 (buffer-start connection) :end2 (buffer-end connection))
        (setf (buffer-of connection) target
              (buffer-start connection) 0
              (buffer-end connection) count)))))

(defun lost (connection)
  "The error to signal."
  (make-condition (if (ended-p connection) 'run-ended 'connection-lost)
                  :text (format nil "~a: ~a" (peer connection) (fault-of connection))))

(defun drop (connection control &rest arguments)
  "Closes the connection and returns the error to signal, with the first reason found."
  (unless (fault-of connection)
    (setf (fault-of connection) (apply #'format nil control arguments)))
  (when (socket-of connection)
    (close-socket (socket-of connection))
    (setf (socket-of connection) nil))
  (lost connection))
