;;;; What a program does on signals.

(in-package #:playhouse-client.tests)

(defun signals-of-programs ()
  (mapcar #'first (playhouse.base::caught-signals)))

(defun send-signal (number)
  "Sends this process a signal, and waits for what comes of it."
  (sb-unix:unix-kill (sb-unix:unix-getpid) number)
  (sb-thread:wait-on-semaphore (sb-thread:make-semaphore) :timeout 60) ; until the signal
  (error "signal ~d has not arrived" number))

(deftest a-signal-stops-the-robot-and-is-the-exit-code
  (dolist (number (signals-of-programs))
    (with-server (peer address *listening*)
      (check (eql (playhouse.base:call-with-signals
                   (lambda ()
                     (with-signals      ; of the two the outer one ends the program
                       (with-client (client address)
                         (with-device (robot client :position2d)
                           (drive robot 0.5)
                           (send-signal number)))))
                   (lambda (code) code))
                  (+ 128 number)))
      (check (equalp (driven peer) '(0.5d0 0d0)))
      (check (= (last-access peer) playhouse.player:+close-mode+)))))

(deftest without-a-signal-the-values-are-those-of-the-body
  (check (equal (multiple-value-list (with-signals (values 1 2))) '(1 2)))
  (check-error error "something else" (with-signals (error "something else")))
  (when (member sb-unix:sighup (signals-of-programs)) ; SIGHUP is as before
    (check (not (playhouse.base::ignored-p sb-unix:sighup)))))

