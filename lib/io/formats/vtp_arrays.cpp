#include "io/formats/vtp_arrays.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "io/document/scalar_bytes.h"
#include "io/streams/number_text.h"
#include "support/base64.h"
#include "support/counted.h"

namespace transformesh {
namespace {

/// Calls f with a zero of the C++ type for the name of a VTK type. Returns false for other names.
template <class Function>
bool with_xml_type(const std::string& name, const Function& f) {
  if (name == "Float32") return f(float{}), true;
  if (name == "Float64") return f(double{}), true;
  if (name == "Int8") return f(std::int8_t{}), true;
  if (name == "UInt8") return f(std::uint8_t{}), true;
  if (name == "Int16") return f(std::int16_t{}), true;
  if (name == "UInt16") return f(std::uint16_t{}), true;
  if (name == "Int32") return f(std::int32_t{}), true;
  if (name == "UInt32") return f(std::uint32_t{}), true;
  if (name == "Int64") return f(std::int64_t{}), true;
  if (name == "UInt64") return f(std::uint64_t{}), true;
  return false;
}

template <class T>
void set_type_of(VtkArray& array) {
  set_type(std::is_floating_point_v<T>, std::is_signed_v<T>, sizeof(T), array);
}

/// Returns the number of base64 characters, with padding, that encode this many bytes.
std::size_t text_size(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

std::string without_blanks(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text)
    if (c != ' ' && !(c >= '\t' && c <= '\r')) result += c;
  return result;
}

}  // namespace

VtkArray VtpArrays::read(const pugi::xml_node& element) const {
  VtkArray array;
  array.name = element.attribute("Name").value();
  array.components = element.attribute("NumberOfComponents").as_uint(1);
  const std::string type = element.attribute("type").value();
  const std::string format = element.attribute("format").value();
  const std::string what = "the array " + in_quotes(array.name);
  if (array.components == 0) source_.fail(what + " has no components");
  if (!with_xml_type(type, [](auto) {}))
    source_.fail(what + " has the type " + in_quotes(type) + ", which is not supported");
  if (format == "ascii") {
    read_text(element, array);
    with_xml_type(type, [&](auto zero) { set_type_of<decltype(zero)>(array); });
  } else if (format == "binary" || format == "appended") {
    set_numbers(type, bytes_of(element, what), array);
  } else {
    source_.fail(what + " has the unknown format " + in_quotes(format));
  }
  return array;
}

std::vector<std::uint64_t> VtpArrays::indices(const pugi::xml_node& element) const {
  const VtkArray array = read(element);
  std::vector<std::uint64_t> result;
  result.reserve(array.values.size());
  constexpr double most = 9007199254740992.0;  // 2^53: doubles represent all smaller integers
  for (const double value : array.values) {
    if (!(value >= 0 && value <= most) || value != std::floor(value))
      source_.fail("the array " + in_quotes(array.name) +
                   " has an index that is not a whole number of 0 or more");
    result.push_back(static_cast<std::uint64_t>(value));
  }
  return result;
}

void VtpArrays::read_text(const pugi::xml_node& element, VtkArray& array) const {
  const std::string_view text = element.text().get();
  const char* first = text.data();
  const char* const last = first + text.size();
  const auto is_blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  for (;;) {
    first = std::find_if_not(first, last, is_blank);
    if (first == last) return;
    const char* const end = std::find_if(first, last, is_blank);
    const std::string_view word(first, static_cast<std::size_t>(end - first));
    double value = 0;
    const Parsed parsed = parse_number(first, end, value);
    if (parsed == Parsed::malformed || first != end)
      source_.fail("number " + std::to_string(array.values.size()) + " of the array " +
                   in_quotes(array.name) + " is " + in_quotes(word));
    array.values.push_back(parsed == Parsed::ok ? value : std::nan(""));
  }
}

// --- Bytes ---------------------------------------------------------------------------------------

/// Returns the decoded bytes of a DataArray element. In base64, the header and the blocks of a
/// compressed array are encoded separately, one after the other.
std::string VtpArrays::bytes_of(const pugi::xml_node& element, const std::string& what) const {
  std::string_view data = element.text().get();
  bool is_text = true;
  if (std::string_view(element.attribute("format").value()) == "appended") {
    const std::uint64_t offset = element.attribute("offset").as_ullong();
    if (offset > encoding_.appended.size()) source_.fail(what + " starts beyond the appended data");
    data = encoding_.appended.substr(offset);
    is_text = encoding_.is_appended_text;
  }
  if (!is_text && !encoding_.is_compressed) return plain_block(data, what);
  if (!is_text) {
    const std::uint64_t blocks = header_number(data, 0, what);
    if (blocks > data.size()) source_.fail(what + " announces more blocks than there are bytes");
    const std::size_t size = header_size() * (3 + blocks);
    return compressed_blocks(data, data.substr(std::min(size, data.size())), what);
  }
  const std::string text = without_blanks(data);
  const std::string start =
      decoded(std::string_view(text).substr(0, text_size(header_size())), what);
  const std::uint64_t first = header_number(start, 0, what);
  if (first > text.size()) source_.fail(what + " announces more than there are bytes");
  if (!encoding_.is_compressed)
    return plain_block(
        decoded(std::string_view(text).substr(0, text_size(header_size() + first)), what), what);
  const std::size_t size = text_size(header_size() * (3 + first));
  const std::string header = decoded(std::string_view(text).substr(0, size), what);
  const std::string_view rest = std::string_view(text).substr(std::min(size, text.size()));
  return compressed_blocks(header, decoded(rest.substr(0, rest.find('=')), what), what);
}

std::string VtpArrays::decoded(std::string_view text, const std::string& what) const {
  std::optional<std::string> bytes = bytes_of_base64(text);
  if (!bytes) source_.fail(what + " is no base64");
  return std::move(*bytes);
}

std::uint64_t VtpArrays::header_number(std::string_view bytes, std::size_t index,
                                       const std::string& what) const {
  const std::size_t at = index * header_size();
  if (bytes.size() < header_size() || at > bytes.size() - header_size())
    source_.fail(what + " is cut off in its header");
  const bool swapped = encoding_.is_big_endian == host_is_little;
  if (encoding_.has_wide_headers) return load_scalar<std::uint64_t>(bytes.data() + at, swapped);
  return load_scalar<std::uint32_t>(bytes.data() + at, swapped);
}

std::string VtpArrays::plain_block(std::string_view bytes, const std::string& what) const {
  const std::uint64_t size = header_number(bytes, 0, what);
  bytes.remove_prefix(header_size());
  if (size > bytes.size())
    source_.fail(what + " announces " + counted(size, "byte") + ", but there are " +
                 std::to_string(bytes.size()));
  return std::string(bytes.substr(0, size));
}

/// Decompresses the blocks of an array. The header has the number of blocks, the size of a block,
/// and the size of the last block if it is smaller (else 0). The compressed size of each block
/// follows.
std::string VtpArrays::compressed_blocks(std::string_view header, std::string_view data,
                                         const std::string& what) const {
  const std::uint64_t blocks = header_number(header, 0, what);
  if (blocks == 0) return {};
  const std::uint64_t size = header_number(header, 1, what);
  const std::uint64_t last = header_number(header, 2, what);
  std::string bytes;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t stored = header_number(header, 3 + i, what);
    if (stored > data.size()) source_.fail(what + " is cut off in block " + std::to_string(i));
    const std::uint64_t full = i + 1 == blocks && last > 0 ? last : size;
    budget_.spend(full);
    const std::string block = expand_zlib(source_, data.substr(0, stored), full, what);
    if (block.size() != full)
      source_.fail(what + " has a block whose size differs from the announced one");
    bytes += block;
    data.remove_prefix(stored);
  }
  return bytes;
}

void VtpArrays::set_numbers(const std::string& type, std::string_view bytes,
                            VtkArray& array) const {
  const bool swapped = encoding_.is_big_endian == host_is_little;
  with_xml_type(type, [&](auto zero) {
    using T = decltype(zero);
    if (bytes.size() % sizeof(T) != 0)
      source_.fail("the array " + in_quotes(array.name) + " ends within a number");
    array.values.reserve(bytes.size() / sizeof(T));
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(T))
      array.values.push_back(static_cast<double>(load_scalar<T>(bytes.data() + at, swapped)));
    set_type_of<T>(array);
  });
}

}  // namespace transformesh
