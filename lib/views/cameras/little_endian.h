/// Reads and writes numbers and texts of little-endian binary files of cameras and points.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "io/streams/source.h"

namespace transformesh {

/// Reads consecutive values. All members throw InputError, with the size of the file, if the file
/// ends too early.
class LittleEndianReader {
 public:
  /// `what` describes the file in messages, such as "the COLMAP binary file".
  LittleEndianReader(const Source& source, std::string what)
      : source_(source), what_(std::move(what)), rest_(source.bytes) {}

  template <class Number>
  Number take() {
    std::array<char, sizeof(Number)> bytes{};
    const std::string_view taken = take_bytes(sizeof(Number));
    std::memcpy(bytes.data(), taken.data(), sizeof(Number));
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<Number>(bytes);
  }
  /// Returns the text up to the next zero byte.
  std::string_view take_name() {
    const std::size_t size = rest_.find('\0');
    if (size == std::string_view::npos) fail();
    return take_bytes(size + 1).substr(0, size);
  }
  std::string_view take_bytes(std::size_t size) {
    if (rest_.size() < size) fail();
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  void skip(std::uint64_t count, std::uint64_t size) {
    if (count > rest_.size() / size) fail();
    rest_.remove_prefix(count * size);
  }
  bool is_at_end() const { return rest_.empty(); }

 private:
  [[noreturn]] void fail() const {
    source_.fail(what_ + " ends too early, after " + std::to_string(source_.bytes.size()) +
                 " bytes");
  }

  const Source& source_;
  std::string what_;
  std::string_view rest_;
};

/// Writes consecutive values to a string of bytes.
class LittleEndianWriter {
 public:
  template <class Number>
  void add(Number number) {
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    bytes_.append(bytes.data(), bytes.size());
  }
  void add(std::string_view text) { bytes_ += text; }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace transformesh
