;;;; A server of a few lines for one client: a script says what it answers.

(in-package #:playhouse-client.tests)

(defstruct peer
  "The server's end of the connection, for scripts."
  socket stream port (received '()) (lock (sb-thread:make-mutex)))

(define-condition peer-leaves (error) ()
  (:documentation "Ends a script and closes the connection."))


(defun leave ()
  "Closes at once: what the client has sent or sends from then on is answered with a reset."
  (error 'peer-leaves))

(defun finish (peer)
  "Closes in order: the client reads what was sent, and then the end."
  (sb-bsd-sockets:socket-shutdown (peer-socket peer) :direction :output)
  (loop while (receive peer))
  (leave))

(defun exactly (peer size)
  "The next bytes of the client, nil at its end."
  (let ((octets (make-array size :element-type '(unsigned-byte 8))))
    (and (= (read-sequence octets (peer-stream peer)) size) octets)))

(defun receive (peer)
  "Header and body of the client's next message, two values; nil at its end."
  (let* ((octets (exactly peer +header-bytes+)) (header (and octets (decode-header octets)))
         (body (and header (exactly peer (header-size header)))))
    (when body
      (sb-thread:with-mutex ((peer-lock peer))
        (push (cons header body) (peer-received peer)))
      (values header body))))

(defun received-of (peer)
  "Header and body of all messages so far, in order."
  (sb-thread:with-mutex ((peer-lock peer))
    (reverse (peer-received peer))))

(defun put (peer octets)
  (write-sequence octets (peer-stream peer))
  (finish-output (peer-stream peer)))

(defun message-bytes (interface index kind subtype body &key (sequence 0) (timestamp 1d0))
  (concatenate 'octets
               (encode-header (make-header :interface interface :index index :kind kind :subtype subtype
                                           :timestamp timestamp :sequence sequence :size (length body)))
               body))

(defun put-message (peer &rest arguments)
  "ARGUMENTS are those of message-bytes."
  (put peer (apply #'message-bytes arguments)))

(defun answer (peer header &key (kind :ack) (body #()) (sequence (header-sequence header)))
  (put-message peer (header-interface header) (header-index header) kind (header-subtype header) body
               :sequence sequence))

(defun data-bytes (message value &key (index 0) (timestamp 1d0))
  (message-bytes (message-type-interface message) index :data (message-type-subtype message) (encode value)
                 :timestamp timestamp))

(defun put-data (peer message value &rest options)
  (put peer (apply #'data-bytes message value options)))

(defun synch-bytes (&optional lost)
  (if lost
      (message-bytes 1 0 :synch 2 (encode (playhouse.common:make-uint32 :value lost)))
      (message-bytes 1 0 :synch 1 #())))

(defun put-synch (peer &optional lost)
  (put peer (synch-bytes lost)))

(defun serve (peer rounds)
  "Acknowledges what every client asks (modes, opening, closing) and leaves the rest to ROUNDS, a function of header and
body."
  (loop (multiple-value-bind (header body) (receive peer)
          (cond ((null header) (return))
                ((and (= (header-interface header) 1) (= (header-subtype header) 3)) (answer peer header :body body))
                ((and (= (header-interface header) 1) (= (header-subtype header) 5)) (answer peer header))
                (t (funcall rounds header body))))))

(defparameter *banner* (let ((octets (make-array 32 :element-type '(unsigned-byte 8) :initial-element 0)))
                         (replace octets (map 'vector #'char-code "Player v.3.1.1"))))

(defun listener ()
  "A socket that listens on a free port of this machine, and the port."
  (let ((socket (make-instance 'sb-bsd-sockets:inet-socket :type :stream :protocol :tcp)))
    (sb-bsd-sockets:socket-bind socket #(127 0 0 1) 0)
    (sb-bsd-sockets:socket-listen socket 1)
    (values socket (nth-value 1 (sb-bsd-sockets:socket-name socket)))))

(defun serve-one (listener peer banner script)
  "Serves the first client that comes; returns what was wrong with the script, or nil."
  (when (sb-sys:wait-until-fd-usable (sb-bsd-sockets:socket-file-descriptor listener) :input 10 nil)
    (let ((socket (sb-bsd-sockets:socket-accept listener)))
      (setf (sb-bsd-sockets:sockopt-tcp-nodelay socket) t
            (peer-socket peer) socket
            (peer-stream peer) (sb-bsd-sockets:socket-make-stream socket :input t :output t :timeout 10
                                                                         :element-type '(unsigned-byte 8)))
      (unwind-protect
           (handler-case (progn (put peer banner) (funcall script peer) nil)
             (peer-leaves () nil)
             (stream-error (problem) (and (typep problem 'sb-sys:io-timeout) (princ-to-string problem)))
             (error (problem) (format nil "script: ~a" problem)))
        (sb-bsd-sockets:socket-close socket :abort t)))))

(defun call-with-server (script banner function)
  "Calls FUNCTION with a peer and its address while a thread serves; afterwards the script has ended."
  (multiple-value-bind (listener port) (listener)
    (let* ((peer (make-peer :port port))
           (thread (sb-thread:make-thread #'serve-one :arguments (list listener peer banner script))))
      (unwind-protect (funcall function peer (format nil "127.0.0.1:~d" port))
        (let ((problem (sb-thread:join-thread thread :timeout 20 :default "the script does not end")))
          (sb-bsd-sockets:socket-close listener :abort t)
          (when problem (fault "~a" problem)))))))

(defmacro with-server ((peer address script &key (banner '*banner*)) &body body)
  "Runs BODY beside a server with this SCRIPT, a function of the peer."
  `(call-with-server ,script ,banner
                     (lambda (,peer ,address)
                       (declare (ignorable ,peer ,address))
                       ,@body)))

(defmacro rounds ((peer header &optional (body (gensym "BODY"))) &body forms)
  "A script that acknowledges modes, opening and closing, and leaves other messages to FORMS."
  `(lambda (,peer)
     (serve ,peer (lambda (,header ,body)
                    (declare (ignorable ,header ,body))
                    ,@forms))))

(defmacro with-connection ((client script &rest options) &body body)
  "Runs BODY with a client of a server with this SCRIPT. The variables PEER and ADDRESS tell of the server."
  `(with-server (peer address ,script)
     (with-client (,client address ,@options)
       ,@body)))
