#include <algorithm>
#include <array>
#include <cstdint>

#include "support/number.h"
#include "views/cameras/camera_formats.h"
#include "views/cameras/little_endian.h"

namespace transformesh {
namespace {

/// A camera model of COLMAP. In `numbered_models`, its index is the number by which binary files
/// identify it.
struct NumberedModel {
  const char* name;
  int parameters;
};
constexpr std::array numbered_models{NumberedModel{"SIMPLE_PINHOLE", 3},
                                     NumberedModel{"PINHOLE", 4},
                                     NumberedModel{"SIMPLE_RADIAL", 4},
                                     NumberedModel{"RADIAL", 5},
                                     NumberedModel{"OPENCV", 8},
                                     NumberedModel{"OPENCV_FISHEYE", 8},
                                     NumberedModel{"FULL_OPENCV", 12},
                                     NumberedModel{"FOV", 5},
                                     NumberedModel{"SIMPLE_RADIAL_FISHEYE", 4},
                                     NumberedModel{"RADIAL_FISHEYE", 5},
                                     NumberedModel{"THIN_PRISM_FISHEYE", 12}};

void copy_numbers(LittleEndianReader& numbers, int count, TextBuffer& text) {
  for (int i = 0; i < count; ++i) {
    text.add(' ');
    text.add_number(numbers.take<double>());
  }
}

/// Converts cameras.bin to the text of cameras.txt.
std::string cameras_text(const Source& source) {
  LittleEndianReader numbers(source, "the COLMAP binary file");
  TextBuffer text;
  for (auto count = numbers.take<std::uint64_t>(); count > 0; --count) {
    text.add_number(numbers.take<std::int32_t>());
    const auto model = static_cast<std::size_t>(numbers.take<std::int32_t>());
    if (model >= numbered_models.size())
      source.fail("COLMAP has no camera model with the number " + std::to_string(model));
    text.add(' ');
    text.add(numbered_models[model].name);
    for (int side = 0; side < 2; ++side) {
      text.add(' ');
      text.add_number(numbers.take<std::uint64_t>());
    }
    copy_numbers(numbers, numbered_models[model].parameters, text);
    text.add('\n');
  }
  return text.take();
}

/// Converts images.bin to the text of images.txt, with an empty line instead of points.
std::string images_text(const Source& source) {
  LittleEndianReader numbers(source, "the COLMAP binary file");
  TextBuffer text;
  for (auto count = numbers.take<std::uint64_t>(); count > 0; --count) {
    text.add_number(numbers.take<std::uint32_t>());
    copy_numbers(numbers, 7, text);
    text.add(' ');
    text.add_number(numbers.take<std::uint32_t>());
    text.add(' ');
    const std::string_view name = numbers.take_name();
    if (name.empty() || name.find_first_of("\r\n") != std::string_view::npos)
      source.fail("an image has the name " + in_quotes(name) + ": rename it");
    text.add(name);
    text.add("\n\n");
    const auto points = numbers.take<std::uint64_t>();
    numbers.skip(points, 24);
  }
  return text.take();
}

/// Splits a row of text into words. rest() returns the text after the last word, for names that
/// contain blanks.
class Words {
 public:
  explicit Words(std::string_view row) : rest_(row) {}

  bool has_more() const { return !rest_.empty(); }
  std::string_view rest() const { return rest_; }
  std::string_view word() {
    const std::string_view word = rest_.substr(0, rest_.find(' '));
    rest_.remove_prefix(std::min(word.size() + 1, rest_.size()));
    return word;
  }
  template <class Number>
  Number number() {
    return number_in<Number>(word()).value_or(0);
  }

 private:
  std::string_view rest_;
};

/// Returns the rows of a text, without empty rows and comments.
std::vector<std::string_view> rows_of(std::string_view text) {
  std::vector<std::string_view> rows;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    if (end > 0 && text.front() != '#') rows.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return rows;
}

std::int32_t number_of_model(std::string_view name) {
  const auto* const model = std::find_if(numbered_models.begin(), numbered_models.end(),
                                         [&](const NumberedModel& m) { return m.name == name; });
  return static_cast<std::int32_t>(model - numbered_models.begin());
}

/// Converts rows of text to binary: the number of rows, followed by the bytes that `add` writes for
/// each row.
template <class Add>
std::string binary_rows(const std::string& text, const Add& add) {
  const std::vector<std::string_view> rows = rows_of(text);
  LittleEndianWriter bytes;
  bytes.add(static_cast<std::uint64_t>(rows.size()));
  for (const std::string_view row : rows) {
    Words words(row);
    add(words, bytes);
  }
  return bytes.take();
}

}  // namespace

std::string binary_colmap_cameras(const std::string& text) {
  return binary_rows(text, [](Words& words, LittleEndianWriter& bytes) {
    bytes.add(words.number<std::int32_t>());
    bytes.add(number_of_model(words.word()));
    for (int side = 0; side < 2; ++side) bytes.add(words.number<std::uint64_t>());
    while (words.has_more()) bytes.add(words.number<double>());
  });
}

std::string binary_colmap_images(const std::string& text) {
  return binary_rows(text, [](Words& words, LittleEndianWriter& bytes) {
    bytes.add(words.number<std::uint32_t>());
    for (int i = 0; i < 7; ++i) bytes.add(words.number<double>());
    bytes.add(words.number<std::uint32_t>());
    bytes.add(words.rest());
    bytes.add('\0');
    bytes.add(std::uint64_t{0});  // number of observed points
  });
}

CameraList read_colmap_binary(const Source& cameras, const Source& images) {
  const std::string camera_lines = cameras_text(cameras);
  const std::string image_lines = images_text(images);
  return read_colmap({camera_lines, cameras.name + " as text"},
                     {image_lines, images.name + " as text"});
}

}  // namespace transformesh
