;;;; A robot by its name in the world file, with its devices and those of its descendants.

(in-package #:playhouse-client)

(defclass robot ()
  ((client :initarg :client :reader client-of)
   (models :initarg :models :reader robot-models :documentation "The model itself and its descendants.")
   (port :initarg :port :reader port-of :documentation "Of the connected server, as reported by the server.")
   (opened :initform '() :accessor opened-of
           :documentation "Key of the address, and device, of what was opened here, the newest first."))
  (:documentation "A model and its descendants, returned by find-robot and list-robots. Devices are opened on first use;
with-robot and close-robot close those, and a moving robot is stopped first."))

(defmethod print-object ((robot robot) stream)
  (print-unreadable-object (robot stream :type t)
    (format stream "~s: ~a" (robot-name robot) (names-of (robot-devices robot)))))

(defun robot-name (robot)
  "The name in the world file."
  (model-name (first (robot-models robot))))

(defun robot-type (robot)
  "The type of model, as in the world file."
  (model-type (first (robot-models robot))))

(defun robot-devices (robot)
  "The addresses of all devices of the models, a list of device-address."
  (devices-of (robot-models robot)))

(defun robot-device (robot interface &optional (nth 0))
  "The robot's device of an interface, such as :laser, at index NTH, from 0. It is opened on first use. Signals
request-refused if there is none."
  (let* ((interface (interface-word interface)) (here (reachable robot interface)))
    (unless (and (integerp nth) (< -1 nth (length here)))
      (fail 'request-refused "robot ~s has no ~a~@[ number ~d~] ~a" (robot-name robot) interface
            (and (not (eql nth 0)) nth) (elsewhere robot interface)))
    (open-of-robot robot (nth nth here))))

(defun robot-all (robot interface)
  "All the robot's devices of an interface, such as :laser, a list; they are opened on first use."
  (loop for address in (reachable robot (interface-word interface)) collect (open-of-robot robot address)))

(defun close-robot (robot)
  "Closes devices opened here, in reverse order of opening. They reopen on use."
  (loop while (opened-of robot)
        do (close-device (cdr (pop (opened-of robot))))))

(defmacro with-robot ((variable client name) &body body)
  "Binds VARIABLE to the robot of this name while BODY runs, and closes the devices that it opened, however BODY ends."
  `(call-with-closing (find-robot ,client ,name) #'close-robot (lambda (,variable) ,@body)))

(defun devices-of (models)
  (mapcan (lambda (model) (copy-list (model-devices model))) models))

(defun reachable (robot interface)
  "A connection reaches the devices of its own port only."
  (remove-if-not (lambda (at)
                   (and (string= (device-address-interface at) interface) (= (device-address-port at) (port-of robot))))
                 (robot-devices robot)))

(defun elsewhere (robot interface)
  "Text: other ports with devices of this interface, or else the existing devices."
  (let ((others (loop for at in (robot-devices robot)
                      when (and (string= (device-address-interface at) interface)
                                (/= (device-address-port at) (port-of robot)))
                        collect (format nil "~a at port ~d" (device-address-name at) (device-address-port at)))))
    (if others
        (format nil "at port ~d, but ~{~a~^, ~}: connect there" (port-of robot) others)
        (format nil "(it has ~:[no devices~;~:*~a~])" (and (robot-devices robot) (names-of (robot-devices robot)))))))

(defun open-of-robot (robot address)
  (let* ((key (address-key address)) (device (cdr (assoc key (opened-of robot) :test #'equal))))
    (if (and device (device-open-p device))
        device
        (let ((opened (open-device (client-of robot) (device-address-interface address)
                                   (device-address-index address))))
          (setf (opened-of robot) (acons key opened (remove key (opened-of robot) :key #'car :test #'equal)))
          opened))))

(defun names-of (addresses)
  (format nil "~{~a~^, ~}" (mapcar #'device-address-name addresses)))
