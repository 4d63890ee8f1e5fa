#include <limits>

#include "tm/io/number_text.h"
#include "tm/support/counted.h"
#include "tm/views/images/samples.h"

namespace transformesh {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Goes through the header, and through samples written as text.
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

void check_sample(const Source& source, const char* place, std::uint64_t sample, double maximum) {
  if (static_cast<double>(sample) <= maximum) return;
  source.fail_at_byte(place, "the sample " + std::to_string(sample) + " is above the maximum of " +
                                 std::to_string(static_cast<int>(maximum)) + " in the header");
}

template <class Sample>
void read_text(const Source& source, Numbers& numbers, double maximum,
               std::vector<Sample>& samples) {
  for (Sample& value : samples) {
    const std::uint64_t sample = numbers.next("last sample");
    check_sample(source, numbers.place(), sample, maximum);
    value = static_cast<Sample>(sample);
  }
}

// The more significant byte comes first.
template <class Sample>
void read_binary(const Source& source, const char* place, double maximum,
                 std::vector<Sample>& samples) {
  const std::size_t size = samples.size() * sizeof(Sample);
  const auto available = static_cast<std::size_t>(source.end() - place);
  if (available < size) {
    source.fail("the image ends too early: " + counted(size, "byte") + " of samples expected, " +
                std::to_string(available) + " found");
  }
  const char* next = place;
  for (Sample& value : samples) {
    unsigned sample = static_cast<unsigned char>(*next++);
    if (sizeof(Sample) == 2) sample = 256 * sample + static_cast<unsigned char>(*next++);
    value = static_cast<Sample>(sample);
  }
  if (maximum == std::numeric_limits<Sample>::max()) return;
  for (const Sample value : samples) {
    check_sample(source, place, value, maximum);
    place += sizeof(Sample);
  }
}

template <class Sample>
void read_samples(const Source& source, Numbers& numbers, double maximum,
                  std::vector<Sample>& samples) {
  const char kind = source.bytes[1];
  if (kind == '2' || kind == '3') return read_text(source, numbers, maximum, samples);
  // One blank ends the header; what follows may look like blanks.
  const bool has_blank = numbers.place() != source.end() && is_blank(*numbers.place());
  if (!has_blank) source.fail_at_byte(numbers.place(), "a blank must follow the maximum");
  read_binary(source, numbers.place() + 1, maximum, samples);
}

}  // namespace

Samples decode_pnm(const Source& source) {
  const char kind = source.bytes[1];
  Numbers numbers(source);
  const std::uint64_t width = numbers.next("width");
  const std::uint64_t height = numbers.next("height");
  const std::uint64_t maximum = numbers.next("maximum");
  check_size(source, width, height, 1);
  if (maximum < 1 || maximum > 65535) {
    source.fail("the image's maximum must be between 1 and 65535, not " + std::to_string(maximum));
  }

  Samples samples;
  samples.width = static_cast<int>(width);
  samples.height = static_cast<int>(height);
  samples.channels = kind == '3' || kind == '6' ? 3 : 1;
  samples.maximum = static_cast<double>(maximum);
  samples.allocate();
  samples.is_deep() ? read_samples(source, numbers, samples.maximum, samples.deep)
                    : read_samples(source, numbers, samples.maximum, samples.shallow);
  return samples;
}

}  // namespace transformesh
