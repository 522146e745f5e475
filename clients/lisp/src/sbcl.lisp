;;;; Everything that standard Common Lisp does not have: bits of floats, UTF-8, clocks and sockets. Only this file, and
;;;; the signals of examples/program.lisp, depend on SBCL; another implementation needs these functions and no more.

(in-package #:playhouse.base)

(deftype octets (&optional (size '*)) `(simple-array (unsigned-byte 8) (,size)))

;;; Floats. IEEE 754 allows comparisons and arithmetic with NaN and infinities, which SBCL traps by default.

(defmacro without-float-traps (&body body)
  "Runs BODY with the results of IEEE 754 for NaN, infinities and overflows, instead of arithmetic errors."
  `(sb-int:with-float-traps-masked (:invalid :overflow :inexact :divide-by-zero) ,@body))

(declaim (inline single-of-bits double-of-bits bits-of-single bits-of-double))

(defun single-of-bits (bits)
  "The float32 of 32 bits, NaN and infinities included."
  (declare (type (unsigned-byte 32) bits))
  (sb-kernel:make-single-float (if (logbitp 31 bits) (- bits (ash 1 32)) bits)))

(defun double-of-bits (high low)
  "The float64 of two words."
  (declare (type (unsigned-byte 32) high low))
  (sb-kernel:make-double-float (if (logbitp 31 high) (- high (ash 1 32)) high) low))

(defun bits-of-single (value)
  (declare (type single-float value))
  (ldb (byte 32 0) (sb-kernel:single-float-bits value)))

(defun bits-of-double (value)
  "Two words, the high one first."
  (declare (type double-float value))
  (values (ldb (byte 32 0) (sb-kernel:double-float-high-bits value)) (sb-kernel:double-float-low-bits value)))

(defun float-kind (value)
  "Of a float: :nan, :infinity, :minus-infinity, or nil if it is finite."
  (cond ((sb-ext:float-nan-p value) :nan)
        ((not (sb-ext:float-infinity-p value)) nil)
        ((plusp (float-sign value)) :infinity)
        (t :minus-infinity)))

;;; Text

(defun utf-8-octets (string)
  "The bytes of a string, nil if it has characters that UTF-8 cannot encode."
  (handler-case (coerce (sb-ext:string-to-octets string :external-format :utf-8) 'octets)
    (sb-int:character-encoding-error () nil)))

(defun utf-8-string (octets)
  "The text of bytes; U+FFFD stands for those that are not UTF-8."
  (sb-ext:octets-to-string (coerce octets 'octets) :external-format '(:utf-8 :replacement #\ufffd)))

;;; Time

(defun wall-clock ()
  "Seconds since 1970."
  (multiple-value-bind (seconds microseconds) (sb-ext:get-time-of-day)
    (+ (coerce seconds 'double-float) (* microseconds 1d-6))))

(defun clock ()
  "Seconds of a clock that only goes forward, as a rational."
  (/ (get-internal-real-time) internal-time-units-per-second))

;;; Sockets: TCP, never blocking; waits have a time limit in seconds, nil for none.

(define-condition socket-fault (error)
  ((text :initarg :text :reader socket-fault-text)))

(defmacro with-interrupts-in-waits (&body body)
  "Runs BODY without asynchronous interrupts such as Ctrl-C, except in its waits. So no bytes are lost between a call of
the system and the note of its result."
  `(sb-sys:without-interrupts (sb-sys:allow-with-interrupts ,@body)))

(defmacro with-socket-faults (&body body)
  "Turns errors of the socket library into socket-fault with the system's text."
  `(handler-case (progn ,@body)
     (sb-bsd-sockets:socket-error (problem)
       (error 'socket-fault :text (sb-int:strerror (sb-bsd-sockets::socket-error-errno problem))))
     (sb-bsd-sockets:name-service-error (problem)
       (let ((text (princ-to-string problem)))
         (error 'socket-fault :text (string-right-trim ")" (subseq text (1+ (or (position #\( text) -1)))))))))

(defconstant +longest-wait+ 1000000 "Seconds; the system rejects much longer ones.")

(defun wait-for-socket (socket direction seconds)
  "Whether the socket is ready for :input or :output within this time."
  (let ((descriptor (sb-bsd-sockets:socket-file-descriptor socket)))
    (sb-sys:with-interrupts
      (sb-sys:wait-until-fd-usable descriptor direction
                                   (and seconds (coerce (min seconds +longest-wait+) 'double-float))
                                   nil))))

(defun host-addresses (host)
  "The addresses of a host, each a vector of 4 or 16 bytes."
  (when (find #\Nul host) (error 'socket-fault :text "Name or service not known"))
  (with-socket-faults
    (loop for entry in (multiple-value-list (sb-bsd-sockets:get-host-by-name host))
          when entry append (sb-bsd-sockets:host-ent-addresses entry))))

(defun connect-address (address port deadline)
  "A connected socket. Signals socket-fault."
  (let* ((class (if (= (length address) 4) 'sb-bsd-sockets:inet-socket 'sb-bsd-sockets:inet6-socket))
         (socket (with-socket-faults (make-instance class :type :stream :protocol :tcp)))
         (connected nil))
    (unwind-protect
         (with-socket-faults
           (setf (sb-bsd-sockets:non-blocking-mode socket) t)
           (handler-case (sb-bsd-sockets:socket-connect socket address port)
             (sb-bsd-sockets:operation-in-progress ()
               (unless (wait-for-socket socket :output (and deadline (max 0 (- deadline (clock)))))
                 (error 'socket-fault :text "timed out"))
               (finish-connecting socket address port)))
           (setf (sb-bsd-sockets:sockopt-tcp-nodelay socket) t
                 connected t)
           socket)
      (unless connected (sb-bsd-sockets:socket-close socket :abort t)))))

(defun finish-connecting (socket address port)
  "Checks how a connect that had to wait has ended: only if it failed, a second one tells why."
  (handler-case (sb-bsd-sockets:socket-peername socket)
    (sb-bsd-sockets:socket-error () (sb-bsd-sockets:socket-connect socket address port))))

(defun connect-socket (host port seconds)
  "A socket that is connected to one of the host's addresses. Signals socket-fault."
  (unless (<= 0 port 65535) (error 'socket-fault :text "port must be 0-65535"))
  (let ((deadline (and seconds (+ (clock) seconds))) (fault nil))
    (dolist (address (host-addresses host))
      (handler-case (return-from connect-socket (connect-address address port deadline))
        (socket-fault (problem) (setf fault problem))))
    (error (or fault (make-condition 'socket-fault :text "the host has no address")))))

(defun send-some (socket octets start)
  "Sends bytes from START on; returns how many the system took, 0 if it takes none now. Signals socket-fault."
  (with-socket-faults
    (let ((rest (if (zerop start) octets (subseq octets start))))
      (handler-case (or (sb-bsd-sockets:socket-send socket rest (length rest) :nosignal t) 0)
        (sb-bsd-sockets:interrupted-error () 0)))))

(defun receive-some (socket octets start)
  "Receives into OCTETS from START on. Returns the number of bytes, 0 at the end of the stream, or nil if none have
arrived. Signals socket-fault."
  (declare (type octets octets))
  (multiple-value-bind (count errno)
      (sb-sys:with-pinned-objects (octets)
        (sb-unix:unix-read (sb-bsd-sockets:socket-file-descriptor socket)
                           (sb-sys:sap+ (sb-sys:vector-sap octets) start)
                           (- (length octets) start)))
    (cond (count count)
          ((member errno (list sb-unix:eagain sb-unix:eintr)) nil)
          (t (error 'socket-fault :text (sb-int:strerror errno))))))

(defun end-sending (socket)
  "Tells the other side that nothing more follows. Signals socket-fault."
  (with-socket-faults (sb-bsd-sockets:socket-shutdown socket :direction :output)))

(defun close-socket (socket)
  (sb-bsd-sockets:socket-close socket :abort t))
