;;;; Laws of the encoding: round trips, and hostile bytes that signal wire-error and nothing else.

(in-package #:playhouse-client.tests)

(defun payloads ()
  "The names of the structures of all interfaces."
  (let ((found '()))
    (dolist (package (list-all-packages) found)
      (when (and (eql 0 (search "PLAYHOUSE." (package-name package)))
                 (not (member (package-name package) '("PLAYHOUSE.BASE" "PLAYHOUSE.WIRE") :test #'string=)))
        (do-symbols (symbol package)
          (when (get symbol 'playhouse.wire::codec)
            (pushnew symbol found)))))))

(defun words (&rest numbers)
  "The bytes of words."
  (apply #'concatenate 'octets
         (loop for number in numbers
               collect (loop for shift from 24 downto 0 by 8 collect (ldb (byte 8 shift) number)))))

(defun random-words (state count)
  "Words as bodies have them: mostly small numbers, so that lengths are often believable."
  (apply #'words (loop repeat count
                       collect (if (zerop (random 5 state)) (random (ash 1 32) state) (random 4 state)))))

(defun decoded-or-nil (name octets)
  (handler-case (decode name octets) (wire-error () nil)))

(deftest all-interfaces-have-their-structures
  (check (= (length (payloads)) 223))
  (check (= (length (interface-names)) 43)))

(deftest what-decodes-encodes-to-bytes-that-mean-the-same
  (let ((state (sb-ext:seed-random-state 1)))
    (dolist (name (payloads))
      (let ((count 0))
        (dotimes (i 200)
          (let ((value (decoded-or-nil name (random-words state (1+ (random 59 state))))))
            (when value
              (incf count)
              (let ((body (encode value)))
                (unless (equalp (encode (decode name body)) body)
                  (fault "~s: ~s" name value))))))
        (when (zerop count) (fault "~s: nothing decoded" name))))))

(deftest a-body-that-is-cut-short-is-an-error
  (dolist (name (payloads))
    (let ((body (encode (funcall (find-symbol (format nil "MAKE-~a" name) (symbol-package name))))))
      (dotimes (size (length body))
        (when (decoded-or-nil name (subseq body 0 size))
          (fault "~s cut to ~d bytes" name size))))))

(deftest bytes-after-the-end-are-ignored
  (let ((car (playhouse.position2d:make-cmd-car :velocity 1d0 :angle 2d0)))
    (check (equalp (decode 'playhouse.position2d:cmd-car (concatenate 'octets (encode car) #(1 2 3 4))) car))))

(deftest a-huge-length-is-an-error-before-anything-is-allocated
  (let ((body (words #xffffffff #xffffffff)))
    (check-error wire-error "devices has a length of 4294967295, over its limit of 4096"
      (decode 'playhouse.player:device-devlist body))
    (check-error wire-error "key claims 4294967295 elements, but 0 bytes are left"
      (decode 'playhouse.common:intprop-req body))))

(deftest the-second-length-counts-and-may-not-exceed-the-first
  (flet ((body (count) (concatenate 'octets (words count 4) #(97 98 99 100) (words 5))))
    (check (equalp (playhouse.common:intprop-req-key (decode 'playhouse.common:intprop-req (body 8)))
                   #(97 98 99 100)))
    (check-error wire-error "common.IntpropReq: byte 8: key has a length of 4, over its limit of 3"
      (decode 'playhouse.common:intprop-req (body 3)))))

(deftest a-count-may-travel-apart-from-its-list
  (let ((value (playhouse.map:make-data :col 1 :row 2 :width 3 :height 4 :data-range -1 :data #(1 255))))
    (check (equalp (encode value) (concatenate 'octets (words 1 2 3 4 2 -1 2) #(1 255 0 0))))
    (check (equalp (decode 'playhouse.map:data (encode value)) value))))

(deftest a-number-that-does-not-fit-its-field-is-an-error
  (check-error wire-error "256 is outside" (encode (playhouse.player:make-device-datamode-req :mode 256)))
  (check-error wire-error "outside" (encode (playhouse.common:make-intprop-req :key #(120 0) :value (ash 1 31))))
  (check-error wire-error "driver_name has 65 elements"
    (encode (playhouse.player:make-device-req :driver-name (make-array 65 :initial-element 120))))
  (check-error wire-error "1.0d300 is not a number of a single-float"
    (encode (playhouse.map:make-info :scale 1d300)))
  (check-error wire-error "is not a number of a double-float"
    (encode (playhouse.position2d:make-cmd-car :velocity (expt 10 400)))))

(deftest numbers-that-are-not-finite-travel-without-traps
  (let* ((minus (- +infinity+))
         (sent (playhouse.position2d:make-cmd-car :velocity *nan* :angle minus))
         (body (encode sent))
         (taken (decode 'playhouse.position2d:cmd-car body)))
    (check (equalp body (words #x7ff80000 0 #xfff00000 0)))
    (check (not (finitep (playhouse.position2d:cmd-car-velocity taken))))
    (check (equalp (encode taken) body)))
  (let* ((body (concatenate 'octets (words 2 2 #x7f800000 #x7fa00000))) ; infinity, and a NaN that signals
         (taken (decode 'playhouse.aio:data body)))
    (check (equalp (encode taken) body))
    (check (notany #'finitep (playhouse.aio:data-voltages taken)))))

(deftest lists-of-numbers-are-vectors-of-their-type
  (let ((ranges (playhouse.sonar:data-ranges
                 (decode 'playhouse.sonar:data (encode (playhouse.sonar:make-data :ranges '(1 0.5d0 2)))))))
    (check (typep ranges '(simple-array single-float (3))))
    (check (equalp ranges #(1.0 0.5 2.0)))))

(deftest narrow-numbers-keep-their-low-bits
  (check (= (playhouse.player:device-datamode-req-mode (decode 'playhouse.player:device-datamode-req (words #x101))) 1))
  (check (= (playhouse.map:data-data-range (decode 'playhouse.map:data (words 0 0 0 0 0 200 0))) -56))
  (check (= (playhouse.map:data-data-range (decode 'playhouse.map:data (words 0 0 0 0 0 -200 0))) 56))
  (let ((header (decode-header (words 0 0 #x10004 #x10001 #x101 #x102 0 0 0 0))))
    (check (equal (list (header-interface header) (header-index header) (header-kind header) (header-subtype header))
                  '(4 1 :data 2)))))

(deftest strings-carry-their-nul
  (check (equalp (c-string "r0") #(114 48 0)))
  (check (string= (text #(114 48 0 106)) "r0"))
  (check (string= (text #(114 48)) "r0"))
  (check (string= (text #(97 255 98)) (format nil "a~cb" (code-char #xfffd))))
  (check (string= (text (c-string (format nil "sch~cn" (code-char 246)))) (format nil "sch~cn" (code-char 246)))))

(deftest answers-share-the-row-of-their-request
  (check (eq (find-message 4 :ack 1) playhouse.position2d:+req-get-geom+))
  (check (eq (find-message 999 :nack 255) playhouse.common:+req-capabilities+))
  (check (null (find-message 4 :data 99)))
  (check (null (find-message 4 77 1))))
