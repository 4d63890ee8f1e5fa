/// DataArray elements of the VTK XML format: numbers as text, in base64, or in appended data.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/vtk_data.h"
#include "io/streams/expand.h"
#include "io/streams/source.h"

namespace transformesh {

/// Encoding of numbers in a VTK XML file, as stated by the attributes of its first element.
struct VtpEncoding {
  bool is_big_endian = false;
  /// True if the headers of arrays have 64-bit instead of 32-bit numbers.
  bool has_wide_headers = false;
  bool is_compressed = false;     ///< true if arrays are stored in zlib-compressed blocks
  bool is_appended_text = false;  ///< true if appended data is encoded in base64
  std::string_view appended{};
};

class VtpArrays {
 public:
  VtpArrays(const Source& source, const VtpEncoding& encoding, ExpansionBudget& budget)
      : source_(source), encoding_(encoding), budget_(budget) {}

  /// Returns the array that a DataArray element contains. Throws InputError if it cannot be
  /// decoded.
  VtkArray read(const pugi::xml_node& element) const;
  /// Returns the numbers of a DataArray element, which must be nonnegative integers. Throws
  /// InputError otherwise.
  std::vector<std::uint64_t> indices(const pugi::xml_node& element) const;

 private:
  void read_text(const pugi::xml_node& element, VtkArray& array) const;
  std::string bytes_of(const pugi::xml_node& element, const std::string& what) const;
  std::string decoded(std::string_view text, const std::string& what) const;
  std::string plain_block(std::string_view bytes, const std::string& what) const;
  std::string compressed_blocks(std::string_view header, std::string_view data,
                                const std::string& what) const;
  std::uint64_t header_number(std::string_view bytes, std::size_t index,
                              const std::string& what) const;
  std::size_t header_size() const { return encoding_.has_wide_headers ? 8 : 4; }
  void set_numbers(const std::string& type, std::string_view bytes, VtkArray& array) const;

  const Source& source_;
  VtpEncoding encoding_;
  ExpansionBudget& budget_;
};

}  // namespace transformesh
