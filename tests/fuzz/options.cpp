// Command lines, one argument per line, for a program with every kind of option. They are parsed or
// refused by a UsageError, and the provenance comment is parsed to the same values.
#include "frame/limits.h"
#include "frame/program.h"
#include "fuzz/fuzz.h"
#include "transformesh/errors.h"
#include "transformesh/length.h"

using namespace transformesh;
using namespace transformesh::fuzz;

namespace {

struct Values {
  bool flag = false;
  double number = 1;
  long integer = 2;
  std::optional<long> optional_integer;
  Length length;
  std::optional<Length> optional_length;
  std::string text, choice = "one";
  std::vector<double> numbers;
  std::uint64_t seed = 1;
};

class FuzzedProgram {
 public:
  FuzzedProgram() {
    program_.options.flag("flag,f", &values_.flag, "a flag");
    program_.options.number("number,n", &values_.number, -10, 1e9, "a number");
    program_.options.integer("integer", &values_.integer, 0, 1000, "an integer");
    program_.options.integer("optional-integer", &values_.optional_integer, -5, 5, "perhaps one");
    program_.options.length("length", &values_.length, "a length", true);
    program_.options.length("optional-length,l", &values_.optional_length, "perhaps one");
    program_.options.text("text,t", &values_.text, "COLUMN", "a text");
    program_.options.choice("choice", &values_.choice, {"one", "two", "three"}, "a choice");
    program_.options.numbers("numbers", &values_.numbers, "X,Y,Z", "three numbers");
    program_.options.seed(&values_.seed);
    program_.reference_edge();
  }
  tool::Program& program() { return program_; }

 private:
  Values values_;
  tool::Program program_{"tm-fuzz", "[OPTION]... [INPUT]", "Is no program"};
};

std::vector<std::string> lines_of(std::string_view bytes) {
  std::vector<std::string> lines;
  while (!bytes.empty()) {
    const std::size_t length = std::min(bytes.find('\n'), bytes.size());
    lines.emplace_back(bytes.substr(0, length));
    bytes.remove_prefix(std::min(length + 1, bytes.size()));
  }
  return lines;
}

/// The text of an option in settings and provenance must be accepted as its value again.
void check_texts(const tool::Program& parsed) {
  std::vector<std::string> arguments;
  for (const tool::Option& option : parsed.options) {
    if (!option.is_given) continue;
    const bool has_text = !option.is_flag() && !option.text().empty();
    arguments.push_back("--" + option.name() + (has_text ? "=" + option.text() : ""));
    if (!option.is_flag() && !has_text) arguments.emplace_back();
  }
  FuzzedProgram again;
  again.program().options.parse(arguments);
  for (std::size_t i = 0; i < parsed.options.size(); ++i)
    demand(parsed.options[i].text() == again.program().options[i].text(),
           "--" + parsed.options[i].name() + " is not what it was");
}

template <class Parse>
void check_word(const Parse& parse) {
  try {
    parse();
  } catch (const UsageError&) {
  }
}

}  // namespace

void transformesh::fuzz::run_target(std::string_view bytes) {
  const std::vector<std::string> arguments = lines_of(bytes);
  for (const std::string& word : arguments) {
    check_word([&] { tool::parse_size(word); });
    check_word([&] {
      const Length length = parse_length(word);
      demand(parse_length(length.text()).value == length.value, "another length: " + word);
    });
  }
  FuzzedProgram fuzzed;
  try {
    fuzzed.program().options.parse(arguments);
  } catch (const UsageError&) {
    return;
  }
  demand(tool::provenance(fuzzed.program()).find('\n') == std::string::npos, "a line end");
  check_texts(fuzzed.program());
}
