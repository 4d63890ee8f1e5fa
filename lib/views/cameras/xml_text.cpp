#include "views/cameras/xml_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/number.h"

namespace transformesh {
namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr auto npos = std::string_view::npos;

bool is_blank(char c) { return blanks.find(c) != npos; }

/// Where the tag that begins there ends: a > outside of quotes.
std::size_t end_of_tag(std::string_view text, std::size_t begin) {
  char quote = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i;
    }
  }
  return npos;
}

/// Where an element of the name begins, from `from` on.
std::size_t find_start(std::string_view text, const std::string& start, std::size_t from) {
  for (std::size_t at = text.find(start, from); at != npos; at = text.find(start, at + 1)) {
    const std::size_t end = at + start.size();
    if (end < text.size() && (is_blank(text[end]) || text[end] == '>' || text[end] == '/'))
      return at;
  }
  return npos;
}

std::string without_entities(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, char>, 5> entities{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
  std::string result;
  while (!text.empty()) {
    const auto* const found =
        std::find_if(entities.begin(), entities.end(),
                     [&](const auto& entity) { return text.starts_with(entity.first); });
    const bool is_entity = found != entities.end();
    result += is_entity ? found->second : text.front();
    text.remove_prefix(is_entity ? found->first.size() : 1);
  }
  return result;
}

}  // namespace

std::string without_xml_comments(std::string_view text) {
  std::string result(text);
  for (std::size_t at = result.find("<!--"); at != std::string::npos;
       at = result.find("<!--", at)) {
    const std::size_t end = std::min(result.find("-->", at + 4), result.size() - 3) + 3;
    std::replace_if(
        result.begin() + static_cast<std::ptrdiff_t>(at),
        result.begin() + static_cast<std::ptrdiff_t>(end), [](char c) { return c != '\n'; }, ' ');
  }
  return result;
}

std::vector<XmlElement> xml_elements(std::string_view text, std::string_view name) {
  const std::string start = '<' + std::string(name);
  const std::string finish = "</" + std::string(name);
  std::vector<XmlElement> elements;
  std::size_t at = find_start(text, start, 0);
  while (at != npos) {
    const std::size_t end = end_of_tag(text, at);
    if (end == npos) break;
    XmlElement element{text.substr(at + 1, end - at - 1), {}};
    std::size_t next = end;
    if (!element.tag.ends_with('/')) {
      next = find_start(text, finish, end);
      if (next == npos) break;  // the text ends within the element
      element.text = text.substr(end + 1, next - end - 1);
    }
    elements.push_back(element);
    at = find_start(text, start, next);
  }
  return elements;
}

std::optional<XmlElement> xml_element(std::string_view text, std::string_view name) {
  const std::vector<XmlElement> elements = xml_elements(text, name);
  return elements.empty() ? std::nullopt : std::optional(elements.front());
}

std::optional<std::string> xml_attribute(const XmlElement& element, std::string_view name) {
  const std::string_view tag = element.tag;
  for (std::size_t at = tag.find(name); at != npos; at = tag.find(name, at + 1)) {
    const std::size_t equals = tag.find_first_not_of(blanks, at + name.size());
    if (at == 0 || !is_blank(tag[at - 1]) || equals == npos || tag[equals] != '=') continue;
    const std::size_t open = tag.find_first_not_of(blanks, equals + 1);
    if (open == npos || (tag[open] != '"' && tag[open] != '\'')) return {};
    const std::size_t close = tag.find(tag[open], open + 1);
    if (close == npos) return {};
    return without_entities(tag.substr(open + 1, close - open - 1));
  }
  return {};
}

std::vector<double> xml_numbers(std::string_view text, const std::string& what,
                                const Source& source) {
  std::vector<double> numbers;
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    if (text.empty()) return numbers;
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    const auto number = number_in<double>(word);
    if (!number || !std::isfinite(*number))
      source.fail(what + " has " + quoted(word) + ", which is no finite number");
    numbers.push_back(*number);
    text.remove_prefix(word.size());
  }
}

}  // namespace transformesh
