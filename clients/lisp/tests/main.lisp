;;;; One executable with all programs: which one it is, its name tells. clients/CMakeLists.txt says what they do.

(in-package #:playhouse-client.tests)

(defparameter *programs*
  `(("scenarios" . play-scenario) ("dump" . dump) ("robots" . use-robots)
    ("tests" . ,(lambda (words) (if (run-tests words) 0 1))))
  "Programs by name, besides the examples: functions of the words of the command line that return an exit code.")

(defun main ()
  (destructuring-bind (path &rest words) sb-ext:*posix-argv*
    (let* ((name (subseq path (1+ (or (position #\/ path :from-end t) -1))))
           (program (cdr (assoc name *programs* :test #'string=)))
           (code (handler-case (if program (funcall program words) (run-example name words))
                   (error (problem)
                     (format *error-output* "~a~%" problem)
                     1))))
      (finish-output)
      (finish-output *error-output*)
      (sb-ext:exit :code code :abort t))))
