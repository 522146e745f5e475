;;;; Runs an example in place: sbcl --script clients/lisp/examples/run.lisp NAME [HOST:PORT [INDEX [SECONDS ...]]]

(require :asdf)

(let ((*standard-output* (make-broadcast-stream)) (*error-output* (make-broadcast-stream)))
  (asdf:register-immutable-system "asdf") ; it would compile Debian's copy of itself
  (asdf:load-asd (merge-pathnames "../playhouse-client.asd" *load-truename*))
  (asdf:load-system "playhouse-client/examples"))

(let* ((words (rest sb-ext:*posix-argv*))
       ;; Some versions of SBCL leave its own options among the words.
       (words (if (equal (first words) "--script") (cddr words) words))
       (code (uiop:symbol-call '#:playhouse-client.examples '#:run-example (first words) (rest words))))
  (finish-output)
  (sb-ext:exit :code code :abort t))
