/// ZIP archives written by hand from their specification: files as they are, without compression.
#pragma once

#include <zlib.h>

#include <string>
#include <vector>

#include "lib/io/bytes.h"

namespace transformesh::testing {

struct StoredFile {
  std::string name, bytes;
};

inline std::string stored_zip(const std::vector<StoredFile>& files) {
  Bytes archive, directory;
  for (const StoredFile& file : files) {
    const auto* data = reinterpret_cast<const unsigned char*>(file.bytes.data());
    const std::uint64_t sum = crc32(0, data, static_cast<unsigned>(file.bytes.size()));
    const auto common = [&](Bytes& to) {
      to.u16(10).u16(0).u16(0).u32(0x00210000).u32(sum).u32(file.bytes.size());
      to.u32(file.bytes.size()).u16(file.name.size()).u16(0);
    };
    directory.text("PK\1\2").u16(10);
    common(directory);
    directory.u16(0).u16(0).u16(0).u32(0).u32(archive.str().size()).text(file.name);
    archive.text("PK\3\4");
    common(archive);
    archive.text(file.name).text(file.bytes);
  }
  Bytes end;
  end.text("PK\5\6").u16(0).u16(0).u16(files.size()).u16(files.size());
  end.u32(directory.str().size()).u32(archive.str().size()).u16(0);
  return archive.str() + directory.str() + end.str();
}

/// A 3MF archive with this model.
inline std::string three_mf_of(const std::string& model, std::vector<StoredFile> others = {}) {
  others.push_back({"3D/3dmodel.model", model});
  others.push_back(
      {"_rels/.rels",
       "<Relationships><Relationship Target=\"/3D/3dmodel.model\" Type=\"http://schemas."
       "microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"});
  return stored_zip(others);
}

/// Returns the elements of a triangle in the plane z = height, with these attributes.
inline std::string three_mf_triangle(int height, const std::string& attributes = "") {
  const std::string z = " z=\"" + std::to_string(height) + "\"/>";
  return "<mesh><vertices><vertex x=\"0\" y=\"0\"" + z + "<vertex x=\"1\" y=\"0\"" + z +
         "<vertex x=\"0\" y=\"1\"" + z +
         "</vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\" " + attributes +
         "/></triangles></mesh>";
}

}  // namespace transformesh::testing
