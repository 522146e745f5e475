;;;; The simulator's list of models and their devices: lines of text in a property of the simulation interface.

(in-package #:playhouse-client)

(defstruct device-address
  "Address of a device: port of its server, interface and index, with the full name of its model."
  port interface index model)

(defstruct model
  "One model of the world: full name, type (\"position\", independent of macros), name of its parent (empty for a
top-level model), own devices, and id, which is unique in the run."
  name type parent devices id)

(defun device-address-name (address)
  "INTERFACE:INDEX, for instance position2d:12."
  (format nil "~a:~d" (device-address-interface address) (device-address-index address)))

(defun address-key (address)
  "The address as a list, for comparisons by equal."
  (list (device-address-port address) (device-address-interface address) (device-address-index address)
        (device-address-model address)))

(defun ask-models (simulator)
  "All models of a simulation device's world. Signals request-refused if the simulator does not report them."
  (loop with index = 0
        for question = (playhouse.simulation:make-property-req :name (c-string "") :prop (c-string "models")
                                                               :index index)
        for answer = (or (request simulator playhouse.simulation:+req-get-property+ question) question)
        for next = (playhouse.simulation:property-req-index answer)
        append (parse-models (text (playhouse.simulation:property-req-value answer)))
        until (zerop next)
        do (unless (> next index)
             (fail 'wire-error "the list of models goes on at ~d after ~d" next index))
           (setf index next)))

(defun parse-models (lines)
  "The models of one answer, one per line: id, name, type, parent and devices, separated by TABs. Signals wire-error."
  (loop for line in (split lines #\Newline)
        unless (string= line "") collect (parse-model line)))

(defun families (models)
  "For each model, in order: itself and all its descendants, in the order of the list."
  (let ((members (make-hash-table :test #'eq)) (parents (make-hash-table :test #'eq))
        (places (make-hash-table :test #'equal))) ; of equal names the last one so far
    (dolist (model models)                        ; parents come before children
      (let ((parent (gethash (model-parent model) places)))
        (setf (gethash model parents) parent
              (gethash (model-name model) places) model
              (gethash model members) (list model))
        (loop for above = parent then (gethash above parents)
              while above
              do (push model (gethash above members)))))
    (loop for model in models collect (reverse (gethash model members)))))

(defun parse-model (line)
  (let ((fields (split line #\Tab)))
    (unless (= (length fields) 5)
      (fail 'wire-error "a line of the list of models has ~d fields instead of 5: ~s" (length fields) line))
    (destructuring-bind (id name type parent devices) fields
      (unless (digits-p id)
        (fail 'wire-error "~s in the list of models is not an id" id))
      (let ((name (unescaped name)))
        (make-model :name name :type (unescaped type) :parent (unescaped parent) :id (parse-integer id)
                    :devices (loop for word in (split devices #\Space)
                                   unless (string= word "") collect (parse-device word name)))))))

(defun parse-device (word model)
  (destructuring-bind (&optional (port "") (interface "") (index "") &rest more) (split word #\:)
    (unless (and (digits-p port) (digits-p index) (null more))
      (fail 'wire-error "~s in the list of models is not PORT:INTERFACE:INDEX" word))
    (make-device-address :port (parse-integer port) :interface interface :index (parse-integer index) :model model)))

(defun split (text separator)
  (loop for start = 0 then (1+ end)
        for end = (position separator text :start start)
        collect (subseq text start end)
        while end))

(defun digits-p (word)
  (and (plusp (length word)) (every (lambda (letter) (find letter "0123456789")) word)))

(defun unescaped (field)
  "A backslash, a TAB and a newline are sent as \\\\, \\t and \\n."
  (with-output-to-string (out)
    (loop with at = 0
          while (< at (length field))
          do (let ((letter (char field at)) (next (and (< (1+ at) (length field)) (char field (1+ at)))))
               (cond ((and (char= letter #\\) (find next "\\tn"))
                      (write-char (ecase next (#\\ #\\) (#\t #\Tab) (#\n #\Newline)) out)
                      (incf at 2))
                     (t (write-char letter out)
                        (incf at)))))))
