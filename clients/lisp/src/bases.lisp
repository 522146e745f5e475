;;;; What the proxies are derived from, beside device: base, keeping and selecting.

(in-package #:playhouse-client)

(defclass base (device)
  ((moving :initform nil :accessor movingp :documentation "Whether the last command was a motion."))
  (:documentation "What drives. Closing it while it moves stops it first."))

(defmethod close-device :before ((base base))
  (when (and (device-open-p base) (movingp base) (not (device-gone-p base)) (reachablep base))
    (stop base)))

(defmethod stop ((base base))
  (drive base 0))

;;; Queues

(defparameter *kept-limit* 1024 "Limit of a queue of messages; the oldest are dropped.")

(defclass keeping (device)
  ((kept :initform (make-queue) :reader kept))
  (:documentation "Base of devices whose data messages are queued until the program takes them."))

(defgeneric meaning (device value)
  (:documentation "What is kept of a data message."))

(defmethod take :before ((device keeping) message value timestamp)
  (declare (ignore message timestamp))
  (let ((queue (kept device)))
    (when (= (queue-count queue) *kept-limit*)
      (dequeue queue))
    (enqueue (meaning device value) queue)))

(defmethod forget-data :before ((device keeping))
  (take-all (kept device)))

(defmethod next-update ((device keeping) &key timeout)
  (loop while (queue-empty-p (kept device))
        do (next-data device :timeout timeout))
  (dequeue (kept device)))

;;; Selected data

(defclass selecting (device) ()
  (:documentation "Base of devices whose data are of one of several messages, which send selects."))

(defmethod send ((imu selecting) datatype)
  (insist-on-message imu datatype)
  (request imu playhouse.imu:+req-set-datatype+
           (playhouse.imu:make-datatype-config :value (message-type-subtype datatype))))

(defmethod lack-of ((imu selecting) message)
  (let ((name (message-type-name message)))
    (format nil "~a~@[; (send imu playhouse.imu:+~a+) selects it~]" (call-next-method)
            (and (device-has-data-p imu) (substitute #\- #\. (subseq name (1+ (position #\. name))))))))

(defun newest-of (device &rest messages)
  "The newest value of several data messages. Signals no-data before the first."
  (let ((best nil) (best-time nil))
    (dolist (message messages (or best (newest device (first messages))))
      (multiple-value-bind (value time) (latest device message)
        (when (and value (or (null best) (> time best-time)))
          (setf best value best-time time))))))

;;; Updates

(defmacro define-updates (class reader)
  "next-update of a proxy: waits for new data, then calls READER."
  `(defmethod next-update ((device ,class) &key timeout)
     (next-data device :timeout timeout)
     (,reader device)))
