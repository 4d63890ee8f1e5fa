// This file is linked only into the Python module of a wheel. The static libpng and libtiff of
// Debian are compiled for programs: they address `stderr` as a variable of the program, which a
// shared object cannot contain. The linker's option --wrap=stderr makes them use the copy
// `__wrap_stderr`. The option determines both names below.
#include <cstdio>

extern "C" {
extern std::FILE* __real_stderr;
std::FILE* __wrap_stderr = nullptr;
}

namespace {

/// Runs before all other initializers, which may write to stderr.
[[gnu::constructor(101)]] void copy_stderr() { __wrap_stderr = __real_stderr; }

}  // namespace
