;;;; Interface graphics3d, code 58. Draws 3D shapes for display.
;;;;
;;;; Generated from interfaces/058_graphics3d.toml by codegen; do not edit.

(cl:defpackage #:playhouse.graphics3d
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+draw-points+ #:+draw-lines+ #:+draw-line-strip+ #:+draw-line-loop+ #:+draw-triangles+
           #:+draw-triangle-strip+ #:+draw-triangle-fan+ #:+draw-quads+ #:+draw-quad-strip+ #:+draw-polygon+
           #:+cmd-clear+ #:+cmd-draw+ #:+cmd-translate+ #:+cmd-rotate+ #:+cmd-push+ #:+cmd-pop+ #:cmd-draw
           #:cmd-translate #:cmd-rotate #:make-cmd-draw #:copy-cmd-draw #:cmd-draw-p #:cmd-draw-draw-mode
           #:cmd-draw-points #:cmd-draw-color #:make-cmd-translate #:copy-cmd-translate #:cmd-translate-p
           #:cmd-translate-x #:cmd-translate-y #:cmd-translate-z #:make-cmd-rotate #:copy-cmd-rotate
           #:cmd-rotate-p #:cmd-rotate-a #:cmd-rotate-x #:cmd-rotate-y #:cmd-rotate-z))

(cl:in-package #:playhouse.graphics3d)

(define-interface +code+ 58 "graphics3d")

;;; Values of CmdDraw.draw_mode: primitives made from the points.
(define-constants
  (+draw-points+ 0)
  (+draw-lines+ 1)
  (+draw-line-strip+ 2)
  (+draw-line-loop+ 3)
  (+draw-triangles+ 4)
  (+draw-triangle-strip+ 5)
  (+draw-triangle-fan+ 6)
  (+draw-quads+ 7)
  (+draw-quad-strip+ 8)
  (+draw-polygon+ 9))

(define-struct (cmd-draw "graphics3d.CmdDraw")
  "Points, lines or faces. (player_graphics3d_cmd_draw_t)"
  (draw-mode "draw_mode" :uint32)
  ;; In m, frame p_SP.
  (points "points" (:counted playhouse.common:point3d 1398099 24))
  (color "color" playhouse.common:color))

(define-struct (cmd-translate "graphics3d.CmdTranslate")
  "A translation of the coordinate frame. (player_graphics3d_cmd_translate_t)"
  ;; In m.
  (x "x" :float64)
  ;; In m.
  (y "y" :float64)
  ;; In m.
  (z "z" :float64))

(define-struct (cmd-rotate "graphics3d.CmdRotate")
  "A rotation of the coordinate frame. (player_graphics3d_cmd_rotate_t)"
  ;; Angle about the vector (x, y, z) (in rad).
  (a "a" :float64)
  (x "x" :float64)
  (y "y" :float64)
  (z "z" :float64))

;; Removes all drawn shapes.
(define-message +cmd-clear+ 58 :cmd 1 "graphics3d.cmd.clear")
;; Draws points, lines or faces.
(define-message +cmd-draw+ 58 :cmd 2 "graphics3d.cmd.draw" cmd-draw)
;; Translates the coordinate frame of subsequent drawing.
(define-message +cmd-translate+ 58 :cmd 3 "graphics3d.cmd.translate" cmd-translate)
;; Rotates the coordinate frame of subsequent drawing.
(define-message +cmd-rotate+ 58 :cmd 4 "graphics3d.cmd.rotate" cmd-rotate)
;; Pushes the current coordinate frame.
(define-message +cmd-push+ 58 :cmd 5 "graphics3d.cmd.push")
;; Pops the pushed coordinate frame.
(define-message +cmd-pop+ 58 :cmd 6 "graphics3d.cmd.pop")
