;;;; Devices that carry messages and texts: opaque, speech and speech_recognition.

(in-package #:playhouse-client)

(defparameter *kept-limit* 1024 "Limit of a queue of messages; the oldest are dropped.")

(defclass keeping (device)
  ((kept :initform (make-queue) :reader kept))
  (:documentation "Base of devices whose data messages are queued until the program takes them."))

(defclass opaque (keeping) ()
  (:documentation "Byte messages: those between robots for a simulated radio, driver-specific for other drivers."))

(defclass speech-recognition (keeping) ()
  (:documentation "Speech recognition: texts of other models heard by a robot."))

(defclass speech (device) ()
  (:documentation "Speech output of a robot."))

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

(defmethod meaning ((device opaque) value)
  (playhouse.opaque:data-data value))

(defmethod meaning ((device speech-recognition) value)
  (text (playhouse.speech-recognition:data-text value)))

(defun insist-on-octets (device message)
  (unless (and (typep message 'sequence) (every (lambda (octet) (typep octet '(unsigned-byte 8))) message))
    (fail 'invalid-value "~a: a message is a sequence of bytes, not ~s" (device-name device) message)))

(defmethod send ((device opaque) message)
  (insist-on-octets device message)
  (command device playhouse.opaque:+cmd-data+ (playhouse.opaque:make-data :data message)))

(define-operation send-to ((radio opaque) address message)
  "For an opaque device that is a radio: sends bytes to the radio with this network address, \"\" to broadcast. Returns
when the message is queued. Signals request-refused for an unknown address, a message that is too long, or a full
queue."
  (insist-on-octets radio message)
  (request radio playhouse.opaque:+req-data+
           (playhouse.opaque:make-data :data (concatenate 'octets (c-string address) message))))

(define-operation take-messages ((device opaque))
  "Messages of an opaque device since the last call, in order, byte vectors."
  (take-all (kept device)))

(define-operation take-texts ((device speech-recognition))
  "Texts of a speech-recognition device since the last call, in order."
  (take-all (kept device)))

(define-operation say ((speech speech) text)
  "Sets the text that the robot says, replacing the previous one; \"\": none."
  (command speech playhouse.speech:+cmd-say+ (playhouse.speech:make-cmd :string (c-string text))))
