#include "frame/command_words.h"

#include <doctest/doctest.h>

#include <array>
#include <random>

#include "transformesh/errors.h"

namespace transformesh::tool {

// the function of wasm/command_words.cpp under another name
std::vector<CommandWord> split_command_of_wasm(const std::vector<std::string>& arguments,
                                               const OptionSet& options);

}  // namespace transformesh::tool

using namespace transformesh;
using namespace transformesh::tool;

namespace {

using Texts = std::vector<std::string>;

std::string in_brackets(const Texts& words) {
  std::string text;
  for (const std::string& word : words) text += '[' + word + ']';
  return text;
}

/// A program with two flags and two options with values, one of them without a letter.
struct Fixture {
  bool quiet = false, verbose = false;
  std::string output, format;
  OptionSet options;

  Fixture() {
    options.flag("quiet,q", &quiet, "");
    options.flag("verbose,v", &verbose, "");
    options.text("output,o", &output, "FILE", "");
    options.text("format", &format, "WORD", "");
  }

  /// Returns one word for each argument: `name=text` for a known option, `?text` for an unknown
  /// one, `text` for another word; or the error message.
  Texts outcome(const Texts& arguments, auto splitter) const {
    Texts texts;
    try {
      for (const CommandWord& word : splitter(arguments, options))
        texts.push_back((word.option != nullptr ? word.option->name() + '='
                         : word.is_unknown      ? "?"
                                                : "") +
                        word.text);
    } catch (const UsageError& error) {
      return {"error", error.what()};
    }
    return texts;
  }

  /// Returns the outcome of native programs, after a check that WebAssembly has the same outcome.
  Texts split(const Texts& arguments) const {
    Texts native = outcome(arguments, split_command);
    CAPTURE(in_brackets(arguments));
    CHECK(in_brackets(native) == in_brackets(outcome(arguments, split_command_of_wasm)));
    return native;
  }
};

/// Words that may be an option, a value or a mistake.
constexpr std::array words = {
    "--quiet",  "--quiet=",  "--quiet=yes", "--output",  "--output=",  "--output=a", "--output=a=b",
    "--format", "--format=", "--format=-3", "--out",     "--outp=a",   "--o",        "--o=a",
    "--q",      "--Quiet",   "--no-quiet",  "--quiet,q", "--output a", "--",         "---",
    "---quiet", "--=",       "--=a",        "--5",       "-",          "",           " ",
    "-q",       "-v",        "-qv",         "-qq",       "-q=",        "-q=1",       "-q-",
    "-o",       "-oa",       "-o=",         "-o=a",      "-oq",        "-o-",        "-o--quiet",
    "-qo",      "-qoa",      "-vqo",        "-x",        "-qx",        "-xq",        "-xo",
    "-Q",       "-5",        "-.5",         "-output",   "-quiet",     "-\xc3\xa9",  "--\xc3\xa9",
    "a",        "b=c",       "=",           "output",    "@a",         "a -q",       "-,"};

}  // namespace

TEST_CASE_FIXTURE(Fixture, "values follow an equals sign, the letter, or as the next word") {
  CHECK(split({"--output=a", "--output", "b", "-oc", "-o", "d"}) ==
        Texts{"output=a", "output=b", "output=c", "output=d"});
  CHECK(split({"--output=a=b", "-o=x"}) == Texts{"output=a=b", "output==x"});
}

TEST_CASE_FIXTURE(Fixture, "letters of flags share a word, and an option with a value ends it") {
  CHECK(split({"-qv"}) == Texts{"quiet=", "verbose="});
  CHECK(split({"-qoa"}) == Texts{"quiet=", "output=a"});
  CHECK(split({"-qo", "a"}) == Texts{"quiet=", "output=a"});
}

TEST_CASE_FIXTURE(Fixture, "other words keep their order, and after -- all words are such") {
  CHECK(split({"a", "-q", "-", "", "b", "--", "-q", "--", "--format"}) ==
        Texts{"a", "quiet=", "-", "", "b", "-q", "--", "--format"});
}

TEST_CASE_FIXTURE(Fixture, "unknown options are whole words, and names are not abbreviated") {
  CHECK(split({"--fast=3", "--out", "-x", "-qx", "-5"}) ==
        Texts{"?--fast=3", "?--out", "?-x", "quiet=", "?-qx", "?-5"});
}

TEST_CASE_FIXTURE(Fixture, "values may begin with a dash unless they are options of the program") {
  CHECK(split({"--format", "-3", "--output", "--x"}) == Texts{"format=-3", "output=--x"});
  CHECK(split({"--format", "-q"}) == Texts{"error", "--format needs a value"});
  CHECK_THROWS_WITH_AS(options.parse({"-o", "--quiet"}), "--output needs a value", UsageError);
}

TEST_CASE_FIXTURE(Fixture, "missing values, and values of flags, are refused") {
  for (const char* word : {"--output", "-qo", "--output="})
    CHECK(split({word}) == Texts{"error", "--output needs a value"});
  CHECK(split({"--quiet=yes"}) == Texts{"error", "--quiet takes no value"});
}

TEST_CASE_FIXTURE(Fixture, "WebAssembly splits all pairs of words, and longer lines, alike") {
  for (const char* first : words) {
    split({first});
    for (const char* second : words) split({first, second});
  }
  std::mt19937 random(1);
  for (int line = 0; line < 2000; ++line) {
    Texts arguments;
    for (auto count = 3 + random() % 5; count > 0; --count)
      arguments.emplace_back(words[random() % words.size()]);
    split(arguments);
  }
}
