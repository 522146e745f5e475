;;;; What a sonar has in this library alone.

(in-package #:playhouse-client)

(define-updates sonar ranges)
