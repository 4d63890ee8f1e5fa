#include "support/counted.h"

#include <doctest/doctest.h>

using namespace transformesh;

TEST_CASE("one of a thing has the word for one") {
  CHECK(counted(0, "face") == "0 faces");
  CHECK(counted(1, "face") == "1 face");
  CHECK(counted(2, "face") == "2 faces");
  CHECK(counted(1, "vertex") == "1 vertex");
  CHECK(counted(12, "vertex") == "12 vertices");
  CHECK(counted(1, "pass") == "1 pass");
  CHECK(counted(2, "pass") == "2 passes");
  CHECK(there_are(1, "vertex") == "there is 1 vertex");
  CHECK(there_are(0, "vertex") == "there are 0 vertices");
}
