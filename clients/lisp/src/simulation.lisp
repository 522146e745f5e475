;;;; The simulator itself. Poses of models, by name, are relative to the parent, or to the world for a top-level model.

(in-package #:playhouse-client)

(defclass simulation (device) ()
  (:documentation "The simulator itself."))

(defparameter *ended* "the run has ended" "The server's reason to refuse a step then.")

(define-operation model-pose ((simulator simulation) name)
  "The pose of a model. Signals request-refused if there is none of that name."
  (pose-of (playhouse.simulation:pose2d-req-pose
            (request-of-model simulator name playhouse.simulation:+req-get-pose2d+
                              (playhouse.simulation:make-pose2d-req :name (c-string name))))))

(define-operation set-model-pose ((simulator simulation) name pose)
  "Moves a model. Signals request-refused if there is none of that name."
  (insist-on-pose simulator pose)
  (request-of-model simulator name playhouse.simulation:+req-set-pose2d+
                    (playhouse.simulation:make-pose2d-req :name (c-string name) :pose (wire-pose pose)))
  (values))

(define-operation model-pose3d ((simulator simulation) name)
  "As model-pose, a pose3d."
  (pose3d-of (playhouse.simulation:pose3d-req-pose
              (request-of-model simulator name playhouse.simulation:+req-get-pose3d+
                                (playhouse.simulation:make-pose3d-req :name (c-string name))))))

(define-operation set-model-pose3d ((simulator simulation) name pose)
  "As set-model-pose, to a pose3d."
  (insist-on-pose3d simulator pose)
  (request-of-model simulator name playhouse.simulation:+req-set-pose3d+
                    (playhouse.simulation:make-pose3d-req :name (c-string name) :pose (wire-pose3d pose)))
  (values))

(define-operation pause ((simulator simulation))
  "Pauses or resumes the clock."
  (command simulator playhouse.simulation:+cmd-pause+))

(define-operation save-world ((simulator simulation))
  "Saves the current world to the file of `playhouse run --save-world'; without that option it has no effect."
  (command simulator playhouse.simulation:+cmd-save+))

(define-operation reset-world ((simulator simulation) &optional seed)
  "Moves everything back to its pose in the world file, while time continues. With a seed the run restarts with that
seed: at tick 0, with the initial models and their ids, and devices have no data until new ones arrive. That requires
lock-step, else the server refuses: request-refused."
  (cond (seed (insist-on-whole simulator "seed" seed 0 (1- (ash 1 64)))
              (request-of-world simulator "reset" (little-endian seed 8))
              (forget-run (client-of simulator)))
        (t (command simulator playhouse.simulation:+cmd-reset+)))
  (values))

(define-operation join ((simulator simulation) name)
  "Joins a lock-step run as a member of this name until the connection is closed: ticks wait for its steps. Open devices
first. Signals request-refused with the reason."
  (request-of-world simulator "join" (c-string name))
  (values))

(define-operation step-world ((simulator simulation) &optional (ticks 1) (timeout :forever))
  "Runs this number of ticks and waits until they are done, in lock-step until all members have requested them: at most
TIMEOUT seconds, by default without a limit. In push mode all data of the ticks have then been delivered to the devices;
in pull mode they are queued for read-data. Without lock-step a running world refuses: PAUSE first. Signals run-ended when the
run has ended."
  (insist-on-whole simulator "ticks" ticks 1 (ash 1 20))
  (request-of-world simulator "step" (little-endian ticks 4) :timeout timeout)
  (deliver-pushed (client-of simulator))
  (values))

(define-operation spawn ((simulator simulation) like pose &optional (name ""))
  "Spawns a robot like the model LIKE at a pose in the world; returns its name."
  (insist-on-pose simulator pose)
  (insist-on-text "a name" name)
  (let ((value (concatenate 'octets
                            (little-endian-double (pose-x pose)) (little-endian-double (pose-y pose))
                            (little-endian-double (pose-a pose))
                            (if (string= name "") #() (c-string name)))))
    (text (playhouse.simulation:property-req-value (request-of-world simulator "spawn" value :name like)))))

(define-operation remove-model ((simulator simulation) name)
  "Removes a top-level model from the world, with its descendants."
  (request-of-world simulator "remove" (vector) :name name)
  (values))

(defun request-of-world (simulator property value &key (name "") timeout)
  "Sets a property of the world. The reason of a refusal is in its body."
  (let ((body (playhouse.simulation:make-property-req :name (c-string name) :prop (c-string property) :value value)))
    (handler-case (or (request simulator playhouse.simulation:+req-set-property+ body timeout) body)
      (request-refused (refusal)
        (let ((why (reason-of refusal)))
          (when (string= why *ended*)
            (fail 'run-ended "~a: ~a" (peer simulator) why))
          (fail 'request-refused "~a: ~a was refused: ~a" (peer simulator) property why))))))

(defun reason-of (refusal)
  (let ((body (refused-body refusal)))
    (if (plusp (length body))
        (text (playhouse.simulation:property-req-value (decode 'playhouse.simulation:property-req body)))
        "the server does not do that")))

(defun request-of-model (simulator name message payload)
  (handler-case (answer-or-payload simulator message payload)
    (request-refused ()
      (fail 'request-refused "~a: ~a of model ~s was refused" (peer simulator) (message-type-name message) name))))

(defun answer-or-payload (simulator message payload)
  "Answers to messages that set something have no contents."
  (if (member message (list playhouse.simulation:+req-get-pose2d+ playhouse.simulation:+req-get-pose3d+))
      (answer-of simulator message payload)
      (request simulator message payload)))

(defun little-endian (number bytes)
  (let ((octets (make-array bytes :element-type '(unsigned-byte 8))))
    (dotimes (i bytes octets)
      (setf (aref octets i) (ldb (byte 8 (* 8 i)) number)))))

(defun little-endian-double (number)
  (multiple-value-bind (high low) (bits-of-double (coerce number 'double-float))
    (concatenate 'octets (little-endian low 4) (little-endian high 4))))
