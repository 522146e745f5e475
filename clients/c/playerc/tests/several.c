/* several PORT PORT reads two servers together, without waiting for either of them alone. */
#include <libplayerc/playerc.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
  int i, count;
  playerc_mclient_t *mclient = playerc_mclient_create();
  playerc_client_t *clients[2];
  playerc_ranger_t *rangers[2];

  if (argc < 3)
    return 1;
  for (i = 0; i < 2; i++)
  {
    clients[i] = playerc_client_create(mclient, "localhost", atoi(argv[i + 1]));
    if (playerc_client_connect(clients[i]) != 0)
      return 1;
    rangers[i] = playerc_ranger_create(clients[i], 0);
    if (playerc_ranger_subscribe(rangers[i], PLAYER_OPEN_MODE) != 0 || playerc_ranger_get_geom(rangers[i]) != 0 ||
        playerc_ranger_get_config(rangers[i], NULL, NULL, NULL, NULL, NULL, NULL, NULL) != 0)
      return 1;
  }
  while (!rangers[0]->info.fresh || !rangers[1]->info.fresh)
    if ((count = playerc_mclient_read(mclient, 10000)) < 0)
      return 1;
  for (i = 0; i < 2; i++)
    printf("%u ranges, %u points, the middle one at %.2f %.2f\n", rangers[i]->ranges_count, rangers[i]->points_count,
           rangers[i]->points[rangers[i]->points_count / 2].px, rangers[i]->bearings[rangers[i]->bearings_count / 2]);
  printf("time %d\n", mclient->time == clients[0]->datatime || mclient->time == clients[1]->datatime);
  for (i = 0; i < 2; i++)
  {
    playerc_ranger_destroy(rangers[i]);
    playerc_client_destroy(clients[i]);
  }
  playerc_mclient_destroy(mclient);
  return 0;
}
