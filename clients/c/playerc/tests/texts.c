/* As old programs are, which include nothing else: texts PORT sets what a blackboard has and reads it back. */
#include <libplayerc/playerc.h>

static int as_told(playerc_blackboard_t *board, const char *key, const void *value, size_t size) {
  player_blackboard_entry_t *entry = NULL;
  int same = playerc_blackboard_get_entry(board, key, "group", &entry) == 0 && entry->data_count == size &&
             memcmp(entry->data, value, size) == 0 && entry->timestamp_sec > 0;
  if (entry != NULL) player_blackboard_entry_t_free(entry);
  return same;
}

int main(int argc, char **argv) {
  playerc_client_t *client = playerc_client_create(NULL, "localhost", argc > 1 ? atoi(argv[1]) : 6665);
  playerc_blackboard_t *board = playerc_blackboard_create(client, 0);
  const char *keys[] = {"name", "count", "size"};
  const int count = 7;
  const double size = 0.5;
  int ready = false;

  VERIFY(ARRAYSIZE(keys) == 3);
  if (playerc_client_connect(client) == 0 && playerc_blackboard_subscribe(board, PLAYER_OPEN_MODE) == 0)
    ready = true;
  assert(ready);
  playerc_blackboard_set_string(board, keys[0], "group", "anne");
  playerc_blackboard_set_int(board, keys[1], "group", count);
  playerc_blackboard_set_double(board, keys[2], "group", size);
  printf("%d%d%d\n", as_told(board, keys[0], "anne", 5), as_told(board, keys[1], &count, sizeof(count)),
         as_told(board, keys[2], &size, sizeof(size)));
  playerc_blackboard_unsubscribe(board);
  playerc_blackboard_destroy(board);
  playerc_client_disconnect(client);
  playerc_client_destroy(client);
  return 0;
}
