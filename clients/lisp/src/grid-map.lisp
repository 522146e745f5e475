;;;; Grid maps, which come in tiles that are compressed with zlib.

(in-package #:playhouse-client)

(defconstant +tile+ 512 "Cells along a side of a tile of a map, so that any map fits into messages.")
(defconstant +most-cells+ (ash 1 26) "Cells of a map.")

(defclass grid-map (device) ()
  (:documentation "A grid map: the interface that Player calls map."))

(defstruct grid
  "The grid of a map: length of a cell's side in m, width and height in cells, and the pose of the lower left corner of
cell (0, 0) in the world."
  (cell-size 1d0 :type real) (width 0 :type unsigned-byte) (height 0 :type unsigned-byte)
  (origin (make-pose) :type pose))

(define-operation grid ((map grid-map))
  "Size and place of the map, without its cells. Signals wire-error if the numbers are those of no map."
  (let* ((info (answer-of map playhouse.map:+req-get-info+))
         (size (playhouse.map:info-scale info))
         (origin (pose-of (playhouse.map:info-origin info))))
    (unless (and (finitep size) (> size 0)
                 (every #'finitep (list (pose-x origin) (pose-y origin) (pose-a origin))))
      (fail 'wire-error "~a: invalid map: cells of ~a m from (~{~a~^, ~}) on" (device-name map) (number-text size)
            (mapcar #'number-text (list (pose-x origin) (pose-y origin) (pose-a origin)))))
    (make-grid :cell-size size :width (playhouse.map:info-width info) :height (playhouse.map:info-height info)
               :origin origin)))

(defun cell-of (grid x y)
  "Column and row of the cell with this point of the world (m), two values; nil beyond the map."
  (without-float-traps
    (let* ((origin (grid-origin grid))
           (dx (- x (pose-x origin))) (dy (- y (pose-y origin)))
           (c (cos (pose-a origin))) (s (sin (pose-a origin)))
           (column (/ (+ (* c dx) (* s dy)) (grid-cell-size grid)))
           (row (/ (- (* c dy) (* s dx)) (grid-cell-size grid))))
      (if (and (finitep column) (finitep row)
               (<= 0 column) (< column (grid-width grid)) (<= 0 row) (< row (grid-height grid)))
          (values (floor column) (floor row))
          nil))))

(define-operation cells ((map grid-map))
  "The whole map, an array: (aref (cells map) row column), rows from the bottom, is 1 if the cell is occupied, -1 if it
is free, 0 if that is unknown. Signals wire-error for a map of more than 2^26 cells, and for faulty answers."
  (let* ((grid (grid map)) (width (grid-width grid)) (height (if (zerop width) 0 (grid-height grid))))
    (when (> (* width height) +most-cells+)
      (fail 'wire-error "~a: ~d x ~d cells are over the limit of ~d" (device-name map) width height +most-cells+))
    (let ((cells (make-array (list height width) :element-type '(signed-byte 8) :initial-element 0)))
      (loop for row from 0 below height by +tile+
            do (loop for column from 0 below width by +tile+
                     do (fill-tile map cells row column (min +tile+ (- height row)) (min +tile+ (- width column)))))
      cells)))

(defun fill-tile (map cells row column height width)
  "Requests a tile and writes its occupancies into CELLS."
  (declare (type (simple-array (signed-byte 8) (* *)) cells) (type fixnum row column height width))
  (let* ((tile (answer-of map playhouse.map:+req-get-data+
                          (playhouse.map:make-data :col column :row row :width width :height height)))
         (values (uncompressed (playhouse.map:data-data tile) (* width height)))
         (table (occupancies (playhouse.map:data-data-range tile))))
    (declare (type octets values) (type (simple-array (signed-byte 8) (256)) table))
    (unless (= (length values) (* width height))
      (fail 'wire-error "~a: a tile of ~d x ~d cells is damaged" (device-name map) width height))
    (dotimes (i height)
      (dotimes (j width)
        (setf (aref cells (+ row i) (+ column j)) (aref table (aref values (+ j (* i width)))))))))

(defun uncompressed (data count)
  "At most one byte more than COUNT; the data themselves if they are not a zlib stream, as of a server without it."
  (let ((output (make-array (1+ count) :element-type '(unsigned-byte 8))))
    (handler-case
        (multiple-value-bind (consumed produced) (chipz:decompress output (chipz:make-dstate 'chipz:zlib) data)
          (declare (ignore consumed))
          (subseq output 0 produced))
      (chipz:decompression-error () data))))

(defun occupancies (data-range)
  "For each byte of a map what it says as an int8: 1 and -1 beyond half of DATA-RANGE, else 0."
  (let ((limit (max data-range 1)) (table (make-array 256 :element-type '(signed-byte 8))))
    (dotimes (byte 256 table)
      (let ((twice (* 2 (if (> byte 127) (- byte 256) byte))))
        (setf (aref table byte) (cond ((> twice limit) 1) ((< twice (- limit)) -1) (t 0)))))))
