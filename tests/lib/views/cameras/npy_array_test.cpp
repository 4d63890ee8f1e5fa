#include "views/cameras/npy_array.h"

#include <doctest/doctest.h>

#include "helpers/numpy_files.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

std::string refusal(const std::string& bytes) {
  try {
    read_npy({bytes, "a.npy"});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool refuses(const std::string& bytes, const std::string& words) {
  const std::string message = refusal(bytes);
  INFO(message);
  return message.find(words) != std::string::npos && message.find("a.npy") != std::string::npos;
}

}  // namespace

TEST_CASE("arrays of NumPy: doubles and floats, both byte orders, rows or columns first") {
  const std::vector<double> values{1, 2, 3, 4, 5, 6.5};
  const std::string doubles = test::npy("<f8", "(2, 3)", test::bytes_of<double>(values));
  CHECK(read_npy({doubles, ""}).shape == std::vector<std::size_t>{2, 3});
  CHECK(read_npy({doubles, ""}).values == values);
  const std::string floats = test::npy("<f4", "(6,)", test::bytes_of<float>(values));
  CHECK(read_npy({floats, ""}).values == values);
  std::string reversed = test::bytes_of<double>(values);
  for (std::size_t i = 0; i < reversed.size(); i += 8)
    std::reverse(reversed.begin() + static_cast<std::ptrdiff_t>(i),
                 reversed.begin() + static_cast<std::ptrdiff_t>(i) + 8);
  CHECK(read_npy({test::npy(">f8", "(2, 3)", reversed), ""}).values == values);
  const std::string columns =
      test::npy("<f8", "(2, 3)", test::bytes_of<double>({1, 4, 2, 5, 3, 6.5}), "True");
  CHECK(read_npy({columns, ""}).values == values);
}

TEST_CASE("arrays of NumPy: damage is refused") {
  const std::string data = test::bytes_of<double>({1, 2, 3, 4, 5, 6});
  CHECK(refuses("PK", "not a NumPy array"));
  CHECK(refuses(test::npy("<i8", "(6,)", data), "'<i8'"));
  CHECK(refuses(test::npy("|O", "(6,)", data), "not of floats"));
  CHECK(refuses(test::npy("<f8", "(7,)", data), "cut off"));
  CHECK(refuses(test::npy("<f8", "(5,)", data), "needs 40"));
  CHECK(refuses(test::npy("<f8", "(4294967296, 4294967296)", data), "cut off"));
  CHECK(refuses(test::npy("<f8", "(2, 9223372036854775808, 2)", data), "cut off"));
  CHECK(refuses(test::npy("<f8", "(-1,)", data), "'-1'"));
  CHECK(refuses(test::npy("<f8", "6", data), "malformed"));
  CHECK(refuses(test::npy("<f8", "(1,)", test::bytes_of<double>({std::nan("")})), "not finite"));
  CHECK(refuses(test::npy("<f8", "(1, 2, 3)", data, "True"), "Fortran"));
  const std::string whole = test::npy("<f8", "(6,)", data);
  for (std::size_t size = 0; size < whole.size(); ++size)
    CHECK_FALSE(refusal(whole.substr(0, size)).empty());
}
