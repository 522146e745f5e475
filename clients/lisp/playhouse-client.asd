;;;; The client library, its examples and its tests. README.md says how to load and build them.

(defsystem "playhouse-client"
  :description "Client library of Playhouse and of every server of the Player 3 protocol."
  :version "0.2.0"
  :license "Apache-2.0"
  :depends-on ("sb-bsd-sockets" "chipz")
  :components
  ((:module "src/base" :pathname "src/" :serial t
    :components ((:file "package") (:file "errors") (:file "sbcl") (:file "wire") (:file "define")))
   (:module "generated" :serial t :depends-on ("src/base")
    :components #.(loop for name in (uiop:read-file-form (merge-pathnames "generated/files.lisp-expr" *load-truename*))
                        collect `(:file ,name)))
   (:module "src/device" :pathname "src/" :serial t :depends-on ("generated")
    :components ((:file "numbers") (:file "spelling") (:file "queue") (:file "connection") (:file "session")
                 (:file "device")))
   (:module "proxies/index" :pathname "generated/proxies/" :depends-on ("src/device") :components ((:file "index")))
   (:module "src/values" :pathname "src/" :serial t :depends-on ("proxies/index")
    :components ((:file "values") (:file "scan") (:file "image") (:file "marker") (:file "covariance") (:file "bases")))
   (:module "proxies" :pathname "generated/proxies/" :serial t :depends-on ("src/values")
    :components #.(loop for name in (uiop:read-file-form (merge-pathnames "generated/proxies/files.lisp-expr"
                                                                          *load-truename*))
                        collect `(:file ,name)))
   (:module "src" :serial t :depends-on ("proxies")
    :components ((:file "sonar") (:file "planner") (:file "grid-map") (:file "simulation") (:file "models")
                 (:file "robot") (:file "client"))))
  :in-order-to ((test-op (test-op "playhouse-client/tests"))))

(defsystem "playhouse-client/examples"
  :description "The examples: square, wander, follow, talk and navigate."
  :depends-on ("playhouse-client")
  :pathname "examples/"
  :serial t
  :components ((:file "program") (:file "square") (:file "wander") (:file "follow") (:file "talk") (:file "navigate")))

(defsystem "playhouse-client/tests"
  :description "The library's own tests, and the programs that all languages have for the shared ones."
  :depends-on ("playhouse-client" "playhouse-client/examples")
  :pathname "tests/"
  :serial t
  :components ((:file "deftest") (:file "fake-server") (:file "wire-test") (:file "session-test") (:file "proxies-test")
               (:file "equipment-test") (:file "robots-test") (:file "retire-test") (:file "signals-test") (:file "readme-test")
               (:file "scenarios") (:file "dump") (:file "robots") (:file "main"))
  :perform (test-op (operation system)
             (unless (uiop:symbol-call '#:playhouse-client.tests '#:run-tests)
               (error "tests of playhouse-client failed"))))
