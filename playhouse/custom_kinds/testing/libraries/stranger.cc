// A shared library that has nothing to do with custom models.
extern "C" int stranger() {
  return 0;
}
