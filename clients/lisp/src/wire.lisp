;;;; Player's variant of XDR and its message header. Everything is big-endian and a multiple of four bytes. A list is
;;;; encoded as its count in the count field, and again as a length before its elements; the rules are in docs/wire.md.

(in-package #:playhouse.wire)

(defconstant +header-bytes+ 40)
(defconstant +max-body-bytes+ (- 33554432 +header-bytes+))

;;; Reading: front to back. Allocations are bounded by the size of the body.

(defstruct (reader (:constructor make-reader (octets)))
  (octets (error "a reader needs bytes") :type octets :read-only t)
  (at 0 :type fixnum))

(defun bytes-left (reader)
  (- (length (reader-octets reader)) (reader-at reader)))

(defun advance (reader size)
  "The place of the next SIZE bytes, which are then read."
  (declare (type (unsigned-byte 48) size))
  (let ((at (reader-at reader)))
    (when (> size (bytes-left reader))
      (fail 'wire-error "byte ~d: ~d bytes expected, ~d are left" at size (bytes-left reader)))
    (setf (reader-at reader) (+ at size))
    at))

(declaim (inline word-at))
(defun word-at (octets at)
  (declare (type octets octets) (type fixnum at))
  (logior (ash (aref octets at) 24) (ash (aref octets (+ at 1)) 16) (ash (aref octets (+ at 2)) 8)
          (aref octets (+ at 3))))

(defun read-uint32 (reader)
  (word-at (reader-octets reader) (advance reader 4)))

(declaim (inline signed))
(defun signed (value bits)
  "The low bits of a word as a number with a sign."
  (let ((low (ldb (byte bits 0) value)))
    (if (logbitp (1- bits) low) (- low (ash 1 bits)) low)))

(defun read-uint8 (reader) (ldb (byte 8 0) (read-uint32 reader)))
(defun read-int8 (reader) (signed (read-uint32 reader) 8))
(defun read-uint16 (reader) (ldb (byte 16 0) (read-uint32 reader)))
(defun read-int16 (reader) (signed (read-uint32 reader) 16))
(defun read-int32 (reader) (signed (read-uint32 reader) 32))
(defun read-int64 (reader)
  (let ((high (read-int32 reader)))
    (logior (ash high 32) (read-uint32 reader))))
(defun read-float32 (reader) (single-of-bits (read-uint32 reader)))
(defun read-float64 (reader)
  (let ((at (advance reader 8)) (octets (reader-octets reader)))
    (double-of-bits (word-at octets at) (word-at octets (+ at 4)))))

(defun read-octets (reader count)
  "COUNT raw bytes, and the zero padding of the last word."
  (declare (type (unsigned-byte 32) count))
  (let ((at (advance reader (+ count (mod (- count) 4)))))
    (subseq (reader-octets reader) at (+ at count))))

(defun read-length (reader name limit least)
  "The length before the elements of a list: at most LIMIT, each element at least LEAST bytes."
  (let ((count (read-uint32 reader)) (at (reader-at reader)))
    (when (> count limit)
      (fail 'wire-error "byte ~d: ~a has a length of ~d, over its limit of ~d" at name count limit))
    (when (> (* count least) (bytes-left reader))
      (fail 'wire-error "byte ~d: ~a claims ~d elements, but ~d bytes are left" at name count (bytes-left reader)))
    count))

(defmacro define-bulk-reader (name element-type bytes (octets at) expression)
  "Defines NAME: reads a number of values of one type at once, into a vector of that type."
  `(defun ,name (reader count)
     (declare (type (unsigned-byte 32) count) (optimize (speed 1)))
     (let* ((at (advance reader (* ,bytes count)))
            (octets (reader-octets reader))
            (values (make-array count :element-type ',element-type)))
       (declare (type fixnum at))
       (dotimes (i count values)
         (let ((,octets octets) (,at (+ at (* ,bytes i))))
           (declare (type fixnum ,at))
           (setf (aref values i) ,expression))))))

(define-bulk-reader read-float32s single-float 4 (octets at) (single-of-bits (word-at octets at)))
(define-bulk-reader read-float64s double-float 8 (octets at)
  (double-of-bits (word-at octets at) (word-at octets (+ at 4))))
(define-bulk-reader read-uint32s (unsigned-byte 32) 4 (octets at) (word-at octets at))
(define-bulk-reader read-int32s (signed-byte 32) 4 (octets at) (signed (word-at octets at) 32))
(define-bulk-reader read-uint16s (unsigned-byte 16) 4 (octets at) (ldb (byte 16 0) (word-at octets at)))
(define-bulk-reader read-int16s (signed-byte 16) 4 (octets at) (signed (word-at octets at) 16))
(define-bulk-reader read-int64s (signed-byte 64) 8 (octets at)
  (logior (ash (signed (word-at octets at) 32) 32) (word-at octets (+ at 4))))

;;; Writing. A value outside the range of its field is a wire-error.

(defstruct (writer (:constructor make-writer ()))
  (octets (make-array 64 :element-type '(unsigned-byte 8)) :type octets)
  (at 0 :type fixnum))

(defun reserve (writer size)
  "The place of the next SIZE bytes, which the caller sets."
  (declare (type fixnum size))
  (let* ((at (writer-at writer)) (end (+ at size)) (octets (writer-octets writer)))
    (when (> end (length octets))
      (let ((larger (make-array (max end (* 2 (length octets))) :element-type '(unsigned-byte 8) :initial-element 0)))
        (setf (writer-octets writer) (replace larger octets :end2 at))))
    (setf (writer-at writer) end)
    at))

(defun written (writer)
  (subseq (writer-octets writer) 0 (writer-at writer)))

(defun write-word (writer word)
  (declare (type (unsigned-byte 32) word))
  (let ((at (reserve writer 4)) (octets (writer-octets writer)))
    (loop for shift from 24 downto 0 by 8
          for i from at
          do (setf (aref octets i) (ldb (byte 8 shift) word)))))

(defun checked-integer (value low high)
  (unless (and (integerp value) (<= low value high))
    (fail 'wire-error "~a is outside [~d, ~d]" value low high))
  value)

(defmacro define-integer-writers (&rest rows)
  `(progn
     ,@(loop for (name low high) in rows
             collect `(defun ,name (writer value)
                        (write-word writer (ldb (byte 32 0) (checked-integer value ,low ,high)))))))

(define-integer-writers
  (write-uint8 0 255) (write-int8 -128 127) (write-uint16 0 65535) (write-int16 -32768 32767)
  (write-uint32 0 #xffffffff) (write-int32 #x-80000000 #x7fffffff))

(defun write-int64 (writer value)
  (checked-integer value (- (ash 1 63)) (1- (ash 1 63)))
  (write-word writer (ldb (byte 32 32) value))
  (write-word writer (ldb (byte 32 0) value)))

(defun converted (value type)
  "A real number as a float of TYPE. Signals wire-error for finite numbers that this type cannot hold."
  (or (if (typep value type)
          value
          (let ((made (handler-case (without-float-traps (coerce value type))
                        ((or arithmetic-error type-error) () nil))))
            (and made
                 (or (null (float-kind made)) (and (floatp value) (float-kind value)))
                 made)))
      (fail 'wire-error "~a is not a number of a ~(~a~)" value type)))

(defun write-float32 (writer value)
  (write-word writer (bits-of-single (converted value 'single-float))))

(defun write-float64 (writer value)
  (multiple-value-bind (high low) (bits-of-double (converted value 'double-float))
    (write-word writer high)
    (write-word writer low)))

(defun write-length (writer name count limit)
  "A count or length word before a list of at most LIMIT elements."
  (when (> count limit)
    (fail 'wire-error "~a has ~d elements, over its limit of ~d" name count limit))
  (write-word writer count))

(defun check-length (name count wanted)
  "Checks a list of fixed length, which is encoded without a length word."
  (unless (= count wanted)
    (fail 'wire-error "~a has ~d elements instead of ~d" name count wanted)))

(defun write-octets (writer octets &optional (size (length octets)))
  "Raw bytes and zeros: up to SIZE, then up to a multiple of four."
  (let* ((at (reserve writer (+ size (mod (- size) 4)))) (target (writer-octets writer)))
    (unless (every (lambda (octet) (typep octet '(unsigned-byte 8))) octets)
      (fail 'wire-error "a byte is outside [0, 255]"))
    (replace target octets :start1 at)
    (fill target 0 :start (+ at (length octets)) :end (writer-at writer))))

(defun write-fixed (writer name octets size)
  "Exactly SIZE bytes: OCTETS, zero-padded."
  (when (> (length octets) size)
    (fail 'wire-error "~a has ~d bytes, over its ~d" name (length octets) size))
  (write-octets writer octets size))

;;; Text

(defun text (octets)
  "The text of a string field, up to the first NUL."
  (utf-8-string (subseq octets 0 (position 0 octets))))

(defun c-string (string)
  "Encodes text as a string field, NUL-terminated and without a NUL inside."
  (unless (stringp string)
    (fail 'invalid-value "a text is a string, not ~s" string))
  (let ((encoded (utf-8-octets string)))
    (unless encoded
      (fail 'wire-error "~s cannot be sent as UTF-8" string))
    (when (find 0 encoded)
      (fail 'wire-error "~s has a NUL in it, where receivers would end it" string))
    (concatenate 'octets encoded #(0))))

;;; Headers

(defparameter *kinds* #(nil :data :cmd :req :ack :synch :nack)
  "The types of messages, by their numbers in headers.")

(defun kind-number (kind)
  (position kind *kinds*))

(defstruct header
  "The 40 bytes before every body. `kind' is :data, :cmd, :req, :ack, :synch or :nack, or a number that means none of
them; `size' is the body's length in bytes, `timestamp' is in seconds."
  (interface 0) (index 0) (kind :data) (subtype 0) (timestamp 0d0) (sequence 0) (size 0) (host 0) (robot 0))

(defun encode-header (header)
  (let ((writer (make-writer)) (kind (header-kind header)))
    (dolist (word (list (header-host header) (header-robot header) (header-interface header) (header-index header)
                        (if (integerp kind) kind (kind-number kind)) (header-subtype header)))
      (write-uint32 writer word))
    (write-float64 writer (header-timestamp header))
    (write-uint32 writer (header-sequence header))
    (write-uint32 writer (header-size header))
    (written writer)))

(defun decode-header (octets)
  "Reads 40 bytes; narrow fields keep their low bits only, as in every Player receiver."
  (let* ((reader (make-reader octets))
         (host (read-uint32 reader)) (robot (read-uint32 reader))
         (interface (read-uint16 reader)) (index (read-uint16 reader))
         (kind (read-uint8 reader)) (subtype (read-uint8 reader))
         (timestamp (read-float64 reader)) (sequence (read-uint32 reader)) (size (read-uint32 reader)))
    (make-header :interface interface :index index
                 :kind (or (and (< kind (length *kinds*)) (aref *kinds* kind)) kind)
                 :subtype subtype :timestamp timestamp :sequence sequence :size size :host host :robot robot)))
