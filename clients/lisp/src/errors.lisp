;;;; The errors of this library, all of them of type player-error; each report is one line.

(in-package #:playhouse.base)

(define-condition player-error (error)
  ((text :initarg :text :reader error-text))
  (:report (lambda (condition stream) (write-string (error-text condition) stream)))
  (:documentation "Base of every error that this library signals."))

(define-condition connection-lost (player-error) ()
  (:documentation "The server is unreachable, has disconnected, or sent bytes that violate the protocol."))

(define-condition run-ended (connection-lost) ()
  (:documentation "The connection was closed in order, after all data that were sent: the run has ended, or the server
was killed, which looks the same."))

(define-condition request-timeout (player-error) ()
  (:documentation "No answer, or no data, before the timeout. The connection remains usable."))

(define-condition request-refused (player-error)
  ((body :initarg :body :initform nil :reader refused-body
         :documentation "The undecoded body of a NACK; nil without one."))
  (:documentation "The server answered NACK, or has no device or model of that name."))

(define-condition no-data (player-error) ()
  (:documentation "A value was read before the first data of the device; next-data waits for them."))

(define-condition device-closed (player-error) ()
  (:documentation "A device was used after it or its client was closed."))

(define-condition device-gone (player-error) ()
  (:documentation "A device was used that the server has retired: its model was removed."))

(define-condition invalid-value (player-error) ()
  (:documentation "An invalid argument, such as a speed that is not a number, an unknown interface, or a device of
another interface. Nothing was sent."))

(define-condition wire-error (player-error) ()
  (:documentation "Bytes that do not decode as the message of their header, or a value outside the range of its
field."))

(defun fail (type control &rest arguments)
  "Signals an error of this type with a formatted text."
  (error type :text (apply #'format nil control arguments)))
