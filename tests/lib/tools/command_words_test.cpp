#include "frame/command_words.h"

#include <doctest/doctest.h>

#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::tool;

namespace {

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

  /// One word each: `name=text` of a known option, `?text` of an unknown one, `text` of another
  /// word.
  std::vector<std::string> split(const std::vector<std::string>& arguments) const {
    std::vector<std::string> texts;
    for (const CommandWord& word : split_command(arguments, options))
      texts.push_back((word.option != nullptr ? word.option->name() + '='
                       : word.is_unknown      ? "?"
                                              : "") +
                      word.text);
    return texts;
  }

  std::string refused(const std::vector<std::string>& arguments) const {
    try {
      split_command(arguments, options);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  }
};

using Texts = std::vector<std::string>;

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
  CHECK(refused({"--format", "-q"}) == "--format needs a value");
  CHECK(refused({"-o", "--quiet"}) == "--output needs a value");
}

TEST_CASE_FIXTURE(Fixture, "missing values, and values of flags, are refused") {
  CHECK(refused({"--output"}) == "--output needs a value");
  CHECK(refused({"-qo"}) == "--output needs a value");
  CHECK(refused({"--output="}) == "--output needs a value");
  CHECK(refused({"--quiet=yes"}) == "--quiet takes no value");
  CHECK(refused({"a", "-q"}).empty());
}
