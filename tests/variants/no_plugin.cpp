/// A shared object, but no plugin.
extern "C" int answer() {
  return 42;
}
