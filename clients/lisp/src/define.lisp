;;;; The macros of the generated files: codes and constants, structures with their encoding, and the table of messages.

(in-package #:playhouse.wire)

;;; Interfaces

(defvar *interfaces* '() "Code and name of each interface.")

(defun interface-name (code)
  "The name of an interface, nil for an unknown code."
  (second (assoc code *interfaces*)))

(defun interface-code (name)
  "The code of an interface, nil for an unknown name."
  (first (find name *interfaces* :key #'second :test #'string=)))

(defun interface-names ()
  (mapcar #'second *interfaces*))

(defmacro define-interface (constant code name)
  `(progn (defconstant ,constant ,code)
          (pushnew (list ,code ,name) *interfaces* :test #'equal)))

(defmacro define-constants (&rest rows)
  `(progn ,@(loop for (name value) in rows collect `(defconstant ,name ,value))))

;;; Structures

(defstruct wire-struct
  "Base of the values of all interfaces; slots are in wire order.")

(defstruct field
  "A field of a structure: its name in Player's headers, its type as declared, and the function that gives its value."
  name type accessor)

(defstruct codec
  "How values of one structure are read and written."
  name reader writer fields)

(defun codec-of (name)
  (or (get name 'codec) (error "~s is not a structure of an interface" name)))

(defun encode (value)
  "The bytes of a structure. Signals wire-error if a value is outside the range of its field."
  (let ((writer (make-writer)))
    (funcall (codec-writer (codec-of (type-of value))) writer value)
    (written writer)))

(defun decode (name octets)
  "The structure of this name that the bytes encode; bytes after its end are ignored. Signals wire-error."
  (let ((codec (codec-of name)))
    (handler-case (values (funcall (codec-reader codec) (make-reader (coerce octets 'octets))))
      (wire-error (fault) (fail 'wire-error "~a: ~a" (codec-name codec) fault)))))

(defun struct-fields (name)
  "The fields of a structure, in the order of its definition."
  (codec-fields (codec-of name)))

(defun field-value (field value)
  (funcall (field-accessor field) value))

(eval-when (:compile-toplevel :load-toplevel :execute)
  (defun symbol-of (control &rest arguments)
    "A symbol of the current package."
    (intern (apply #'format nil control arguments)))

  (defun name-of (control struct)
    "A symbol of the package of STRUCT."
    (intern (format nil control struct) (symbol-package struct)))

  (defun shape-of (type)
    "What a declared type is: :one, :array, :bounded or :counted; of which element; and its limit and element size."
    (if (consp type)
        (destructuring-bind (shape element limit &optional least) type
          (values shape element limit least))
        (values :one type)))

  (defun opaque-p (element)
    "Arrays of these are raw bytes on the wire and byte vectors in Lisp."
    (member element '(:char :int8 :uint8)))

  (defun scalar-function (verb element &optional (plural ""))
    "For instance read-float32s. A char is an int8."
    (intern (format nil "~a-~a~a" verb (if (eq element :char) :int8 element) plural) '#:playhouse.wire))

  (defun least-bytes (element least)
    (cond ((opaque-p element) 1)
          ((member element '(:int64 :float64)) 8)
          ((keywordp element) 4)
          (t least)))

  (defun slot-type (type)
    (multiple-value-bind (shape element) (shape-of type)
      (cond ((not (eq shape :one)) 'sequence)
            ((member element '(:float32 :float64)) 'real)
            ((keywordp element) 'integer)
            (t element))))

  (defun zero-of (element)
    (case element (:float32 0f0) (:float64 0d0) (t 0)))

  (defun slot-default (type)
    (multiple-value-bind (shape element limit) (shape-of type)
      (cond ((eq shape :one) (if (keywordp element) (zero-of element) `(,(name-of "MAKE-~a" element))))
            ((opaque-p element) '(make-array 0 :element-type '(unsigned-byte 8)))
            ((eq shape :array) `(make-array ,limit :initial-element ,(zero-of element)))
            (t '(vector)))))

  (defun steps (fields)
    "The wire order: (:count FIELD) and (:value FIELD); a list with a count has both."
    (flet ((count-place (field)
             (destructuring-bind (slot name type &key (count-before slot)) field
               (declare (ignore name))
               (and (member (shape-of type) '(:bounded :counted)) count-before))))
      (loop for field in fields
            append (loop for other in fields
                         when (eq (count-place other) (first field)) collect (list :count other))
            collect (list :value field))))

  (defun read-elements (element count)
    (cond ((opaque-p element) `(read-octets reader ,count))
          ((keywordp element) `(,(scalar-function "READ" element "S") reader ,count))
          (t `(let* ((count ,count) (values (make-array count)))
                (dotimes (i count values)
                  (setf (svref values i) (,(name-of "%READ-~a" element) reader)))))))

  (defun reading (step field)
    "A binding of LET* that reads a step."
    (destructuring-bind (slot name type &key &allow-other-keys) field
      (multiple-value-bind (shape element limit least) (shape-of type)
        (let ((count (symbol-of "~a%COUNT" slot)))
          (if (eq step :count)
              `(,count (read-uint32 reader))
              `(,slot
                ,(ecase shape
                   (:one (if (keywordp element)
                             `(,(scalar-function "READ" element) reader)
                             `(,(name-of "%READ-~a" element) reader)))
                   (:array (read-elements element limit))
                   ((:bounded :counted)
                    (read-elements element `(read-length reader ,name ,(if (eq shape :counted) count limit)
                                                         ,(least-bytes element least)))))))))))

  (defun unused-counts (fields)
    "Counts of lists with a limit of their own are read and not used."
    (loop for (slot nil type) in fields
          when (eq (shape-of type) :bounded) collect (symbol-of "~a%COUNT" slot)))

  (defun writing-elements (element)
    (cond ((opaque-p element) '((write-octets writer value)))
          ((keywordp element)
           `((map nil (lambda (each) (,(scalar-function "WRITE" element) writer each)) value)))
          (t `((map nil (lambda (each) (,(name-of "%WRITE-~a" element) writer each)) value)))))

  (defun writing (struct step field)
    "A form that writes a step."
    (destructuring-bind (slot name type &key &allow-other-keys) field
      (multiple-value-bind (shape element limit) (shape-of type)
        (let ((value `(,(symbol-of "~a-~a" struct slot) struct)))
          (cond ((eq step :count) `(write-length writer ,name (length ,value) ,limit))
                ((and (eq shape :one) (keywordp element)) `(,(scalar-function "WRITE" element) writer ,value))
                ((eq shape :one) `(,(name-of "%WRITE-~a" element) writer ,value))
                ((and (eq shape :array) (opaque-p element)) `(write-fixed writer ,name ,value ,limit))
                (t `(let ((value ,value))
                      ,(if (eq shape :array)
                           `(check-length ,name (length value) ,limit)
                           `(write-length writer ,name (length value) ,limit))
                      ,@(writing-elements element)))))))))

(defmacro define-struct ((struct name) documentation &rest fields)
  "Defines a structure with its reader and writer. A field is (SLOT NAME TYPE [:count-before SLOT]); a type is a scalar
such as :float32, another structure, (:array TYPE LENGTH), (:bounded TYPE LIMIT), or (:counted TYPE LIMIT), whose limit
is its count; lists of structures also have the least bytes of an element."
  (let ((reader (name-of "%READ-~a" struct)) (writer (name-of "%WRITE-~a" struct)) (slots (mapcar #'first fields)))
    `(progn
       (defstruct (,struct (:include wire-struct)
                           (:constructor ,(symbol-of "MAKE-~a" struct))
                           (:copier ,(symbol-of "COPY-~a" struct))
                           (:predicate ,(symbol-of "~a-P" struct)))
         ,documentation
         ,@(loop for (slot nil type) in fields
                 collect `(,slot ,(slot-default type) :type ,(slot-type type))))
       (defun ,reader (reader)
         (let* ,(loop for (step field) in (steps fields) collect (reading step field))
           (declare (ignore ,@(unused-counts fields)))
           (,(symbol-of "MAKE-~a" struct)
            ,@(loop for slot in slots collect (intern (symbol-name slot) :keyword) collect slot))))
       (defun ,writer (writer struct)
         ,@(loop for (step field) in (steps fields) collect (writing struct step field))
         nil)
       (setf (get ',struct 'codec)
             (make-codec :name ,name :reader #',reader :writer #',writer
                         :fields (list ,@(loop for (slot field-name type) in fields
                                               collect `(make-field :name ,field-name :type ',type
                                                                    :accessor #',(symbol-of "~a-~a" struct slot))))))
       ',struct)))

;;; Messages

(defstruct message-type
  "One message type of one interface, as PLAYER_POSITION2D_CMD_VEL; without `payload' it has no body."
  interface kind subtype name payload)

(defvar *messages* (make-hash-table) "All message types, by their key.")

(defun message-key (interface kind subtype)
  (logior (ash interface 16) (ash (kind-number kind) 8) subtype))

(defmacro define-message (variable interface kind subtype name &optional payload)
  `(progn
     (defparameter ,variable
       (make-message-type :interface ,interface :kind ,kind :subtype ,subtype :name ,name :payload ',payload))
     (setf (gethash (message-key ,interface ,kind ,subtype) *messages*) ,variable)))

(defun find-message (interface kind subtype)
  "The type of a message, or nil. Answers have that of their request; shared messages apply to every interface."
  (let ((kind (if (member kind '(:ack :nack)) :req kind)))
    (and (keywordp kind)
         (values (or (gethash (message-key 0 kind subtype) *messages*)
                     (gethash (message-key interface kind subtype) *messages*))))))
