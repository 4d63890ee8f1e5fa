#include "io/formats/xml_elements.h"

#include <cmath>
#include <sstream>

#include "support/number.h"

namespace transformesh {
namespace {

/// Returns the next node below `top` in document order.
pugi::xml_node next_node(pugi::xml_node node, const pugi::xml_node& top) {
  if (const pugi::xml_node child = node.first_child()) return child;
  while (node != top && !node.next_sibling()) node = node.parent();
  return node == top ? pugi::xml_node() : node.next_sibling();
}

}  // namespace

pugi::xml_document parse_xml(const Source& source) {
  pugi::xml_document document;
  const pugi::xml_parse_result result =
      document.load_buffer(source.bytes.data(), source.bytes.size());
  if (result) return document;
  const auto place = std::min(static_cast<std::size_t>(result.offset), source.bytes.size());
  source.fail_at_line(source.begin() + place,
                      "XML is not well-formed: " + std::string(result.description()));
}

std::vector<pugi::xml_node> xml_elements(const pugi::xml_node& node, const char* name) {
  std::vector<pugi::xml_node> elements;
  for (pugi::xml_node next = next_node(node, node); next; next = next_node(next, node))
    if (std::string_view(next.name()) == name) elements.push_back(next);
  return elements;
}

pugi::xml_node xml_element(const pugi::xml_node& node, const char* name) {
  const std::vector<pugi::xml_node> elements = xml_elements(node, name);
  return elements.empty() ? pugi::xml_node() : elements.front();
}

std::optional<std::string> xml_attribute(const pugi::xml_node& element, const char* name) {
  const pugi::xml_attribute attribute = element.attribute(name);
  return attribute ? std::optional<std::string>(attribute.value()) : std::nullopt;
}

std::vector<double> xml_numbers(const std::string& text, const std::string& what,
                                const Source& source) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const auto number = number_in<double>(word);
    if (!number || !std::isfinite(*number))
      source.fail(what + " has " + in_quotes(word) + ", which is not a finite number");
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace transformesh
