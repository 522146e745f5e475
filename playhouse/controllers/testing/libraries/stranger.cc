// A shared library that has nothing to do with controllers.
extern "C" int stranger() {
  return 0;
}
