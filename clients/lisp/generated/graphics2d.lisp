;;;; Interface graphics2d, code 55. Draws 2D shapes for display.
;;;;
;;;; Generated from interfaces/055_graphics2d.toml by codegen; do not edit.

(cl:defpackage #:playhouse.graphics2d
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+cmd-clear+ #:+cmd-points+ #:+cmd-polyline+ #:+cmd-polygon+ #:+cmd-multiline+
           #:cmd-points #:cmd-polyline #:cmd-polygon #:cmd-multiline #:make-cmd-points #:copy-cmd-points
           #:cmd-points-p #:cmd-points-points #:cmd-points-color #:make-cmd-polyline #:copy-cmd-polyline
           #:cmd-polyline-p #:cmd-polyline-points #:cmd-polyline-color #:make-cmd-polygon #:copy-cmd-polygon
           #:cmd-polygon-p #:cmd-polygon-points #:cmd-polygon-color #:cmd-polygon-fill-color
           #:cmd-polygon-filled #:make-cmd-multiline #:copy-cmd-multiline #:cmd-multiline-p
           #:cmd-multiline-points #:cmd-multiline-color))

(cl:in-package #:playhouse.graphics2d)

(define-interface +code+ 55 "graphics2d")

(define-struct (cmd-points "graphics2d.CmdPoints")
  "Points. (player_graphics2d_cmd_points_t)"
  ;; In m, frame p_SP.
  (points "points" (:counted playhouse.common:point2d 2097149 16))
  (color "color" playhouse.common:color))

(define-struct (cmd-polyline "graphics2d.CmdPolyline")
  "A line through points. (player_graphics2d_cmd_polyline_t)"
  ;; In m, frame p_SP.
  (points "points" (:counted playhouse.common:point2d 2097149 16))
  (color "color" playhouse.common:color))

(define-struct (cmd-polygon "graphics2d.CmdPolygon")
  "A polygon. (player_graphics2d_cmd_polygon_t)"
  ;; Vertices (in m, frame p_SP).
  (points "points" (:counted playhouse.common:point2d 2097149 16))
  ;; Outline color.
  (color "color" playhouse.common:color)
  ;; Fill color.
  (fill-color "fill_color" playhouse.common:color)
  ;; 1: filled.
  (filled "filled" :uint8))

(define-struct (cmd-multiline "graphics2d.CmdMultiline")
  "Lines, each between two points. (player_graphics2d_cmd_multiline_t)"
  ;; Start and end of each line, alternating (in m, frame p_SP).
  (points "points" (:counted playhouse.common:point2d 2097149 16))
  (color "color" playhouse.common:color))

;; Removes all drawn shapes.
(define-message +cmd-clear+ 55 :cmd 1 "graphics2d.cmd.clear")
;; Draws points.
(define-message +cmd-points+ 55 :cmd 2 "graphics2d.cmd.points" cmd-points)
;; Draws a line through points.
(define-message +cmd-polyline+ 55 :cmd 3 "graphics2d.cmd.polyline" cmd-polyline)
;; Draws a polygon.
(define-message +cmd-polygon+ 55 :cmd 4 "graphics2d.cmd.polygon" cmd-polygon)
;; Draws a line for each pair of points.
(define-message +cmd-multiline+ 55 :cmd 5 "graphics2d.cmd.multiline" cmd-multiline)
