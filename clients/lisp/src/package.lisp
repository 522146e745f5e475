;;;; The packages: playhouse-client is the library, playhouse.wire encodes and decodes, playhouse.base has what both
;;;; need. Each interface has a package playhouse.NAME of its own (generated/).

(defpackage #:playhouse.base
  (:use #:common-lisp)
  (:documentation "Errors, and what standard Common Lisp does not have: bits of floats, UTF-8, clocks and sockets.")
  (:export
   ;; Errors
   #:player-error #:connection-lost #:run-ended #:request-timeout #:request-refused #:refused-body #:no-data
   #:device-closed #:device-gone #:invalid-value #:wire-error #:fail
   ;; Values
   #:octets #:without-float-traps #:single-of-bits #:double-of-bits #:bits-of-single #:bits-of-double #:float-kind
   #:utf-8-octets #:utf-8-string #:wall-clock #:clock
   ;; Functions of the proxies, and signals
   #:operation #:operation-name #:operation-classes #:with-signals #:call-with-signals
   ;; Sockets
   #:socket-fault #:socket-fault-text #:with-interrupts-in-waits #:connect-socket #:wait-for-socket #:send-some
   #:receive-some #:end-sending #:close-socket))

(defpackage #:playhouse.wire
  (:use #:common-lisp #:playhouse.base)
  (:documentation "Encoding and decoding of messages: what the generated packages playhouse.NAME are made of.")
  (:export
   ;; Values and their bytes
   #:wire-struct #:encode #:decode #:text #:c-string #:struct-fields #:field-name #:field-value #:field-type
   ;; Messages
   #:message-type #:message-type-p #:message-type-interface #:message-type-kind #:message-type-subtype
   #:message-type-name #:message-type-payload #:find-message #:interface-name #:interface-code #:interface-names
   #:header #:make-header #:header-p #:header-interface #:header-index #:header-kind #:header-subtype
   #:header-timestamp #:header-sequence #:header-size #:header-host #:header-robot #:encode-header #:decode-header
   #:kind-number #:+header-bytes+ #:+max-body-bytes+
   ;; Declarations of the generated files
   #:define-interface #:define-constants #:define-struct #:define-message))

(defpackage #:playhouse-client
  (:use #:common-lisp #:playhouse.base #:playhouse.wire)
  (:nicknames #:playhouse)
  (:documentation "A client of Playhouse and of any Player 3 server. README.md has the robot in ten lines.")
  (:export
   ;; Errors
   #:player-error #:connection-lost #:run-ended #:request-timeout #:request-refused #:refused-body #:no-data
   #:device-closed #:device-gone #:invalid-value #:wire-error #:without-float-traps
   ;; Signals
   #:with-signals
   ;; Client
   #:client #:connect #:connect-to #:with-client #:close-client #:banner #:connectedp #:mode #:set-mode
   #:set-replace-rule #:overflow-count #:skipped-count #:lost-count #:read-data #:list-devices #:list-models
   #:list-robots #:find-robot
   #:device-entry #:device-entry-interface #:device-entry-index #:device-entry-driver #:device-entry-model
   #:device-entry-robot #:device-entry-name
   ;; Devices
   #:device #:open-device #:with-device #:close-device #:device-interface #:device-code #:device-index #:device-access
   #:device-driver #:device-timestamp #:device-fresh-p #:device-name #:device-open-p #:device-gone-p
   #:device-has-data-p #:request #:command #:latest #:on-data #:next-data #:next-update #:do-updates #:get-property
   #:set-property #:has-capability-p #:why-refused
   ;; Models and robots
   #:model #:model-name #:model-type #:model-parent #:model-devices #:model-id
   #:device-address #:device-address-port #:device-address-interface #:device-address-index #:device-address-model
   #:device-address-name
   #:robot #:robot-name #:robot-type #:robot-models #:robot-devices #:robot-device #:robot-all #:with-robot
   #:close-robot
   ;; Values
   #:pose #:make-pose #:pose-x #:pose-y #:pose-a
   #:pose3d #:make-pose3d #:pose3d-x #:pose3d-y #:pose3d-z #:pose3d-roll #:pose3d-pitch #:pose3d-yaw
   #:size #:size-x #:size-y #:size-z
   #:velocity #:velocity-x #:velocity-y #:velocity-a
   #:scan #:scan-ranges #:scan-angles #:scan-max-range #:scan-time #:nearest
   #:marker #:marker-id #:marker-pose #:marker-distance #:marker-bearing
   #:image #:image-width #:image-height #:image-format #:image-jpeg-p #:image-data #:image-time #:pixel #:model-at
   #:covariance #:make-covariance #:covariance-xx #:covariance-yy #:covariance-aa #:covariance-xy #:covariance-ya
   #:covariance-xa #:covariance-of-deviations
   #:planner-state #:planner-state-valid-p #:planner-state-done-p #:planner-state-pose #:planner-state-goal
   #:planner-state-waypoint #:planner-state-index #:planner-state-count #:planner-state-time
   #:path #:path-waypoints #:path-length
   #:grid #:make-grid #:grid-cell-size #:grid-width #:grid-height #:grid-origin #:cell-of
   ;; Proxies by hand; generated/proxies/index.lisp exports the others, with their values
   #:arrivedp #:resume #:cells
   #:model-pose #:set-model-pose #:model-pose3d #:set-model-pose3d #:pause #:save-world #:reset-world #:join
   #:step-world #:spawn #:remove-model))
