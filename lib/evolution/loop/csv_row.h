/// A row of a CSV file together with the header.
#pragma once

#include <concepts>
#include <string>

#include "support/number.h"

namespace transformesh {

/// Builds a row of a CSV file and its header. Each call adds a column name and a value, so that
/// header and row agree.
class CsvRow {
 public:
  CsvRow& count(const std::string& name, std::integral auto value) {
    return text(name, std::to_string(value));
  }
  CsvRow& number(const std::string& name, double value, int digits = 6) {
    return text(name, significant(value, digits));
  }
  CsvRow& share(const std::string& name, double value, int decimals = 4) {
    return text(name, fixed(value, decimals));
  }
  CsvRow& seconds(const std::string& name, double value) { return share(name, value, 3); }
  CsvRow& text(const std::string& name, const std::string& value) {
    const std::string comma = header_.empty() ? "" : ",";
    header_ += comma + name;
    line_ += comma + value;
    return *this;
  }

  const std::string& header() const { return header_; }
  const std::string& line() const { return line_; }

 private:
  std::string header_, line_;
};

}  // namespace transformesh
