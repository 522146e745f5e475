// Stage's build of one of its demonstrations, as STAGEPATH would lead to it.
extern "C" int Init(void*, void*) {
  return 0;
}
