;;;; sbcl --script build.lisp FOLDER PROGRAM: compiles everything into FOLDER and makes an executable of it that is the
;;;; examples and the test programs, by the name it is called by. A warning, also one about style, fails the build.

(require :asdf)

(defparameter *words*
  (let ((words (rest sb-ext:*posix-argv*)))
    ;; Some versions of SBCL leave its own options among the words.
    (if (equal (first words) "--script") (cddr words) words)))

(defun refuse (problem)
  (format *error-output* "~&build.lisp: ~a~%" problem)
  (finish-output *error-output*)
  (sb-ext:exit :code 1 :abort t))

(defun load-quietly (system)
  (let ((*standard-output* (make-broadcast-stream)))
    (asdf:load-system system)))

(asdf:register-immutable-system "asdf") ; it would compile Debian's copy of itself
(asdf:initialize-output-translations
 `(:output-translations (t (,(namestring (uiop:ensure-directory-pathname (first *words*))) :implementation))
                        :ignore-inherited-configuration))

(handler-bind ((error #'refuse))
  (asdf:load-asd (merge-pathnames "playhouse-client.asd" *load-truename*))
  (let ((*error-output* (make-broadcast-stream)))
    (load-quietly "chipz"))
  (handler-bind ((sb-kernel:redefinition-warning #'muffle-warning) ; a macro, once compiled and once loaded
                 (warning #'refuse))
    (load-quietly "playhouse-client/tests")))

(sb-ext:disable-debugger) ; in the executable, too
(sb-ext:save-lisp-and-die (second *words*) :executable t :save-runtime-options t
                                           :toplevel (intern "MAIN" '#:playhouse-client.tests))
