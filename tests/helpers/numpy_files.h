/// Files of NumPy, written by hand for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace transformesh::test {

/// Returns the bytes of the numbers, in the order of this machine, which must be little-endian.
template <class Number>
std::string bytes_of(const std::vector<double>& values) {
  std::string bytes;
  for (const double value : values) {
    const auto number = static_cast<Number>(value);
    std::string raw(sizeof(Number), '\0');
    std::memcpy(raw.data(), &number, sizeof(Number));
    bytes += raw;
  }
  return bytes;
}

inline std::string npy(const std::string& type, const std::string& shape, const std::string& data,
                       const std::string& is_fortran = "False") {
  std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + is_fortran + ", 'shape': " + shape + ", }";
  header.resize(118 - 1, ' ');
  header += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header +
         data;
}

}  // namespace transformesh::test
