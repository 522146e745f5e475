/* As programs for Player 3.0 are: place PORT says where a robot is, with three variances, and asks where it is. */
#include <libplayerc/playerc.h>

int main(int argc, char **argv) {
  playerc_client_t *client = playerc_client_create(NULL, "localhost", argc > 1 ? atoi(argv[1]) : 6665);
  playerc_localize_t *place = playerc_localize_create(client, 0);
  double pose[3] = {-5, -4.5, 0.2}, variances[3] = {0.01, 0.01, 0.001};
  double covariances[6] = {0.01, 0.01, 0.001, 0, 0, 0};

  if (playerc_client_connect(client) != 0 || playerc_localize_subscribe(place, PLAYER_OPEN_MODE) != 0)
    return 1;
  if (playerc_localize_set_pose(place, pose, variances) != 0) return 2;
  do playerc_client_read(client);
  while (place->hypoth_count == 0 || fabs(place->hypoths[0].mean.px - pose[0]) > 0.1);
  printf("x %.1f y %.1f variance %.2f, map %d\n", place->hypoths[0].mean.px, place->hypoths[0].mean.py,
         place->hypoths[0].cov[0], place->map_size_x);
  printf("six %d\n", playerc_localize_set_pose(place, pose, covariances));
  playerc_localize_unsubscribe(place);
  playerc_localize_destroy(place);
  playerc_client_disconnect(client);
  playerc_client_destroy(client);
  return 0;
}
