;;;; The programs of README.md do what it says.

(in-package #:playhouse-client.tests)

(defun blocks-of (file)
  "The Lisp of a Markdown file, a string for each block."
  (with-open-file (stream file :external-format :utf-8)
    (loop with block = nil
          for line = (read-line stream nil)
          while line
          if (string= line "```lisp") do (setf block "")
          else if (and block (string= line "```")) collect (shiftf block nil)
          else if block do (setf block (format nil "~a~a~%" block line)))))

(defparameter *blocks* (blocks-of (asdf:system-relative-pathname "playhouse-client" "README.md"))
  "Read as this file is loaded: an executable of it has them.")

(defun replaced (old new text)
  (let ((at (search old text)))
    (assert at () "~s is not in README.md" old)
    (concatenate 'string (subseq text 0 at) new (subseq text (+ at (length old))))))

(defun run-block (text)
  (let ((*package* (find-package '#:common-lisp-user)))
    (eval (read-from-string text))))

(defun put-scan (peer range)
  (put-data peer playhouse.laser:+data-scan+
            (playhouse.laser:make-data :ranges (list range range) :min-angle -0.1 :max-angle 0.1 :max-range 8)))

(deftest the-robot-in-ten-lines-drives-and-turns
  (let ((ranges '(2 0.5)))
    (with-server (peer address (rounds (peer header)
                                 (when (data-request-p header)
                                   (answer peer header)
                                   (unless ranges (finish peer))
                                   (put-scan peer (pop ranges))
                                   (put-synch peer))))
      (check-error run-ended "the run ended" (run-block (replaced "127.0.0.1:6665" address (first *blocks*))))
      (check (equalp (driven peer) '(0.30000001192092896d0 0d0))))))

(deftest a-robot-by-its-name-says-where-it-is
  (with-server (peer address (rounds (peer header)
                               (cond ((data-request-p header)
                                      (answer peer header)
                                      (put-state peer 1.5d0 :index 12)
                                      (put-data peer playhouse.laser:+data-scan+
                                                (playhouse.laser:make-data :max-range 8) :index 12)
                                      (put-synch peer))
                                     (t (answer peer header :body (models-answer *house* (peer-port peer) 0))))))
    (let ((said (with-output-to-string (*standard-output*)
                  (run-block (replaced "127.0.0.1:6665" address (second *blocks*))))))
      (check (search "1.5d0" said))
      (check (search "8.0" said)))))

(deftest a-gripper-is-used-without-a-proxy
  (with-server (peer address (rounds (peer header)
                               (cond ((data-request-p header)
                                      (answer peer header)
                                      (put-data peer playhouse.gripper:+data-state+
                                                (playhouse.gripper:make-data :state 2))
                                      (put-synch peer))
                                     ((eq (header-kind header) :req)
                                      (answer peer header :body (encode (playhouse.gripper:make-geom)))))))
    (let ((data (run-block (format nil "(playhouse:with-client (client ~s) ~a)" address (third *blocks*)))))
      (check (= (playhouse.gripper:data-state data) 2))
      (check (= (length (sent-to peer playhouse.gripper:+code+ :cmd)) 1)))))

(deftest a-program-with-signals-drives
  (let ((positions '(1d0)))
    (with-server (peer address (rounds (peer header)
                                 (when (data-request-p header)
                                   (answer peer header)
                                   (unless positions (finish peer))
                                   (put-state peer (pop positions))
                                   (put-synch peer))))
      (check-error run-ended "the run ended" (run-block (replaced "127.0.0.1:6665" address (fourth *blocks*))))
      (check (equalp (driven peer) '(0.30000001192092896d0))))))
