// The kinds of options (option_types.cpp) and how they are parsed (command_line.cpp).
#include <doctest/doctest.h>

#include "frame/program.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::tool;

namespace {

struct Values {
  bool flag = false;
  double number = 0.5;
  int integer = 3;
  std::optional<long> count;
  Length length{0.7, Length::Unit::reference_edge};
  std::optional<Length> gap;
  std::string kind = "valence";
  std::string file;
  std::vector<double> point;
  bool is_exact = false;
  std::optional<Vec3> center;
  std::optional<Box> box;
};

// A program with an option of each kind.
struct Sample {
  Sample() {
    program.options.flag("flag", &values.flag, "a flag");
    program.options.number("number", &values.number, 0, 1, "a number");
    program.options.integer("integer", &values.integer, 1, 9, "an integer");
    program.options.integer("count", &values.count, 0, 9, "a count");
    program.options.length("length", &values.length, "a length");
    program.options.length("gap", &values.gap, "a signed length", true);
    program.options.choice("kind", &values.kind, {"valence", "angle"}, "a kind");
    program.options.text("file", &values.file, "FILE", "a file");
    program.options.numbers("point", &values.point, "X,Y,Z", "a point");
    program.options.named("show", &values.is_exact, {{"least", false}, {"exact", true}}, "a word");
    program.options.point("center", &values.center, "another point");
    program.options.box("box", &values.box, "X,Y,Z,X,Y,Z", "a box");
  }
  std::vector<std::string> parse(const std::vector<std::string>& arguments) {
    const auto words = program.options.parse(arguments);
    return words;
  }
  std::string text(const std::string& option) { return program.options.find(option)->text(); }

  Values values;
  Program program{"tm-x", "", ""};
};

// Returns the message with which these arguments are refused.
std::string refusal(const std::vector<std::string>& arguments) {
  try {
    Sample().parse(arguments);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("options set their variables, and the other words are returned in order") {
  Sample sample;
  const Values& values = sample.values;
  const auto words = sample.parse({"one", "--flag", "--number=0.25", "--integer", "9", "-", "--gap",
                                   "-2%", "--kind", "angle", "--point", "1,-2.5,3e2", "--count",
                                   "0", "--file", "a b.ply", "--", "--number"});
  CHECK(words == std::vector<std::string>{"one", "-", "--number"});
  CHECK(values.flag);
  CHECK(values.number == 0.25);
  CHECK(values.integer == 9);
  CHECK(values.gap->value == -0.02);
  CHECK(values.gap->unit == Length::Unit::diagonal);
  CHECK(values.kind == "angle");
  CHECK(values.count == 0);
  CHECK(values.file == "a b.ply");
  CHECK(values.point == std::vector<double>{1, -2.5, 300});
  CHECK(values.length.text() == "0.7x");
  CHECK(sample.program.options.find("number")->is_given);
  CHECK_FALSE(sample.program.options.find("length")->is_given);
}

TEST_CASE("the last of several values counts") {
  Sample sample;
  const Values& values = sample.values;
  sample.parse({"--integer", "2", "--integer", "4"});
  CHECK(values.integer == 4);
}

TEST_CASE("the text of an option is that of its variable, and the default stays") {
  Sample sample;
  CHECK(sample.text("number") == "0.5");
  CHECK(sample.text("--length") == "0.7x");
  CHECK(sample.text("gap") == "");
  CHECK(sample.text("count") == "");
  sample.program.options.parse({"--number", "0.25", "--point", "1,2.5,3"});
  CHECK(sample.program.options.find("number")->default_text == "0.5");
  CHECK(sample.text("number") == "0.25");
  CHECK(sample.text("point") == "1,2.5,3");
}

TEST_CASE("words, points and boxes set the values that they stand for") {
  Sample sample;
  CHECK(sample.text("show") == "least");
  CHECK(sample.text("center") == "");
  CHECK(sample.text("box") == "");
  CHECK(std::get<std::vector<double>>(sample.program.options.find("box")->value()).empty());
  sample.parse({"--show", "exact", "--center", "1,-2,0.5", "--box", "0,1,2,3,4.5,6"});
  CHECK(sample.values.is_exact);
  CHECK(*sample.values.center == Vec3(1, -2, 0.5));
  CHECK(sample.values.box->min() == Vec3(0, 1, 2));
  CHECK(sample.values.box->max() == Vec3(3, 4.5, 6));
  CHECK(sample.text("show") == "exact");
  CHECK(sample.text("center") == "1,-2,0.5");
  CHECK(sample.text("box") == "0,1,2,3,4.5,6");
  CHECK(refusal({"--show", "exakt"}) ==
        "--show: 'exakt' is not known; did you mean 'exact'? (least, exact)");
  CHECK(refusal({"--box", "1,2,3"}) == "--box: '1,2,3' is not 6 numbers separated by commas");
}

TEST_CASE("an unknown option names the nearest") {
  CHECK(refusal({"--numbr", "1"}) == "unknown option '--numbr'; did you mean '--number'?");
  CHECK(refusal({"--lenght=2"}) == "unknown option '--lenght=2'; did you mean '--length'?");
  CHECK(refusal({"--num", "1"}) == "unknown option '--num'; did you mean '--number'?");
  CHECK(refusal({"--foo"}) == "unknown option '--foo'; list all options with --help");
  CHECK(refusal({"-x"}) == "unknown option '-x'; list all options with --help");
}

TEST_CASE("the first of several errors is reported") {
  CHECK(refusal({"--number", "2", "--numbr"}).starts_with("--number: '2' is too large"));
  CHECK(refusal({"--numbr", "--number", "2"}).starts_with("unknown option '--numbr'"));
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
  CHECK(refusal({"--length", "-1"}) == "--length: '-1' is too small: a length must be at least 0");
  CHECK(refusal({"--length", "2m"}).starts_with("--length: '2m' is not a length"));
  CHECK(refusal({"--kind", "angel"}) ==
        "--kind: 'angel' is not known; did you mean 'angle'? (valence, angle)");
  CHECK(refusal({"--point", "1,2"})
            .starts_with("--point: '1,2' is not 3 numbers separated by commas"));
  CHECK(refusal({"--point", "1,2,"}) == "--point: '' is not a number");
}

TEST_CASE("missing and superfluous values are reported") {
  CHECK(refusal({"--number"}) == "--number needs a value");
  CHECK(refusal({"--number", "--flag"}) == "--number needs a value");
  CHECK(refusal({"--number="}) == "--number needs a value");
  CHECK(refusal({"--flag=1"}) == "--flag takes no value");
}
