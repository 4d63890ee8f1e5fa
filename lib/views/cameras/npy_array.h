/// Reads arrays in the file format of NumPy. Reference: NumPy Enhancement Proposal 1, "A simple
/// file format for NumPy arrays".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/streams/source.h"

namespace transformesh {

inline constexpr std::string_view npy_signature = "\x93NUMPY";

struct NpyArray {
  std::vector<std::size_t> shape;
  std::vector<double> values;  ///< the last index changes fastest
};

/// Reads an array of floats or doubles in either byte order. Arrays in Fortran order (column-major)
/// must have at most two dimensions. Throws InputError, with the name of the file, if the bytes are
/// no such array. Also throws it if there are more or fewer numbers than the shape states, or if a
/// number is not finite.
NpyArray read_npy(const Source& source);

}  // namespace transformesh
