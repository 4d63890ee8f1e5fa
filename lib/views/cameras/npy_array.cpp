#include "views/cameras/npy_array.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "io/document/scalar_bytes.h"
#include "support/number.h"

namespace transformesh {
namespace {

constexpr std::size_t preamble_size = 8;  ///< bytes of signature and version

/// Returns the header, the text of a Python dictionary. Removes the header and all bytes before it
/// from `rest`.
std::string_view take_header(const Source& source, std::string_view& rest) {
  const auto fail = [&] { source.fail("the NumPy array is cut off in its header"); };
  if (!rest.starts_with(npy_signature)) source.fail("not a NumPy array");
  if (rest.size() < preamble_size + 4) fail();
  const bool is_short = rest[npy_signature.size()] == 1;
  const char* const place = rest.data() + preamble_size;
  const std::size_t size = is_short ? load_scalar<std::uint16_t>(place, !host_is_little)
                                    : load_scalar<std::uint32_t>(place, !host_is_little);
  rest.remove_prefix(preamble_size + (is_short ? 2 : 4));
  if (size > rest.size()) fail();
  const std::string_view header = rest.substr(0, size);
  rest.remove_prefix(size);
  return header;
}

/// Returns the text after `key` and the colon in the header.
std::string_view after(const Source& source, std::string_view header, const char* key) {
  const std::size_t at = header.find('\'' + std::string(key) + '\'');
  const std::size_t colon = at == std::string_view::npos ? at : header.find(':', at);
  if (colon == std::string_view::npos)
    source.fail("the header of the NumPy array has no " + std::string(key));
  header.remove_prefix(colon + 1);
  header.remove_prefix(std::min(header.find_first_not_of(' '), header.size()));
  return header;
}

std::vector<std::size_t> shape_of(const Source& source, std::string_view text) {
  const std::size_t end = text.find(')');
  if (!text.starts_with('(') || end == std::string_view::npos)
    source.fail("the shape of the NumPy array is malformed");
  std::vector<std::size_t> shape;
  text = text.substr(1, end - 1);
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find_first_of(", "));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (word.empty()) continue;
    const auto size = number_in<std::size_t>(word);
    if (!size)
      source.fail("the shape of the NumPy array has " + in_quotes(word) +
                  ", which is not a whole number");
    shape.push_back(*size);
  }
  return shape;
}

/// Returns the number of values of an array with this shape. Throws InputError unless `bytes` is
/// the size of exactly this number of values.
std::size_t checked_count(const Source& source, const std::vector<std::size_t>& shape,
                          std::size_t value_size, std::size_t bytes) {
  const std::size_t available = bytes / value_size;
  std::size_t count = 1;
  bool is_larger = false;
  for (const std::size_t size : shape) {
    is_larger = is_larger || (size != 0 && count > available / size);
    count = is_larger ? count : count * size;
  }
  if (is_larger) source.fail("the NumPy array is cut off: its shape needs more values");
  if (count * value_size != bytes)
    source.fail("the NumPy array has " + std::to_string(bytes) + " bytes, but its shape needs " +
                std::to_string(count * value_size));
  return count;
}

void reorder_columns(NpyArray& array) {
  const std::size_t rows = array.shape[0];
  const std::size_t columns = array.shape[1];
  std::vector<double> values(array.values.size());
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) values[i * columns + j] = array.values[j * rows + i];
  array.values = std::move(values);
}

}  // namespace

NpyArray read_npy(const Source& source) {
  std::string_view rest = source.bytes;
  const std::string_view header = take_header(source, rest);
  const std::string_view type = after(source, header, "descr").substr(0, 5);
  const bool is_double = type.find("f8") != std::string_view::npos;
  const bool is_known = type.starts_with("'<f") || type.starts_with("'>f");
  if (!is_known || (!is_double && type.find("f4") == std::string_view::npos))
    source.fail("the NumPy array is of the type " + in_quotes(type) + ", not of floats or doubles");
  const bool is_swapped = (type[1] == '<') != host_is_little;
  NpyArray array;
  array.shape = shape_of(source, after(source, header, "shape"));
  const std::size_t size = is_double ? 8 : 4;
  const std::size_t count = checked_count(source, array.shape, size, rest.size());
  for (std::size_t i = 0; i < count; ++i) {
    const char* const place = rest.data() + i * size;
    const double value = is_double ? load_scalar<double>(place, is_swapped)
                                   : static_cast<double>(load_scalar<float>(place, is_swapped));
    if (!std::isfinite(value))
      source.fail("value " + std::to_string(i) + " of the NumPy array is not finite");
    array.values.push_back(value);
  }
  const bool is_fortran = after(source, header, "fortran_order").starts_with("True");
  if (is_fortran && array.shape.size() > 2)
    source.fail("the NumPy array is in Fortran order: save it in C order");
  if (is_fortran && array.shape.size() == 2) reorder_columns(array);
  return array;
}

}  // namespace transformesh
