/// The little of XML that camera files need: elements by their names, with attributes and text.
/// Internal to the formats. Entities beyond the five of every XML text stay as they are, and an
/// element does not hold one of its own name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/streams/source.h"

namespace transformesh {

struct XmlElement {
  std::string_view tag;   ///< between < and >: the name and the attributes
  std::string_view text;  ///< what it holds; empty for one that ends where it begins
};

/// The text without its comments, each replaced by blanks.
std::string without_xml_comments(std::string_view text);

/// The elements of that name in the text, at any depth, in order.
std::vector<XmlElement> xml_elements(std::string_view text, std::string_view name);

/// The first one.
std::optional<XmlElement> xml_element(std::string_view text, std::string_view name);

/// The value of an attribute.
std::optional<std::string> xml_attribute(const XmlElement& element, std::string_view name);

/// The finite numbers that blanks divide. Throws InputError, which names `what`, for other text.
std::vector<double> xml_numbers(std::string_view text, const std::string& what,
                                const Source& source);

}  // namespace transformesh
