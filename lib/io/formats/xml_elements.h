/// Elements of XML files, parsed by pugixml.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "io/streams/source.h"

namespace transformesh {

/// Parses a whole file. Throws InputError with the line if it is not well-formed.
pugi::xml_document parse_xml(const Source& source);

/// Returns the elements with this name below a node, at any depth, in the order of the file.
std::vector<pugi::xml_node> xml_elements(const pugi::xml_node& node, const char* name);

/// Returns the first element with this name below a node, at any depth, or a null node.
pugi::xml_node xml_element(const pugi::xml_node& node, const char* name);

/// Returns the value of an attribute, if present.
std::optional<std::string> xml_attribute(const pugi::xml_node& element, const char* name);

/// Parses finite numbers separated by blanks. Throws InputError, naming `what`, for other text.
std::vector<double> xml_numbers(const std::string& text, const std::string& what,
                                const Source& source);

}  // namespace transformesh
