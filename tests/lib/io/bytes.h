/// Binary files written by hand: values as shifted bytes, independent of the code under test.
#pragma once

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh::testing {

class Bytes {
 public:
  explicit Bytes(bool is_big = false) : is_big_(is_big) {}

  Bytes& text(const std::string& text) {
    bytes_ += text;
    return *this;
  }
  Bytes& u8(std::uint64_t value) { return put(value, 1); }
  Bytes& u16(std::uint64_t value) { return put(value, 2); }
  Bytes& u32(std::uint64_t value) { return put(value, 4); }
  Bytes& f32(float value) { return put(std::bit_cast<std::uint32_t>(value), 4); }
  Bytes& f64(double value) { return put(std::bit_cast<std::uint64_t>(value), 8); }
  const std::string& str() const { return bytes_; }

 private:
  Bytes& put(std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) {
      const int shift = 8 * (is_big_ ? size - 1 - i : i);
      bytes_ += static_cast<char>((value >> shift) & 0xff);
    }
    return *this;
  }

  bool is_big_;
  std::string bytes_;
};

inline Document read_document(const std::string& bytes) {
  return read_mesh(bytes, "input").document;
}

inline std::string rewritten(const std::string& bytes) {
  return write_mesh(read_document(bytes)).bytes;
}

/// Returns the message with which reading fails, or "read".
inline std::string read_error(const std::string& bytes, const std::string& name = "input",
                              const ReadOptions& options = {}) {
  try {
    read_mesh(bytes, name, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

/// Returns the message with which strict reading fails, or "read".
inline std::string strict_error(const std::string& bytes, const std::string& name = "input") {
  return read_error(bytes, name, {.strict = true});
}

inline bool has_note(const std::vector<std::string>& notes, const std::string& note) {
  for (const std::string& other : notes) {
    if (other == note) return true;
  }
  return false;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline const Column& column(const Columns& columns, std::string_view name) {
  const Column* found = columns.find(name);
  REQUIRE(found != nullptr);
  return *found;
}

/// Returns a tetrahedron with one corner at the origin and three on the axes.
inline Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return mesh;
}

}  // namespace transformesh::testing
