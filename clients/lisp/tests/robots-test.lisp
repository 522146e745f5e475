;;;; Robots by name, from a server of a few lines that lists its models; and suggestions for names.

(in-package #:playhouse-client.tests)

(defparameter *house*
  '("0	r0	position		PORT:position2d:0"
    "1	r0.ranger:0	ranger	r0	PORT:ranger:0 PORT:sonar:0"
    "2	wall	model		"
    "3	guest	position		PORT:position2d:12"
    "4	guest.ranger:0	ranger	guest	PORT:ranger:20 PORT:laser:12"
    "5	guest.arm	model	guest	"
    "6	guest.arm.eye	fiducial	guest.arm	PORT:fiducial:3"
    "7	guest.ranger:1	ranger	guest	PORT:ranger:21 PORT:laser:30"
    "8	next	position		9999:position2d:0")
  "Lines of a list of models; PORT is that of the server.")

(defun lines-of (lines port)
  "The text of lines, each with a newline, as a string field."
  (let ((text (format nil "~{~a~%~}" lines)) (port (princ-to-string port)))
    (c-string (loop for at = (search "PORT" text)
                    while at
                    do (setf text (concatenate 'string (subseq text 0 at) port (subseq text (+ at 4))))
                    finally (return text)))))

(defun models-answer (lines port next)
  (encode (playhouse.simulation:make-property-req :name #(0) :prop (c-string "models") :index next
                                                  :value (lines-of lines port))))

(defun page-script (pages)
  "Answers questions for models from an index; PAGES are lists of that index, the index that follows, and lines."
  (rounds (peer header body)
    (if (= (header-interface header) 31)
        (destructuring-bind (next lines)
            (rest (assoc (playhouse.simulation:property-req-index (decode 'playhouse.simulation:property-req body))
                         pages))
          (answer peer header :body (models-answer lines (peer-port peer) next)))
        (answer peer header :kind :nack))))

(defparameter *house-script*
  (page-script `((0 3 ,(subseq *house* 0 3)) (3 6 ,(subseq *house* 3 6)) (6 0 ,(subseq *house* 6)))))

(defun opened (peer)
  "Codes and indices of devices that were opened, and negative ones of those closed, simulation aside."
  (loop for (header . body) in (received-of peer)
        when (and (= (header-interface header) 1) (= (header-subtype header) 3))
          append (let* ((request (decode 'playhouse.player:device-req body))
                        (address (playhouse.player:device-req-addr request))
                        (sign (if (= (playhouse.player:device-req-access request) playhouse.player:+close-mode+) -1 1)))
                   (unless (= (playhouse.common:devaddr-interf address) 31)
                     (list (list (* sign (playhouse.common:devaddr-interf address))
                                 (playhouse.common:devaddr-index address)))))))

(deftest a-line-is-a-model-with-its-devices
  (let ((model (first (playhouse-client::parse-models
                       (format nil "4~ca\\tb\\\\n\\n~cranger~cr 0~c6665:ranger:1 1:laser:2~%"
                               #\Tab #\Tab #\Tab #\Tab)))))
    (check (string= (model-name model) (format nil "a~cb\\n~%" #\Tab)))
    (check (equal (list (model-id model) (model-type model) (model-parent model)) '(4 "ranger" "r 0")))
    (check (equal (mapcar #'playhouse-client::address-key (model-devices model))
                  (list (list 6665 "ranger" 1 (model-name model)) (list 1 "laser" 2 (model-name model)))))))

(deftest lines-that-make-no-sense-are-an-error
  (dolist (fields '(("x") ("x" "a" "b" "c" "") ("0" "a" "b" "c" "d" "e") ("0" "a" "b" "c" "laser:0")
                    ("0" "a" "b" "c" "1:laser:") ("0" "a" "b" "c" "1:laser:2:3")))
    (check-error wire-error "list of models"
      (playhouse-client::parse-models (format nil (format nil "~~{~~a~~^~c~~}~~%" #\Tab) fields)))))

(deftest a-robot-has-the-devices-of-all-it-carries
  (with-connection (client *house-script*)
    (let ((guest (find-robot client "guest")))
      (check (equal (mapcar #'device-address-name (robot-devices guest))
                    '("position2d:12" "ranger:20" "laser:12" "fiducial:3" "ranger:21" "laser:30")))
      (check (string= (robot-name guest) "guest"))
      (check (equal (mapcar #'model-name (robot-models guest))
                    '("guest" "guest.ranger:0" "guest.arm" "guest.arm.eye" "guest.ranger:1")))
      (check (string= (device-name (robot-device guest :position2d)) "position2d:12"))
      (check (string= (device-name (robot-device guest :laser)) "laser:12"))
      (check (equal (mapcar #'device-name (robot-all guest :ranger)) '("ranger:20" "ranger:21")))
      (check (null (robot-all guest :sonar)))
      (check (eq (robot-device guest :ranger 1) (second (robot-all guest :ranger)))))))

(deftest robots-are-the-models-at-the-top-with-devices-here
  (with-connection (client *house-script*)
    (check (equal (mapcar #'robot-name (list-robots client)) '("r0" "guest")))
    (check (string= (robot-type (second (list-robots client))) "position"))
    (check (eq (second (list-robots client)) (find-robot client "guest")))))

(deftest the-last-of-equal-names-is-meant
  (with-connection (client (page-script '((0 0 ("0	r	position		PORT:position2d:0"
                                                "1	r.l	ranger	r	PORT:laser:0"
                                                "2	r	position		PORT:position2d:1")))))
    (check (equal (mapcar #'device-address-name (robot-devices (find-robot client "r"))) '("position2d:1")))))

(deftest names-that-differ-in-case-are-different-robots
  (with-connection (client (page-script '((0 0 ("0	r	position		" "1	R	position		")))))
    (check (not (eq (find-robot client "r") (find-robot client "R"))))
    (check (string= (robot-name (find-robot client "R")) "R"))))

(defun listed-addresses (port)
  (loop for (code index) in '((31 0) (4 12) (62 20) (6 77))
        collect (playhouse.common:make-devaddr :robot port :interf code :index index)))

(deftest devices-are-listed-with-their-models
  (with-connection (client (rounds (peer header)
                             (cond ((= (header-interface header) 31)
                                    (answer peer header :body (models-answer *house* (peer-port peer) 0)))
                                   ((= (header-subtype header) (message-type-subtype playhouse.player:+req-devlist+))
                                    (answer peer header
                                            :body (encode (playhouse.player:make-device-devlist
                                                           :devices (listed-addresses (peer-port peer))))))
                                   (t (answer peer header :kind :nack)))))
    (check (equal (loop for entry in (list-devices client)
                        collect (list (device-entry-name entry) (device-entry-model entry) (device-entry-robot entry)))
                  '(("simulation:0" "" "") ("position2d:12" "guest" "guest") ("ranger:20" "guest.ranger:0" "guest")
                    ("laser:77" "" ""))))))

(deftest devices-are-opened-once-and-the-models-asked-for-once
  (with-server (peer address *house-script*)
    (with-client (client address)
      (dotimes (i 3)
        (stop (robot-device (find-robot client "guest") :position2d)))
      (check (eq (robot-device (find-robot client "guest") :laser)
                 (first (robot-all (find-robot client "guest") :laser))))
      (find-robot client "r0"))
    (check (equal (opened peer) '((4 12) (6 12) (6 30) (-6 30) (-6 12) (-4 12))))
    (check (= (count 31 (received-of peer) :key (lambda (message) (header-interface (car message)))) 3))))

(deftest a-robot-that-came-later-is-found
  (let* ((first-line "0	r0	position		PORT:position2d:0") (second-line "1	r1	position		PORT:position2d:1")
         (lists (list (list first-line) (list first-line second-line))))
    (with-connection (client (rounds (peer header)
                               (answer peer header :body (models-answer (if (rest lists) (pop lists) (first lists))
                                                                        (peer-port peer) 0))))
      (let ((found (find-robot client "r0")))
        (check (string= (device-address-name (first (robot-devices (find-robot client "r1")))) "position2d:1"))
        (check (eq (find-robot client "r0") found))
        (check (equal (mapcar #'model-name (list-models client)) '("r0" "r1")))))))

(deftest leaving-with-robot-stops-and-closes-it-and-it-opens-again
  (with-connection (client *house-script*)
    (let ((base nil))
      (with-robot (guest client "guest")
        (setf base (robot-device guest :position2d))
        (drive base 0.1))
      (check (not (device-open-p base)))
      (check (equal (mapcar (lambda (message) (header-kind (car message))) (last (received-of peer) 3))
                    '(:cmd :cmd :req)))
      (check (device-open-p (robot-device (find-robot client "guest") :position2d))))))

(deftest a-name-that-is-not-there-gets-the-nearest-one
  (with-connection (client *house-script*)
    (check-error request-refused (format nil "there is no robot \"gest\" at ~a (did you mean \"guest\"?)" address)
      (find-robot client "gest"))
    (check (string= (handler-case (find-robot client "xyzzy")
                      (request-refused (problem) (princ-to-string problem)))
                    (format nil "there is no robot \"xyzzy\" at ~a" address)))))

(deftest a-device-that-a-robot-lacks-is-told-with-what-it-has
  (with-connection (client *house-script*)
    (check-error request-refused "robot \"r0\" has no laser (it has position2d:0, ranger:0, sonar:0)"
      (robot-device (find-robot client "r0") :laser))
    (check-error request-refused "robot \"r0\" has no sonar number 1 (it has"
      (robot-device (find-robot client "r0") :sonar 1))
    (check-error request-refused "robot \"wall\" has no laser (it has no devices)"
      (robot-device (find-robot client "wall") :laser))
    (check-error request-refused
        (format nil "robot \"next\" has no position2d at port ~d, but position2d:0 at port 9999: connect there"
                (peer-port peer))
      (robot-device (find-robot client "next") :position2d))))

(deftest a-server-that-does-not-list-models-is-told
  (with-connection (client *refusing*)
    (dolist (ask (list #'list-robots #'list-models (lambda (client) (find-robot client "r0"))))
      (check-error request-refused "this server does not tell the names of models; open devices by number"
        (funcall ask client)))))

(deftest a-list-that-goes-round-in-circles-is-an-error
  (let ((lines '("0	r0	position		")))
    (with-connection (client (page-script `((0 1 ,lines) (1 1 ,lines))))
      (check-error wire-error "the list of models goes on at 1 after 1" (list-robots client)))))
