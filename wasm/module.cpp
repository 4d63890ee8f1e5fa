/// The programs of core in one module: the first argument names the program to run.
#include <cstdio>
#include <cstring>

#define PROGRAM(name, function) int function(int, char**);
#include "programs.inc"
#undef PROGRAM

int main(int argc, char** argv) {
  const char* wanted = argc > 1 ? argv[1] : "";
#define PROGRAM(name, function) \
  if (std::strcmp(wanted, name) == 0) return function(argc - 1, argv + 1);
#include "programs.inc"
#undef PROGRAM
  std::fprintf(stderr, "transformesh: '%s' is no program of this module\n", wanted);
  return 2;
}
