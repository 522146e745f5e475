;;;; Numbers of users: checks, and their texts in errors.

(in-package #:playhouse-client)

(defun finitep (value)
  "Whether this is a real number that a float64 can hold."
  (typecase value
    (float (null (float-kind value)))
    (rational (<= (abs value) (rational most-positive-double-float)))))

(defun number-text (value)
  "For instance 0.5, 7, nan, inf, -inf."
  (case (and (floatp value) (float-kind value))
    (:nan "nan")
    (:infinity "inf")
    (:minus-infinity "-inf")
    (t (let ((*read-default-float-format* (if (floatp value) (type-of value) 'single-float)))
         (princ-to-string value)))))

(defun seconds-text (seconds)
  "A time with six digits at most, and no zeros behind them: 5, 0.05."
  (if (and (finitep seconds) (or (zerop seconds) (<= 1/10000 (abs seconds) 999999)))
      (let* ((value (rational seconds))
             (digits (if (zerop value) 0 (max 0 (- 5 (floor (log (coerce (abs value) 'double-float) 10d0))))))
             (text (format nil "~,vf" digits (coerce value 'double-float)))
             (short (string-right-trim "." (string-right-trim "0" text))))
        (if (find (char short 0) ".") (concatenate 'string "0" short) short))
      (number-text seconds)))

(defun checked-seconds (seconds)
  "Checks a timeout: 0 or more, infinity included, or :forever."
  (unless (or (eq seconds :forever) (and (realp seconds) (without-float-traps (>= seconds 0))))
    (fail 'invalid-value "invalid time-out of ~a s: 0 or more is valid"
          (if (realp seconds) (number-text seconds) seconds)))
  seconds)

(defun deadline-after (seconds)
  "The time of the clock after this timeout, nil for one that never ends."
  (and (finitep seconds) (+ (clock) (rational seconds))))

(defun seconds-until (deadline)
  "What is left, 0 or more, of the time up to a deadline; nil without one."
  (and deadline (max 0 (- deadline (clock)))))

(defun passedp (deadline)
  (and deadline (>= (clock) deadline)))
