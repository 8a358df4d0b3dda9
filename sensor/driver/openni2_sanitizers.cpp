// SPDX-License-Identifier: BSD-3-Clause
// What the sanitizers are not to report, in every program of ours that links OpenNI2:
// - OpenNI2 and the drivers that it loads leak about 100 KB for each initialisation. They are
//   unloaded when leaks are looked for, so only stacks that reach down to libOpenNI2 tell whose
//   they are: those need the slow unwinder.
// - OpenNI2 unlocks a mutex that it has not locked when it creates an event.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): the sanitizers' names
extern "C" {
const char* __asan_default_options();
const char* __asan_default_options() {
  return "fast_unwind_on_malloc=0";
}
const char* __lsan_default_suppressions();
const char* __lsan_default_suppressions() {
  return "leak:libOpenNI2.so\n";
}
const char* __tsan_default_suppressions();
const char* __tsan_default_suppressions() {
  return "mutex:libOpenNI2.so\n";
}
}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
