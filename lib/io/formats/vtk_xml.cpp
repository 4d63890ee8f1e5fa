#include "io/formats/vtk_xml.h"

#include "io/formats/xml_elements.h"

namespace transformesh {

/// Parses the XML, and finds the appended data, which starts after an underscore in its element.
VtkXml parse_vtk_xml(const Source& source) {
  const std::string_view bytes = source.bytes;
  const std::size_t start = bytes.find("<AppendedData");
  if (start == std::string_view::npos) return {parse_xml(source), {}, false};
  const std::size_t end = bytes.find('>', start);
  const std::size_t mark = end == std::string_view::npos ? end : bytes.find('_', end);
  if (mark == std::string_view::npos)
    source.fail_at_byte(source.begin() + start, "the appended VTP data does not start with '_'");
  const bool is_text = bytes.substr(start, end - start).find("base64") != std::string_view::npos;
  std::string_view appended = bytes.substr(mark + 1);
  if (is_text) appended = appended.substr(0, appended.find('<'));
  const std::string xml = std::string(bytes.substr(0, start)) + "</VTKFile>";
  return {parse_xml({xml, source.name}), appended, is_text};
}

VtpEncoding VtkXml::encoding(const Source& source) const {
  VtpEncoding encoding;
  encoding.is_big_endian = std::string_view(root().attribute("byte_order").value()) == "BigEndian";
  encoding.has_wide_headers = std::string_view(root().attribute("header_type").value()) == "UInt64";
  const std::string_view compressor = root().attribute("compressor").value();
  encoding.is_compressed = !compressor.empty();
  if (encoding.is_compressed && compressor != "vtkZLibDataCompressor")
    source.fail("the data is compressed by " + in_quotes(compressor) +
                ", which is not supported: only vtkZLibDataCompressor is");
  encoding.appended = appended;
  encoding.is_appended_text = is_appended_text;
  return encoding;
}

bool is_vtk_xml(std::string_view bytes) {
  // Number of bytes in which the first element is searched. An XML declaration and comments may
  // precede it.
  constexpr std::size_t searched = 1024;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '<' &&
         bytes.substr(0, searched).find("<VTKFile") != std::string_view::npos;
}

}  // namespace transformesh
