;;;; Covariances of poses, as a localization tells and takes them.

(in-package #:playhouse-client)

(defstruct covariance
  "Covariance of a pose in the plane: of x, y (m) and a (rad). xx, yy, aa are variances."
  (xx 0d0 :type real) (yy 0d0 :type real) (aa 0d0 :type real)
  (xy 0d0 :type real) (ya 0d0 :type real) (xa 0d0 :type real))

(defun covariance-of-deviations (x y a)
  "That of independent errors with these standard deviations, in m, m and rad."
  (make-covariance :xx (* x x) :yy (* y y) :aa (* a a)))

(defun covariance-of (numbers)
  (destructuring-bind (xx yy aa xy ya xa) (coerce numbers 'list)
    (make-covariance :xx xx :yy yy :aa aa :xy xy :ya ya :xa xa)))

(defun wire-covariance (covariance)
  "Its numbers, in the order of the wire."
  (list (covariance-xx covariance) (covariance-yy covariance) (covariance-aa covariance)
        (covariance-xy covariance) (covariance-ya covariance) (covariance-xa covariance)))

(defun insist-on-covariance (device covariance)
  (insist-on-type device covariance 'covariance)
  (apply #'insist-on-finite device
         (mapcan #'list (list "xx" "yy" "aa" "xy" "ya" "xa") (wire-covariance covariance))))
