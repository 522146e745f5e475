;;;; The command line that the examples share: PROGRAM [HOST:PORT [INDEX [SECONDS ...]]].

(defpackage #:playhouse-client.examples
  (:use #:common-lisp)
  (:export #:*examples* #:run-example))

(in-package #:playhouse-client.examples)

(defvar *examples* '() "Name, usage and function of each example.")

(defmacro define-example (name usage (client index clock more) &body body)
  "Defines an example: BODY drives the robots, with the client, the numbers INDEX and MORE of the command line, and a
CLOCK for timep."
  `(progn
     (defun ,name (,client ,index ,clock ,more)
       (declare (ignorable ,clock ,more))
       ,@body)
     (pushnew (list ,(string-downcase name) ,usage ',name) *examples* :test #'equal)))

(defun clock-of (seconds)
  "How long the program may still run; 0 seconds means until Ctrl-C."
  (and (plusp seconds) (+ (get-internal-real-time) (* seconds internal-time-units-per-second))))

(defun timep (clock)
  "Whether there is still time."
  (or (null clock) (< (get-internal-real-time) clock)))

(defun whole (word)
  "A whole number up to 65535; nil for other words."
  (and (plusp (length word)) (every #'digit-char-p word) (<= (parse-integer word) 65535) (parse-integer word)))

(defun seconds-of (word)
  "A decimal number, 0 or more; nil for other words."
  (let ((*read-eval* nil) (*read-default-float-format* 'double-float))
    (and (plusp (length word))
         (every (lambda (letter) (find letter "0123456789.eE+-")) word)
         (handler-case (let ((number (read-from-string word)))
                         (and (realp number) (>= number 0) number))
           (error () nil)))))

(defun arguments-of (words)
  "Address, index, seconds and the list of further numbers; nil if a word is wrong."
  (destructuring-bind (&optional (address "127.0.0.1:6665") (index "0") (seconds "0") &rest more) words
    (let ((index (whole index)) (seconds (seconds-of seconds)) (more (mapcar #'whole more)))
      (and index seconds (notany #'null more) (list address index seconds more)))))

(defun run-example (name words)
  "Runs an example with the words of its command line. Returns 0 when done, 1 on an error, 2 on wrong arguments. On a
signal the process ends with 128 and its number (130 on Ctrl-C)."
  (destructuring-bind (&optional usage function) (rest (assoc name *examples* :test #'equal))
    (let ((arguments (and function (arguments-of words))))
      (cond (arguments (playhouse:with-signals (behave function arguments)))
            (t (format *error-output* "usage: ~a~%" (or usage (usage-of-all)))
               2)))))

(defun usage-of-all ()
  (format nil "~{~a~^|~} [HOST:PORT [INDEX [SECONDS ...]]]" (reverse (mapcar #'first *examples*))))

(defun behave (function arguments)
  (destructuring-bind (address index seconds more) arguments
    (handler-case (playhouse:with-client (client address)
                    (playhouse:without-float-traps (funcall function client index (clock-of seconds) more))
                    0)
      (playhouse:player-error (problem)
        (format *error-output* "~a~%" problem)
        1))))
