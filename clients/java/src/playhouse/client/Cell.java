package playhouse.client;

/** A cell of a map: its column from the left and its row from the bottom, from 0. */
public record Cell(int column, int row) {}
