;;;; A queue: first in, first out.

(in-package #:playhouse-client)

(defstruct (queue (:constructor make-queue ()))
  (items '()) (last nil) (count 0))

(defun queue-empty-p (queue)
  (null (queue-items queue)))

(defun enqueue (item queue)
  (let ((cell (list item)))
    (if (queue-empty-p queue)
        (setf (queue-items queue) cell)
        (setf (cdr (queue-last queue)) cell))
    (setf (queue-last queue) cell)
    (incf (queue-count queue))))

(defun dequeue (queue)
  (decf (queue-count queue))
  (pop (queue-items queue)))

(defun take-all (queue)
  "All items, which are then no longer in the queue."
  (prog1 (queue-items queue)
    (setf (queue-items queue) '() (queue-count queue) 0)))

(defun remove-from-queue (test queue)
  "Removes the items that satisfy TEST; returns their number."
  (let ((before (queue-count queue)))
    (dolist (item (remove-if test (take-all queue)))
      (enqueue item queue))
    (- before (queue-count queue))))
