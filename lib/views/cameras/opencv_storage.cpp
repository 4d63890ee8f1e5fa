#include "views/cameras/opencv_storage.h"

#include <algorithm>
#include <cmath>

#include "io/formats/text_rows.h"

namespace transformesh {
namespace {

constexpr std::string_view separating_blanks = " \t\r\n";

}  // namespace

OpencvStorage::OpencvStorage(const Source& source, std::string suffix)
    : source_(source),
      suffix_(std::move(suffix)),
      is_xml_(source.bytes.find("<opencv_storage") != std::string_view::npos) {}

std::optional<OpencvStorage::Entries> OpencvStorage::find(Keys keys) const {
  for (const char* key : keys)
    if (const auto text = text_of(key + suffix_)) return numbers_in(*text, key);
  return {};
}

OpencvStorage::Entries OpencvStorage::get(Keys keys) const {
  if (auto entries = find(keys)) return *entries;
  source_.fail(std::string("the OpenCV file has no ") + *keys.begin() + suffix_);
}

int OpencvStorage::side(const char* key) const {
  auto entries = find({key});
  if (!entries && !suffix_.empty()) entries = OpencvStorage(source_).find({key});
  return entries && entries->size() == 1 && entries->front() >= 1 && entries->front() <= 1e9
             ? static_cast<int>(entries->front())
             : 0;
}

std::vector<std::string> OpencvStorage::matrix_keys() const {
  const std::string_view mark = is_xml_ ? "type_id=\"opencv-matrix\"" : "!!opencv-matrix";
  std::vector<std::string> keys;
  for (std::size_t at = source_.bytes.find(mark); at != std::string_view::npos;
       at = source_.bytes.find(mark, at + 1)) {
    std::string_view before = source_.bytes.substr(0, at);
    before = before.substr(0, before.find_last_not_of(is_xml_ ? " \t" : " \t:") + 1);
    const std::size_t start = before.find_last_of(is_xml_ ? "<" : separating_blanks);
    if (keys.size() == most_cameras) fail("the OpenCV file has more than 1000 matrices");
    keys.emplace_back(before.substr(start == std::string_view::npos ? 0 : start + 1));
  }
  return keys;
}

std::size_t OpencvStorage::value_of(const std::string& key) const {
  const std::string_view text = source_.bytes;
  const std::string start = is_xml_ ? "<" + key : key + ":";
  for (std::size_t at = text.find(start); at != std::string_view::npos;
       at = text.find(start, at + 1)) {
    const std::size_t end = at + start.size();
    const bool is_whole =
        is_xml_ ? end < text.size() && (text[end] == '>' || text[end] == ' ')
                : at == 0 || separating_blanks.find(text[at - 1]) < separating_blanks.size();
    if (is_whole) return is_xml_ ? text.find('>', end) + 1 : end;
  }
  return std::string_view::npos;
}

std::optional<std::string_view> OpencvStorage::text_of(const std::string& key) const {
  const std::size_t value = value_of(key);
  if (value == std::string_view::npos) return {};
  std::string_view rest = source_.bytes.substr(std::min(value, source_.bytes.size()));
  if (is_xml_) {
    rest = rest.substr(0, rest.find("</" + key));
    const std::size_t data = rest.find("<data>");
    return data == std::string_view::npos ? rest
                                          : rest.substr(data + 6, rest.find("</data") - data - 6);
  }
  const std::size_t first = std::min(rest.find_first_not_of(" \t"), rest.size());
  const std::string_view line = rest.substr(first, rest.find_first_of("\r\n", first) - first);
  if (!line.starts_with('!') && !line.empty() && !line.starts_with('[')) return line;
  const std::size_t open = rest.find('[');
  const std::size_t close = rest.find(']');
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) return {};
  return rest.substr(open + 1, close - open - 1);
}

OpencvStorage::Entries OpencvStorage::numbers_in(std::string_view text,
                                                 const std::string& key) const {
  const std::string separators = std::string(separating_blanks) + ',';
  Entries entries;
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
    if (text.empty()) return entries;
    const std::string_view word = text.substr(0, text.find_first_of(separators));
    const char* first = word.data();
    double value = 0;
    const bool is_read =
        parse_number(first, word.data() + word.size(), value) == Parsed::ok && std::isfinite(value);
    if (!is_read || first != word.data() + word.size())
      source_.fail(key + " of the OpenCV file has " + in_quotes(word) +
                   ", which is not a finite number");
    entries.push_back(value);
    text.remove_prefix(word.size());
  }
}

}  // namespace transformesh
