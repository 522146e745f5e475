;;;; Suggestions for words that are not known.

(in-package #:playhouse-client)

(defparameter *similar* 0.6 "Similarity from which a word is near another.")

(defun did-you-mean (word known)
  "' (did you mean \"laser\"?)' for the nearest known word, empty if none is near."
  (let ((best nil) (most *similar*))
    (dolist (each known (if best (format nil " (did you mean ~s?)" best) ""))
      (let ((similarity (similarity word each)))
        (when (if best (> similarity most) (>= similarity most))
          (setf best each most similarity))))))

(defun similarity (one other)
  "From 0 to 1: the share of the characters in common runs, longest first."
  (let ((total (+ (length one) (length other))))
    (if (zerop total) 1 (/ (* 2 (matching one other)) total))))

(defun matching (one other)
  "The number of characters in the longest common run, and in those before and behind it."
  (multiple-value-bind (length at there) (longest-run one other)
    (if (zerop length)
        0
        (+ length
           (matching (subseq one 0 at) (subseq other 0 there))
           (matching (subseq one (+ at length)) (subseq other (+ there length)))))))

(defun longest-run (one other)
  "Length and places of the longest common run."
  (let ((length 0) (at 0) (there 0))
    (dotimes (i (length one) (values length at there))
      (dotimes (j (length other))
        (let* ((end (mismatch one other :start1 i :start2 j))
               (run (- (or end (length one)) i)))
          (when (> run length)
            (setf length run at i there j)))))))
