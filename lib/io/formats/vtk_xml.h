/// Parses files of VTK's XML format: the XML, and binary data that is appended to it.
#pragma once

#include <pugixml.hpp>
#include <string_view>

#include "io/formats/vtp_arrays.h"
#include "io/streams/source.h"

namespace transformesh {

struct VtkXml {
  pugi::xml_document document;
  std::string_view appended;
  bool is_appended_text = false;

  pugi::xml_node root() const { return document.child("VTKFile"); }
  /// Returns how the file encodes numbers. Throws InputError for an unknown compression.
  VtpEncoding encoding(const Source& source) const;
};

/// Parses a file of VTK's XML format. The result refers to the bytes of the source. Throws
/// InputError.
VtkXml parse_vtk_xml(const Source& source);

/// True if the bytes are XML whose first element is `VTKFile`.
bool is_vtk_xml(std::string_view bytes);

}  // namespace transformesh
