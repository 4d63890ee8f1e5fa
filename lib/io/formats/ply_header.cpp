#include <algorithm>
#include <unordered_set>

#include "io/document/scalar.h"
#include "io/formats/ply.h"
#include "io/streams/number_text.h"
#include "support/lower_case.h"

namespace transformesh {
namespace {

class HeaderReader {
 public:
  explicit HeaderReader(const Source& source) : source_(source), place_(source.begin()) {}

  PlyHeader read() {
    next_line();
    if (!is_line("ply")) fail("a PLY file starts with the line 'ply', not " + in_quotes(line_));
    for (next_line(); !is_line("end_header"); next_line()) read_line();
    if (!has_format_) {
      fail(
          "the PLY header has no line 'format ascii 1.0' (or binary_little_endian, "
          "binary_big_endian)");
    }
    header_.size = static_cast<std::size_t>(place_ - source_.begin());
    for (const PlyElement& element : header_.elements) {
      header_.style.element_order.push_back(element.name);
    }
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { source_.fail_at_line(line_start_, what); }

  /// Moves to the next line. Accepts line ends of Unix, DOS and old Macintoshes; the end of the
  /// first line decides which.
  void next_line() {
    line_start_ = place_;
    const std::string_view rest =
        source_.bytes.substr(static_cast<std::size_t>(place_ - source_.begin()));
    if (line_start_ == source_.begin()) {
      const std::size_t first_end = std::min(rest.find_first_of("\r\n"), rest.size());
      const std::string_view ending = rest.substr(first_end, 2);
      is_mac_ = !ending.empty() && ending[0] == '\r' && ending != "\r\n";
    }
    const std::size_t length = rest.find(is_mac_ ? '\r' : '\n');
    if (length == std::string_view::npos) fail("the PLY header has no line 'end_header'");
    place_ += length + 1;
    line_ = rest.substr(0, length);
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    words_ = line_;
  }

  /// True if the line consists of this word, optionally followed by blanks.
  bool is_line(std::string_view word) const {
    return line_.starts_with(word) &&
           line_.find_first_not_of(" \t", word.size()) == std::string_view::npos;
  }

  std::string_view next_word() {
    const std::size_t first = std::min(words_.find_first_not_of(" \t"), words_.size());
    const std::size_t last = std::min(words_.find_first_of(" \t", first), words_.size());
    const std::string_view word = words_.substr(first, last - first);
    words_.remove_prefix(last);
    return word;
  }

  void read_line() {
    const std::string_view keyword = next_word();
    if (keyword == "format") {
      read_format();
    } else if (keyword == "comment") {
      header_.style.comments.push_back(rest_of_line());
    } else if (keyword == "obj_info") {
      header_.style.obj_info.push_back(rest_of_line());
    } else if (keyword == "element") {
      read_element();
    } else if (keyword == "property") {
      read_property();
    } else if (!keyword.empty()) {
      read_unknown(keyword);
    }
  }

  /// Handles a line with an unknown keyword. Before the first element, such a line can only be a
  /// comment without keyword. After the first element, it may describe data, so it is an error.
  void read_unknown(std::string_view keyword) {
    if (source_.is_strict || !header_.elements.empty())
      fail("unknown word in the PLY header: " + in_quotes(keyword));
    header_.style.comments.emplace_back(line_);
    ++header_.unmarked_comments;
  }

  void read_format() {
    const std::string_view encoding = next_word();
    Format& format = header_.style.format;
    if (encoding == "ascii") {
      format = Format::ply_ascii;
    } else if (encoding == "binary_little_endian") {
      format = Format::ply_little;
    } else if (encoding == "binary_big_endian") {
      format = Format::ply_big;
    } else {
      fail("PLY is ascii, binary_little_endian or binary_big_endian, not " + in_quotes(encoding));
    }
    const std::string_view version = next_word();
    if (version != "1.0") fail("only PLY version 1.0 is supported, not " + in_quotes(version));
    has_format_ = true;
  }

  std::string rest_of_line() const {
    return std::string(words_.substr(std::min<std::size_t>(words_.size(), 1)));
  }

  void read_element() {
    PlyElement element;
    element.name = next_word();
    const std::string_view count = next_word();
    const char* first = count.data();
    const char* last = first + count.size();
    const Parsed parsed = parse_number(first, last, element.rows);
    if (element.name.empty() || parsed != Parsed::ok || first != last) {
      fail("'element NAME COUNT' needs a name and a count of 0 or more, not " + in_quotes(line_));
    }
    if (!names_.insert(element.name).second)
      fail("the element " + in_quotes(element.name) + " is listed twice");
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    if (header_.elements.empty()) fail("there is a property before the first element");
    PlyProperty property;
    std::string_view type = next_word();
    if (type == "list") {
      property.count_type = read_type(next_word());
      if (is_floating(*property.count_type)) fail("the count of a list must have an integer type");
      type = next_word();
    }
    property.type = read_type(type);
    property.name = next_word();
    if (property.name.empty()) fail("a property has no name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  Scalar read_type(std::string_view name) {
    const std::string lower = lower_case(name);
    const auto type = scalar_of_name(lower);
    if (!type || (source_.is_strict && lower != name)) {
      fail("unknown type " + in_quotes(name) +
           "; PLY has char uchar short ushort int uint float double");
    }
    if (scalar_name(*type, true) == lower) header_.style.sized_type_names = true;
    return *type;
  }

  const Source& source_;
  const char* place_;
  const char* line_start_ = nullptr;
  bool is_mac_ = false;
  bool has_format_ = false;
  std::string_view line_;
  std::string_view words_;  ///< words of the current line that were not read yet
  PlyHeader header_;
  /// Names of the elements that the header has declared so far.
  std::unordered_set<std::string> names_;
};

void add_header_line(const std::string& keyword, std::string text, std::string& header) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  header += keyword + (text.empty() ? "" : " ") + text + '\n';
}

}  // namespace

std::string ply_header_text(const Style& style, const std::vector<PlyElement>& elements) {
  const auto name_of = [&](Scalar type) {
    return std::string(scalar_name(type, style.sized_type_names)) + ' ';
  };
  std::string header = "ply\nformat ";
  header += style.format == Format::ply_ascii ? "ascii"
            : style.format == Format::ply_big ? "binary_big_endian"
                                              : "binary_little_endian";
  header += " 1.0\n";
  for (const std::string& comment : style.comments) add_header_line("comment", comment, header);
  for (const std::string& info : style.obj_info) add_header_line("obj_info", info, header);
  for (const PlyElement& element : elements) {
    header += "element " + element.name + ' ' + std::to_string(element.rows) + '\n';
    for (const PlyProperty& property : element.properties) {
      header += "property ";
      if (property.count_type) header += "list " + name_of(*property.count_type);
      header += name_of(property.type) + property.name + '\n';
    }
  }
  return header + "end_header\n";
}

PlyHeader read_ply_header(const Source& source) { return HeaderReader(source).read(); }

}  // namespace transformesh
