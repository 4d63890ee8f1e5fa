/// One row of a CSV file of numbers, independent of the locale; and numbers as text and back.
#pragma once

#include <concepts>
#include <string>

namespace transformesh {

/// As printf's %g with so many significant digits.
std::string significant(double value, int digits);
/// As printf's %f with so many decimals.
std::string fixed(double value, int decimals);
/// The number that either of them wrote.
double read_back(const std::string& text);

class CsvRow {
 public:
  CsvRow& count(std::integral auto value) { return text(std::to_string(value)); }
  CsvRow& number(double value) { return text(significant(value, 6)); }
  CsvRow& share(double value) { return text(fixed(value, 4)); }
  CsvRow& seconds(double value) { return text(fixed(value, 3)); }
  CsvRow& text(const std::string& value) {
    line_ += (line_.empty() ? "" : ",") + value;
    return *this;
  }
  const std::string& line() const { return line_; }

 private:
  std::string line_;
};

}  // namespace transformesh
