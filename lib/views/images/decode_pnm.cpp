#include "io/streams/number_text.h"
#include "support/counted.h"
#include "views/images/decoders.h"

namespace transformesh {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Reads integers written as text: those of the header, and samples in text formats. Skips blanks
/// and comments.
class Numbers {
 public:
  explicit Numbers(const Source& source) : source_(source), place_(source.begin() + 2) {}

  std::uint64_t next(const char* what) {
    skip_blanks();
    std::uint64_t number = 0;
    if (place_ == source_.end()) source_.fail(std::string("the image ends before its ") + what);
    if (*place_ == '+' || parse_number(place_, source_.end(), number) != Parsed::ok) {
      source_.fail_at_byte(place_, std::string("the image's ") + what + " is not a whole number");
    }
    return number;
  }
  const char* place() const { return place_; }

 private:
  void skip_blanks() {
    while (place_ != source_.end() && (is_blank(*place_) || *place_ == '#')) {
      if (*place_ != '#') {
        ++place_;
        continue;
      }
      while (place_ != source_.end() && *place_ != '\n') ++place_;
    }
  }

  const Source& source_;
  const char* place_;
};

/// Reads the samples of one row. Throws InputError if a sample exceeds `maximum`.
class SampleReader {
 public:
  SampleReader(const Source& source, Numbers& numbers, unsigned maximum)
      : source_(source), numbers_(numbers), maximum_(maximum) {}

  void read_text(std::vector<std::uint16_t>& row) {
    for (std::uint16_t& sample : row) {
      const std::uint64_t number = numbers_.next("last sample");
      sample = checked(number, numbers_.place());
    }
  }

  /// Reads a row of big-endian samples at `place`. All bytes of the row must exist.
  void read_binary(const char* place, std::vector<std::uint16_t>& row) const {
    for (std::uint16_t& sample : row) {
      const char* start = place;
      unsigned number = static_cast<unsigned char>(*place++);
      if (maximum_ > 255) number = 256 * number + static_cast<unsigned char>(*place++);
      sample = checked(number, start);
    }
  }

 private:
  std::uint16_t checked(std::uint64_t sample, const char* place) const {
    if (sample > maximum_) {
      source_.fail_at_byte(place, "the sample " + std::to_string(sample) +
                                      " is above the maximum of " + std::to_string(maximum_) +
                                      " in the header");
    }
    return static_cast<std::uint16_t>(sample);
  }

  const Source& source_;
  Numbers& numbers_;
  unsigned maximum_;
};

/// Returns the address of the first binary sample. Throws InputError if fewer than `size` bytes
/// follow.
const char* start_of_samples(const Source& source, const char* place, std::size_t size) {
  // Exactly one blank ends the header. Further bytes are samples, even if they look like blanks.
  const bool has_blank = place != source.end() && is_blank(*place);
  if (!has_blank) source.fail_at_byte(place, "a blank must follow the maximum");
  const auto available = static_cast<std::size_t>(source.end() - place) - 1;
  if (available < size) {
    source.fail("the image ends too early: " + counted(size, "byte") + " of samples expected, " +
                std::to_string(available) + " found");
  }
  return place + 1;
}

}  // namespace

void decode_pnm(const Source& source, IntensityRows& rows) {
  const char kind = source.bytes[1];
  Numbers numbers(source);
  const std::uint64_t width = numbers.next("width");
  const std::uint64_t height = numbers.next("height");
  const std::uint64_t maximum = numbers.next("maximum");
  check_size(source, width, height, 1);
  if (maximum < 1 || maximum > 65535) {
    source.fail("the image's maximum must be between 1 and 65535, not " + std::to_string(maximum));
  }

  const int channels = kind == '3' || kind == '6' ? 3 : 1;
  std::vector<std::uint16_t> row(width * static_cast<std::size_t>(channels));
  const std::size_t row_size = row.size() * (maximum > 255 ? 2 : 1);
  const bool is_text = kind == '2' || kind == '3';
  const char* place =
      is_text ? nullptr : start_of_samples(source, numbers.place(), height * row_size);
  SampleReader reader(source, numbers, static_cast<unsigned>(maximum));
  const bool wants_rows = rows.start({static_cast<int>(width), static_cast<int>(height), channels,
                                      channels, static_cast<double>(maximum)});
  if (!wants_rows) return;
  for (std::uint64_t y = 0; y < height; ++y) {
    is_text ? reader.read_text(row) : reader.read_binary(place + y * row_size, row);
    rows.add(row.data());
  }
}

}  // namespace transformesh
