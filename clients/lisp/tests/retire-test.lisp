;;;; What a program sees of devices that the real server retires. PLAYHOUSE_RETIRING_SERVER is the program of
;;;; clients/tests/retiring_server.cc; without it the tests that need it say so.

(in-package #:playhouse-client.tests)

(defparameter *long* 30 "Seconds: an answer is not waited for: it comes, or something hangs.")

(defun call-with-retiring-server (program function)
  "Calls FUNCTION with the address of the server and a function that gives it commands."
  (let* ((process (sb-ext:run-program program '() :input :stream :output :stream :wait nil))
         (input (sb-ext:process-input process)) (output (sb-ext:process-output process)))
    (unwind-protect
         (funcall function (read-line output)
                  (lambda (&rest lines)
                    (dolist (line lines)
                      (write-line line input)
                      (finish-output input)
                      (check (equal (read-line output) "done")))))
      (close input)
      (sb-ext:process-wait process)
      (sb-ext:process-close process))))

(defmacro with-retiring-server ((client do mode) &body body)
  "Runs BODY with a client of a server with position2d:0 and :3 that takes the commands of the function DO."
  `(let ((program (sb-ext:posix-getenv "PLAYHOUSE_RETIRING_SERVER")))
     (if (plusp (length program))
         (call-with-retiring-server
          program
          (lambda (address ,do)
            (funcall ,do "add 0" "add 3")
            (with-client (,client address :mode ,mode :timeout *long*)
              ,@body)))
         (format t "not run, as PLAYHOUSE_RETIRING_SERVER names no program:~%"))))

(deftest a-retired-device-gives-its-last-data-and-fails-at-once-from-then-on
  (dolist (mode '(:push :pull))
    (with-retiring-server (client do mode)
      (let ((gone (open-device client :position2d 3)) (other (open-device client :position2d 0)))
        (funcall do "publish 3 1" "retire 3" "publish 0 2")
        (loop until (and (device-gone-p gone) (device-has-data-p other)) do (read-data client))
        (check (= (pose-x (pose gone)) 1))
        (next-data gone)                  ; its last
        (dolist (use (list (lambda () (drive gone 1)) (lambda () (geometry gone)) (lambda () (next-data gone))))
          (check-error device-gone ":position2d:3 is gone: the server retired it" (funcall use)))
        (close-device gone)
        (check (not (device-open-p gone)))
        (check (geometry other))))))

(deftest next-data-of-a-retired-device-does-not-wait
  (dolist (mode '(:push :pull))
    (with-retiring-server (client do mode)
      (let ((gone (open-device client :position2d 3)))
        (funcall do "retire 3")
        (check-error device-gone "is gone" (next-data gone))
        (check (connectedp client))))))

(deftest a-retired-device-leaves-its-address-to-another-and-does-not-become-it
  (dolist (mode '(:push :pull))
    (with-retiring-server (client do mode)
      (let ((gone (open-device client :position2d 3)))
        (funcall do "publish 3 1" "retire 3" "add 3")
        (let ((following (open-device client :position2d 3)))
          (check (device-gone-p gone))
          (funcall do "publish 3 2")
          (loop until (device-has-data-p following) do (read-data client))
          (check (= (pose-x (pose following)) 2))
          (check (not (device-gone-p following)))
          (check (not (and (device-has-data-p gone) (= (pose-x (pose gone)) 2))))
          (close-device gone)
          (check (geometry following)))))))

(deftest a-request-before-the-client-is-told-is-refused
  (with-retiring-server (client do :pull)
    (let ((gone (open-device client :position2d 3)))
      (funcall do "retire 3")
      (check-error request-refused "was refused" (geometry gone))
      (read-data client)
      (check-error device-gone "is gone" (geometry gone)))))

(deftest a-notice-of-a-server-of-a-few-lines-retires-a-device
  (flet ((notice (peer)
           (message-bytes 1 0 :ack 3 (encode (playhouse.player:make-device-req
                                              :addr (playhouse.common:make-devaddr :robot 7 :interf 4 :index 0)
                                              :access (char-code #\e)))
                          :sequence (peer-port peer))))
    (with-connection (client (rounds (peer header)
                               (answer peer header)
                               (put-state peer 1d0)
                               (put peer (notice peer))
                               (put-synch peer)))
      (let ((robot (open-device client :position2d)))
        (drive robot 0.1)
        (check (= (read-data client) 1))
        (check (device-gone-p robot))
        (check (= (pose-x (pose robot)) 1))
        (check-error device-gone "7:position2d:0 is gone: the server retired it" (drive robot 0.2))
        (close-device robot)              ; sends nothing: no stop, no closing
        (check (equalp (driven peer) '(0.10000000149011612d0)))))))
