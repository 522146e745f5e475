;;;; Everything that standard Common Lisp does not have: bits of floats, UTF-8, clocks, sockets and signals, and classes
;;;; of functions. Only this file depends on SBCL; another implementation needs these functions and no more.

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

;;; Generic functions with an error of their own

(defclass operation (standard-generic-function) ()
  (:metaclass sb-mop:funcallable-standard-class)
  (:documentation "A function of the proxies, see define-operation."))

(defun operation-name (operation)
  (sb-mop:generic-function-name operation))

(defun operation-classes (operation)
  "Names of the classes that the function is for."
  (loop for method in (sb-mop:generic-function-methods operation)
        collect (class-name (first (sb-mop:method-specializers method)))))

;;; Signals: Ctrl-C, SIGTERM, and SIGHUP, which a closed terminal sends

(defconstant +ignored+ 1 "SIG_IGN of the system.")

(defvar *catching* nil "Whether this thread is in call-with-signals.")

(defun ignored-p (number)
  "Whether this process was started with the signal ignored. Only for signals that SBCL does not handle itself."
  (flet ((exchange (handler)
           (sb-alien:alien-funcall
            (sb-alien:extern-alien "signal"
                                   (function sb-alien:unsigned-long sb-alien:int sb-alien:unsigned-long))
            number handler)))
    (let ((before (exchange +ignored+)))
      (exchange before)
      (= before +ignored+))))

(defun caught-signals ()
  "Number of each signal that is caught, and the handler that SBCL has for it. What nohup ignores stays ignored, and so
does Ctrl-C in the background of a script: there SIGINT and SIGQUIT were both ignored at the start, and SBCL has left
only SIGQUIT so."
  (append (list (list sb-unix:sigterm #'sb-unix::sigterm-handler))
          (unless (ignored-p sb-unix:sighup) (list (list sb-unix:sighup :default)))
          (unless (ignored-p sb-unix:sigquit) (list (list sb-unix:sigint #'sb-unix::sigint-handler)))))

(defun end-process (code)
  "Ends the process with this exit code, after the cleanup of the forms that the program is in."
  (sb-ext:exit :code code :timeout 5))

(defun call-with-signals (function end)
  "Calls FUNCTION and returns its values. On the first signal it is left by a non-local exit, and the values are those
of END for 128 and the number of the signal."
  (if *catching*
      (funcall function)                  ; the outer one ends the program
      (let* ((thread sb-thread:*current-thread*) (tag (list nil)) (arrived nil) (caught (caught-signals))
             (code (catch tag
                     (return-from call-with-signals
                       (let ((*catching* t))
                         (unwind-protect
                              (progn
                                (sb-sys:enable-interrupt sb-unix:sigint :ignore)
                                (loop for (number) in caught
                                      do (sb-sys:enable-interrupt
                                          number
                                          (lambda (number info context) ; in whatever thread the system calls it
                                            (declare (ignore info context))
                                            (unless arrived ; a closed terminal may signal twice
                                              (setf arrived t)
                                              (sb-thread:interrupt-thread
                                               thread (lambda () (throw tag (+ 128 number))))))))
                                (funcall function))
                           (unless arrived
                             (loop for (number before) in caught
                                   do (sb-sys:enable-interrupt number before)))))))))
        (funcall end code))))

(defmacro with-signals (&body body)
  "Runs BODY and returns its values. Ctrl-C, SIGTERM and SIGHUP (a closed terminal) leave BODY by a non-local exit, so
that with-client and with-device in it stop robots and close devices; then the process ends with 128 and the number of
the signal as its exit code. A signal that was ignored when the process started stays so."
  `(call-with-signals (lambda () ,@body) #'end-process))
