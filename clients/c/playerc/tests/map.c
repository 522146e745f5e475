/* map PORT fetches a map and prints it. */
#include <libplayerc/playerc.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
  int i, j;
  playerc_client_t *client;
  playerc_map_t *map;
  (void)argc;

  client = playerc_client_create(NULL, "localhost", atoi(argv[1]));
  if (playerc_client_connect(client) != 0)
    return 1;
  map = playerc_map_create(client, 0);
  if (playerc_map_subscribe(map, PLAYER_OPEN_MODE) != 0 || playerc_map_get_map(map) != 0)
  {
    fprintf(stderr, "%s\n", playerc_error_str());
    return 1;
  }
  printf("%d x %d of %.2f m from %.1f %.1f\n", map->width, map->height, map->resolution, map->origin[0], map->origin[1]);
  for (j = map->height - 1; j >= 0; j--)
  {
    for (i = 0; i < map->width; i++)
    {
      char cell = map->cells[PLAYERC_MAP_INDEX(map, i, j)];
      putchar(cell < 0 ? '.' : cell > 0 ? '#' : '?');
    }
    putchar('\n');
  }
  playerc_map_unsubscribe(map);
  playerc_map_destroy(map);
  playerc_client_disconnect(client);
  playerc_client_destroy(client);
  return 0;
}
