;;;; Tests of a few lines each, without another library: deftest, check and check-error.

(defpackage #:playhouse-client.tests
  (:use #:common-lisp #:playhouse-client #:playhouse-client.examples #:playhouse.wire)
  (:import-from #:playhouse.base #:octets)
  (:import-from #:playhouse-client #:finitep)
  (:export #:run-tests #:main))

(in-package #:playhouse-client.tests)

(defconstant +infinity+ sb-ext:double-float-positive-infinity)
(defparameter *nan* (sb-kernel:make-double-float #x7ff80000 0))

(defvar *tests* '() "Name and function of all tests, the newest first.")
(defvar *faults* '() "What is wrong in the running test.")

(defmacro deftest (name &body body)
  "Defines a test; its name is a sentence. An error that leaves BODY is a fault as well."
  `(progn
     (setf *tests* (acons ',name (lambda () ,@body) (remove ',name *tests* :key #'car)))
     ',name))

(defun fault (control &rest arguments)
  (push (apply #'format nil control arguments) *faults*))

(defmacro check (form)
  "Checks that FORM is true. Of a comparison the fault shows both sides."
  (if (and (consp form) (member (first form) '(= eql equal equalp)) (= (length form) 3))
      `(let ((one ,(second form)) (other ,(third form)))
         (unless (,(first form) one other)
           (fault "~s: ~s and ~s" ',form one other)))
      `(unless ,form (fault "not true: ~s" ',form))))

(defmacro check-error (type text &body body)
  "Checks that BODY signals an error of TYPE whose report contains TEXT."
  `(handler-case (progn ,@body (fault "no error of ~s" ',body))
     (,type (problem)
       (unless (search ,text (princ-to-string problem))
         (fault "~s is not about ~s" (princ-to-string problem) ,text)))))

(defun run-test (name function)
  "Whether the test passes; prints its faults."
  (let ((*faults* '()))
    (handler-case (funcall function)
      (error (problem) (fault "~s: ~a" (type-of problem) problem)))
    (format t "~:[FAILED~;ok    ~] ~(~a~)~%" (null *faults*) (substitute #\Space #\- (symbol-name name)))
    (dolist (fault (reverse *faults*))
      (format t "    ~a~%" fault))
    (finish-output)
    (null *faults*)))

(defun run-tests (&optional words)
  "Runs all tests, or those whose name contains one of the WORDS; returns whether all passed."
  (let* ((chosen (loop for (name . function) in (reverse *tests*)
                       when (or (null words)
                                (some (lambda (word) (search word (symbol-name name) :test #'char-equal)) words))
                         collect (cons name function)))
         (failed (loop for (name . function) in chosen count (not (run-test name function)))))
    (format t "~d tests, ~d failed~%" (length chosen) failed)
    (and (plusp (length chosen)) (zerop failed))))
