#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "tm/views/cameras/camera_formats.h"

namespace transformesh {
namespace {

/// The models by their numbers in files, with how many parameters they have.
struct Model {
  const char* name;
  int parameters;
};
constexpr std::array models{Model{"SIMPLE_PINHOLE", 3},
                            Model{"PINHOLE", 4},
                            Model{"SIMPLE_RADIAL", 4},
                            Model{"RADIAL", 5},
                            Model{"OPENCV", 8},
                            Model{"OPENCV_FISHEYE", 8},
                            Model{"FULL_OPENCV", 12},
                            Model{"FOV", 5},
                            Model{"SIMPLE_RADIAL_FISHEYE", 4},
                            Model{"RADIAL_FISHEYE", 5},
                            Model{"THIN_PRISM_FISHEYE", 12}};

/// Numbers one after the other, little-endian.
class Numbers {
 public:
  explicit Numbers(const Source& source) : source_(source), rest_(source.bytes) {}

  template <class Number>
  Number take() {
    std::array<char, sizeof(Number)> bytes{};
    const std::string_view taken = take_bytes(sizeof(Number));
    std::memcpy(bytes.data(), taken.data(), sizeof(Number));
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<Number>(bytes);
  }

  std::string_view take_name() {
    const std::size_t size = rest_.find('\0');
    if (size == std::string_view::npos) fail();
    return take_bytes(size + 1).substr(0, size);
  }

  void skip(std::uint64_t count, std::uint64_t size) {
    if (count > rest_.size() / size) fail();
    rest_.remove_prefix(count * size);
  }

 private:
  std::string_view take_bytes(std::size_t size) {
    if (rest_.size() < size) fail();
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  [[noreturn]] void fail() const {
    source_.fail("COLMAP's binary file ends too early, after " +
                 std::to_string(source_.bytes.size()) + " bytes");
  }

  const Source& source_;
  std::string_view rest_;
};

void copy_numbers(Numbers& numbers, int count, TextBuffer& text) {
  for (int i = 0; i < count; ++i) {
    text.add(' ');
    text.add_number(numbers.take<double>());
  }
}

/// The same as a line of cameras.txt for each.
std::string cameras_text(const Source& source) {
  Numbers numbers(source);
  TextBuffer text;
  for (auto count = numbers.take<std::uint64_t>(); count > 0; --count) {
    text.add_number(numbers.take<std::int32_t>());
    const auto model = static_cast<std::size_t>(numbers.take<std::int32_t>());
    if (model >= models.size())
      source.fail("there is no model " + std::to_string(model) + " of COLMAP's cameras");
    text.add(' ');
    text.add(models[model].name);
    for (int side = 0; side < 2; ++side) {
      text.add(' ');
      text.add_number(numbers.take<std::uint64_t>());
    }
    copy_numbers(numbers, models[model].parameters, text);
    text.add('\n');
  }
  return text.take();
}

/// The same as a line of images.txt for each, and an empty one instead of its points.
std::string images_text(const Source& source) {
  Numbers numbers(source);
  TextBuffer text;
  for (auto count = numbers.take<std::uint64_t>(); count > 0; --count) {
    text.add_number(numbers.take<std::uint32_t>());
    copy_numbers(numbers, 7, text);
    text.add(' ');
    text.add_number(numbers.take<std::uint32_t>());
    text.add(' ');
    const std::string_view name = numbers.take_name();
    if (name.empty() || name.find_first_of("\r\n") != std::string_view::npos)
      source.fail("an image has the name " + quoted(name) + ": rename it");
    text.add(name);
    text.add("\n\n");
    const auto points = numbers.take<std::uint64_t>();
    numbers.skip(points, 24);
  }
  return text.take();
}

}  // namespace

CameraList read_colmap_binary(const Source& cameras, const Source& images) {
  const std::string camera_lines = cameras_text(cameras);
  const std::string image_lines = images_text(images);
  return read_colmap({camera_lines, cameras.name + " as text"},
                     {image_lines, images.name + " as text"});
}

}  // namespace transformesh
