/// Matrices as text.
#include "io/matrix_file.h"

#include <doctest/doctest.h>

#include "transformesh/errors.h"

using namespace transformesh;

TEST_CASE("a matrix is sixteen numbers, whatever is between them") {
  Eigen::Matrix4d expected;
  expected << 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 1;
  CHECK(parse_matrix("1 2 3 4\n5 6 7 8\n9 10 11 12\n0 0 0 1\n", "m") == expected);
  CHECK(parse_matrix("# found\n1,2,3,4,5,6,7,8,\r\n9\t10 11 12 0 0 0 1 # end", "m") == expected);
}

TEST_CASE("other text is an error that names the line") {
  const auto message_of = [](const char* text) -> std::string {
    try {
      parse_matrix(text, "m.txt");
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  CHECK(message_of("") == "a 4x4 matrix has 16 numbers, but there are 0 (m.txt)");
  CHECK(message_of("7") == "a 4x4 matrix has 16 numbers, but there is 1 (m.txt)");
  CHECK(message_of("1 2 3\n4 x\n").find("line 2") != std::string::npos);
  CHECK(message_of("1 2 3\n4 inf\n").find("line 2") != std::string::npos);
  CHECK(message_of("1 2 3 4\n5 6 7 8\n9 10 11 12\n0 0 0 1 7\n").find("line 4") !=
        std::string::npos);
}
