#include "option_table.h"

#include <doctest/doctest.h>

#include "command.h"
#include "tm/support/error.h"

using namespace transformesh;
using namespace transformesh::tool;

namespace {

struct Values {
  bool flag = false;
  double number = 0.5;
  long integer = 3;
  Length length{0.7, Length::Unit::reference_edge};
  std::optional<Length> gap;
  std::string kind = "valence";
  std::string file;
  std::vector<double> point;
};

OptionTable make_table(Values& values) {
  OptionTable table;
  table.add(flag_option("flag", &values.flag, "a flag"));
  table.add(number_option("number", &values.number, 0, 1, "a number"));
  table.add(integer_option("integer", &values.integer, 1, 9, "an integer"));
  table.add(length_option("length", &values.length, "a length", false));
  table.add(length_option("gap", &values.gap, "a signed length", true));
  table.add(choice_option("kind", &values.kind, {"valence", "angle"}, "a kind"));
  table.add(text_option("file", &values.file, "FILE", "a file"));
  table.add(numbers_option("point", &values.point, "X,Y,Z", "a point"));
  return table;
}

// The message with which parsing these arguments is refused.
std::string refusal(const std::vector<std::string>& arguments) {
  Values values;
  OptionTable table = make_table(values);
  try {
    table.parse(arguments);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("options set their variables, and the other words are returned in order") {
  Values values;
  OptionTable table = make_table(values);
  const auto words = table.parse({"one", "--flag", "--number=0.25", "--integer", "9", "-", "--gap",
                                  "-2%", "--kind", "angle", "--point", "1,-2.5,3e2", "--file",
                                  "a b.ply", "--", "--number"});
  CHECK(words == std::vector<std::string>{"one", "-", "--number"});
  CHECK(values.flag);
  CHECK(values.number == 0.25);
  CHECK(values.integer == 9);
  CHECK(values.gap->value == -0.02);
  CHECK(values.gap->unit == Length::Unit::diagonal);
  CHECK(values.kind == "angle");
  CHECK(values.file == "a b.ply");
  CHECK(values.point == std::vector<double>{1, -2.5, 300});
  CHECK(values.length.text() == "0.7x");
  CHECK(table.find("number")->given);
  CHECK_FALSE(table.find("--length")->given);
}

TEST_CASE("the last of several values counts") {
  Values values;
  OptionTable table = make_table(values);
  table.parse({"--integer", "2", "--integer", "4"});
  CHECK(values.integer == 4);
}

TEST_CASE("defaults are what the variables hold") {
  Values values;
  OptionTable table = make_table(values);
  CHECK(table.find("number")->default_text == "0.5");
  CHECK(table.find("length")->default_text == "0.7x");
  CHECK(table.find("gap")->default_text == "");
  CHECK(table.find("flag")->default_text == "");
}

TEST_CASE("an unknown option names the nearest") {
  CHECK(refusal({"--numbr", "1"}) == "unknown option '--numbr'; did you mean '--number'?");
  CHECK(refusal({"--lenght=2"}) == "unknown option '--lenght=2'; did you mean '--length'?");
  CHECK(refusal({"--num", "1"}) == "unknown option '--num'; did you mean '--number'?");
  CHECK(refusal({"-x"}).starts_with("unknown option '-x'; did you mean '--"));
}

TEST_CASE("a bad value names the option, the value and what is allowed") {
  CHECK(refusal({"--number", "1.5"}) == "--number: '1.5' is too large: at most 1");
  CHECK(refusal({"--number", "-1"}) == "--number: '-1' is too small: at least 0");
  CHECK(refusal({"--number", "1x"}) == "--number: '1x' is not a number");
  CHECK(refusal({"--number", "nan"}) == "--number: 'nan' is not a finite number");
  CHECK(refusal({"--number", "0,5"}) == "--number: '0,5' is not a number");
  CHECK(refusal({"--integer", "2.5"}) == "--integer: '2.5' is not a whole number");
  CHECK(refusal({"--integer", "99999999999999999999"}).find("not a whole number") !=
        std::string::npos);
  CHECK(refusal({"--length", "-1"}) == "--length: '-1' is too small: a length of at least 0");
  CHECK(refusal({"--length", "2m"}).starts_with("--length: '2m' is not a length"));
  CHECK(refusal({"--kind", "angel"}) ==
        "--kind: 'angel' is not known; did you mean 'angle'? (valence, angle)");
  CHECK(refusal({"--point", "1,2"}).starts_with("--point: '1,2' is not 3 numbers with commas"));
  CHECK(refusal({"--point", "1,2,"}) == "--point: '' is not a number");
}

TEST_CASE("missing and superfluous values are told") {
  CHECK(refusal({"--number"}) == "--number needs a value");
  CHECK(refusal({"--number", "--flag"}) == "--number needs a value");
  CHECK(refusal({"--number="}) == "--number needs a value");
  CHECK(refusal({"--flag=1"}) == "--flag takes no value");
}

TEST_CASE("short options of the common section") {
  Command command{"tm-x", "", ""};
  add_common_options(command);
  const CommonOptions& values = command.common;
  OptionTable& table = command.table;
  table.parse({"-qo", "a.ply", "--threads", "2", "--reference-edge", "auto"});
  CHECK(values.quiet);
  CHECK(values.output == "a.ply");
  CHECK(values.threads == 2);
  CHECK(values.reference_edge == "auto");
  CHECK_THROWS_AS(table.parse({"--reference-edge", "0"}), UsageError);
  CHECK_THROWS_AS(table.parse({"--reference-edge", "often"}), UsageError);
}

TEST_CASE("options that contradict each other are refused") {
  CommonOptions values;
  CHECK_NOTHROW(check_common_options(values));
  values.as_float = values.as_double = true;
  CHECK_THROWS_AS(check_common_options(values), UsageError);
  values = {};
  values.quiet = values.verbose = true;
  CHECK_THROWS_AS(check_common_options(values), UsageError);
  values = {};
  values.output = values.report = "same.json";
  CHECK_THROWS_AS(check_common_options(values), UsageError);
}
