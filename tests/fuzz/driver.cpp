// The function that libFuzzer calls. Results do not depend on threads, and one thread is faster for
// tiny inputs.
#include "fuzz/fuzz.h"
#include "support/parallel.h"
#include "transformesh/control.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const transformesh::ThreadLimit one_thread(1);
  transformesh::fuzz::run_target({reinterpret_cast<const char*>(data), size});
  return 0;
}
