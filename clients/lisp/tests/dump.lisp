;;;; dump FILE prints every message of a recorded stream as a line of JSON: its name, its value, and the bytes that the
;;;; value encodes to. clients/python/tests/test_conformance.py compares them with the values decoded in Python.

(in-package #:playhouse-client.tests)

(defun dump (words)
  (destructuring-bind (file) words
    (let* ((octets (octets-of-file file))
           (suffix ".s2c")
           (at (if (eql (search suffix file :from-end t) (- (length file) (length suffix))) 32 0)))
      (loop while (<= (+ at +header-bytes+) (length octets))
            do (let* ((header (decode-header (subseq octets at (+ at +header-bytes+))))
                      (start (+ at +header-bytes+)) (end (+ start (header-size header))))
                 (when (> end (length octets)) (return))
                 (dump-message header (subseq octets start end))
                 (setf at end)))
      0)))

(defun octets-of-file (file)
  (with-open-file (stream file :element-type '(unsigned-byte 8))
    (let ((octets (make-array (file-length stream) :element-type '(unsigned-byte 8))))
      (read-sequence octets stream)
      octets)))

(defun dump-message (header body)
  (let* ((row (find-message (header-interface header) (header-kind header) (header-subtype header)))
         (payload (and row (message-type-payload row)))
         (value (and payload (plusp (length body))
                     (handler-case (decode payload body) (wire-error () nil)))))
    (format t "{\"name\":\"~:[~;~:*~a~]\",\"value\":" (and row (message-type-name row)))
    (write-json value)
    (format t ",\"again\":\"~(~{~2,'0x~}~)\"}~%" (and value (coerce (encode value) 'list)))))

(defun write-json (value)
  (typecase value
    (null (write-string "null"))
    (wire-struct (write-json-object value))
    (integer (princ value))
    (float (write-json-float value))
    (sequence (write-json-list value))))

(defun write-json-object (value)
  (let ((separator "{"))
    (dolist (field (struct-fields (type-of value)))
      (format t "~a\"~a\":" separator (field-name field))
      (if (member (first-of (field-type field)) '((:array :char) (:bounded :char) (:counted :char)) :test #'equal)
          (write-json-text (text (field-value field value)))
          (write-json (field-value field value)))
      (setf separator ","))
    (write-string "}")))

(defun first-of (type)
  "Shape and element of a declared type."
  (and (consp type) (list (first type) (second type))))

(defun write-json-float (value)
  (let ((*read-default-float-format* (type-of value)))
    (if (finitep value) (princ value) (write-string "null"))))

(defun write-json-list (values)
  (let ((separator "["))
    (map nil (lambda (value)
               (write-string separator)
               (write-json value)
               (setf separator ","))
         values)
    (write-string (if (zerop (length values)) "[]" "]"))))

(defun write-json-text (text)
  (write-char #\")
  (loop for letter across text
        do (cond ((find letter "\"\\") (format t "\\~a" letter))
                 ((< 31 (char-code letter) 127) (write-char letter))
                 ((< (char-code letter) #x10000) (format t "\\u~4,'0x" (char-code letter)))
                 (t (let ((rest (- (char-code letter) #x10000)))
                      (format t "\\u~4,'0x\\u~4,'0x" (+ #xd800 (ash rest -10)) (+ #xdc00 (ldb (byte 10 0) rest)))))))
  (write-char #\"))
