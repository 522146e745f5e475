package playhouse.client;

import java.util.Optional;

/**
 * The grid of a map.
 *
 * @param cellSize Length of a cell's side in m.
 * @param width In cells.
 * @param height In cells.
 * @param origin Pose of the lower left corner of cell (0, 0) in the world.
 */
public record Grid(double cellSize, long width, long height, Pose origin) {
  /** The cell with this point of the world (m); empty beyond the map. */
  public Optional<Cell> cellOf(double x, double y) {
    double dx = x - origin.x();
    double dy = y - origin.y();
    double c = Math.cos(origin.a());
    double s = Math.sin(origin.a());
    double column = (c * dx + s * dy) / cellSize;
    double row = (c * dy - s * dx) / cellSize;
    boolean inside = column >= 0 && column < width && row >= 0 && row < height;  // not of nan
    return inside ? Optional.of(new Cell((int) column, (int) row)) : Optional.empty();
  }
}
