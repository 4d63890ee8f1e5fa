// Reads the names of kinds of errors.
#include <transformesh/error_kind.h>

#include <string>

using namespace transformesh;

int main() {
  const bool has_names = std::string(name_of(ErrorKind::not_closed)) == "not_closed" &&
                         std::string(name_of(ErrorKind::not_a_run)) == "not_a_run";
  return has_names ? 0 : 1;
}
