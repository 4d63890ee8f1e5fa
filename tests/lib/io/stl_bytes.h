/// STL files written by hand.
#pragma once

#include "lib/io/bytes.h"

namespace transformesh::testing {

inline Bytes binary_start(const std::string& header, std::uint64_t facets) {
  Bytes file;
  file.text(header + std::string(80 - header.size(), '\0')).u32(facets);
  return file;
}

inline void add_facet(Bytes& file, float x, std::uint64_t attribute) {
  file.f32(0).f32(0).f32(1);
  file.f32(x).f32(0).f32(0).f32(x + 1).f32(0).f32(0).f32(x).f32(1).f32(0).u16(attribute);
}

inline const std::string text_file =
    "solid box\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0.1\n"
    "endloop\nendfacet\nendsolid box\n";

}  // namespace transformesh::testing
