/// PLY files written by hand, as text.
#pragma once

#include <string>

namespace transformesh::testing {

inline const std::string vertex_header = "property float x\nproperty float y\nproperty float z\n";
inline const std::string face_header = "property list uchar int vertex_indices\n";

inline std::string header(const std::string& format, const std::string& lines) {
  return "ply\nformat " + format + " 1.0\n" + lines + "end_header\n";
}

inline std::string ascii_triangle(const std::string& face_line) {
  return header("ascii", "element vertex 3\n" + vertex_header + "element face 1\n" + face_header) +
         "0 0 0\n1 0 0\n0 1 0\n" + face_line + "\n";
}

}  // namespace transformesh::testing
