/// Reads and writes the mesh files of benchmarks through the library.
#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

inline Mesh read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError("cannot open " + path);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  return read_mesh(bytes, path).document.mesh;
}

inline void write_file(const std::string& path, const Mesh& mesh) {
  Document document;
  document.mesh = mesh;
  std::ofstream(path, std::ios::binary) << write_mesh(document).bytes;
}

}  // namespace transformesh
