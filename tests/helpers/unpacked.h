/// Decodes a packed mesh. Written from the description of the format in pack.h, independently of
/// pack.cpp.
#pragma once

#include <zlib.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh::test {

struct Unpacked {
  nlohmann::json header;
  Mesh mesh;  ///< vertices in the order of the packed bytes
  /// In the order of the header; a color has three columns.
  std::vector<std::vector<double>> columns;
  bool is_complete = false;  ///< true: all bytes were decoded
};

class Unpacker {
 public:
  explicit Unpacker(const std::string& block) : bytes_(inflated(block)) {}

  Unpacked all() {
    Unpacked result;
    const std::size_t size = numbers(1, 4)[0];
    result.header = nlohmann::json::parse(bytes_.substr(at_, size));
    at_ += size;
    read_faces(result);
    read_positions(result);
    for (const auto& column : result.header["columns"]) read_column(column, result);
    result.is_complete = at_ == bytes_.size();
    return result;
  }

 private:
  static std::string inflated(const std::string& block) {
    for (std::size_t room = 1000;; room *= 4) {
      std::string bytes(room, '\0');
      uLongf size = bytes.size();
      const int code = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                                  reinterpret_cast<const Bytef*>(block.data()), block.size());
      if (code == Z_OK) return bytes.substr(0, size);
      if (code != Z_BUF_ERROR) throw std::runtime_error("no block of zlib");
    }
  }

  std::vector<std::uint32_t> numbers(std::size_t count, std::size_t width) {
    std::vector<std::uint32_t> numbers(count);
    for (std::size_t byte = 0; byte < width; ++byte)
      for (std::size_t i = 0; i < count; ++i)
        numbers[i] += static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_.at(at_++)))
                      << (8 * byte);
    return numbers;
  }

  std::vector<std::uint32_t> sums(std::size_t count, std::size_t width) {
    auto sums = numbers(count, width);
    for (std::size_t i = 1; i < count; ++i)
      sums[i] = (sums[i] + sums[i - 1]) % (width == 1 ? 256U : 65536U);
    return sums;
  }

  void read_faces(Unpacked& result) {
    const std::size_t vertices = result.header["vertices"];
    const auto codes =
        numbers(3 * result.header["faces"].get<std::size_t>(), vertices <= 65535 ? 2 : 4);
    Index next = 0;
    for (std::size_t i = 0; i < codes.size(); ++i) {
      if (i % 3 == 0) result.mesh.faces.emplace_back();
      result.mesh.faces.back()[i % 3] = next - codes[i];
      if (codes[i] == 0) ++next;
    }
  }

  void read_positions(Unpacked& result) {
    result.mesh.positions.resize(result.header["vertices"]);
    for (int axis = 0; axis < 3; ++axis) {
      const auto codes = sums(result.mesh.positions.size(), 2);
      const double low = result.header["low"][axis], high = result.header["high"][axis];
      for (std::size_t i = 0; i < codes.size(); ++i)
        result.mesh.positions[i][axis] = low + (high - low) * codes[i] / 65535;
    }
  }

  void read_column(const nlohmann::json& column, Unpacked& result) {
    const std::size_t rows = result.header[column["of"] == "face" ? "faces" : "vertices"];
    const bool is_color = column["of"] == "color";
    const double low = column["low"], high = column["high"];
    for (int channel = 0; channel < (is_color ? 3 : 1); ++channel) {
      std::vector<double>& values = result.columns.emplace_back();
      for (const std::uint32_t code : sums(rows, is_color ? 1 : 2)) {
        const bool is_none = !is_color && code == 65535;
        values.push_back(is_color ? code : is_none ? NAN : low + (high - low) * code / 65534);
      }
    }
  }

  std::string bytes_;
  std::size_t at_ = 0;
};

inline Unpacked unpacked(const std::string& block) { return Unpacker(block).all(); }

}  // namespace transformesh::test
