// A shared library that is no driver, for plugin_test.cc.

extern "C" int stranger() {
  return 0;
}
