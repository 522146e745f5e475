// Looks like a controller built for Stage's library.
extern "C" int Init(void*, void*) {
  return 0;
}
