#include "tool.h"

#include <unistd.h>

#include <limits>
#include <new>
#include <stdexcept>

#include "common_options.h"
#include "exit_code.h"
#include "help_text.h"
#include "option_table.h"
#include "output.h"
#include "session.h"
#include "signals.h"
#include "streams.h"
#include "terminal.h"
#include "tm/support/error.h"
#include "tm/support/parallel.h"

namespace transformesh::tool {

struct Program::Implementation {
  explicit Implementation(Description program_description)
      : description(std::move(program_description)), terminal(description.name) {}

  using Work = std::function<int(Session&, const std::vector<std::string>& words)>;
  /// Parses, answers --help and --version, works, and turns exceptions into exit codes.
  int run(int argc, char** argv, const Kind& kind, const Work& work);
  int run_unguarded(const std::vector<std::string>& arguments, const Kind& kind, const Work& work);
  /// A filter or a predicate, as `is_predicate` says once the options are parsed.
  int run_either(int argc, char** argv, const std::function<bool()>& is_predicate,
                 const std::function<bool(Document&, Run&)>& body);
  int print(std::string_view text);
  int fail(int code, std::string_view message);
  /// The inputs to read: those named, else stdin, which must not be a terminal.
  std::vector<std::string> inputs(const std::vector<std::string>& words, const Kind& kind) const;

  Description description;
  OptionTable table;
  CommonOptions common;
  std::vector<std::string>* words = nullptr;
  const std::string* only_key = nullptr;
  Terminal terminal;
};

namespace {

/// Nothing named and a terminal to read from: the user wants to know how to use this.
struct ShortHelpWanted {};

}  // namespace

int Program::Implementation::print(std::string_view text) {
  Outputs().stage("-", text);
  return exit_done;
}

int Program::Implementation::fail(int code, std::string_view message) {
  terminal.error(message);
  return code;
}

std::vector<std::string> Program::Implementation::inputs(const std::vector<std::string>& named,
                                                         const Kind& kind) const {
  if (!kind.reads_mesh) return {};
  if (named.empty()) {
    if (is_terminal(STDIN_FILENO)) throw ShortHelpWanted();
    return {"-"};
  }
  if (named.size() > 1 && !kind.many_inputs) {
    throw UsageError("one input at most, but '" + named[1] + "' is a second one");
  }
  return named;
}

int Program::Implementation::run_unguarded(const std::vector<std::string>& arguments,
                                           const Kind& kind, const Work& work) {
  add_common_options(table, kind, common);
  const std::vector<std::string> positional = table.parse(arguments);
  if (common.help) return print(help_text(description, table, kind.is_predicate));
  if (common.version) return print(description.name + " " TM_VERSION "\n");
  check_common_options(common);
  terminal.configure(common.quiet, common.verbose, common.progress, common.no_progress);
  if (words != nullptr) {
    *words = positional;
  } else if (!kind.reads_mesh && !positional.empty()) {
    throw UsageError("'" + positional[0] + "' is not expected: there is no input");
  }
  const std::vector<std::string> named = inputs(positional, kind);
  const ThreadLimit limit(static_cast<int>(common.threads));
  Session session(description, table, common, terminal);
  return work(session, named);
}

int Program::Implementation::run(int argc, char** argv, const Kind& kind, const Work& work) {
  occupy_standard_descriptors();
  install_signal_handlers();
  try {
    return run_unguarded({argv + 1, argv + argc}, kind, work);
  } catch (const ShortHelpWanted&) {
    write_all(STDERR_FILENO, short_help_text(description));
    return exit_usage;
  } catch (const UsageError& error) {
    return fail(exit_usage, error.what());
  } catch (const InputError& error) {
    return fail(exit_input, error.what());
  } catch (const GoalError& error) {
    return fail(exit_goal, error.what());
  } catch (const OutputError& error) {
    return fail(exit_output, error.what());
  } catch (const std::bad_alloc&) {
    write_all(STDERR_FILENO, description.name);
    write_all(STDERR_FILENO, ": out of memory\n");
    return exit_memory;
  } catch (const std::length_error&) {
    return fail(exit_memory, "out of memory");
  } catch (const std::exception&) {
    return fail(exit_goal, "internal error: please report it together with the input");
  }
}

int Program::Implementation::run_either(int argc, char** argv,
                                        const std::function<bool()>& is_predicate,
                                        const std::function<bool(Document&, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& named) {
    if (common.json && !is_predicate()) {
      throw UsageError("--json needs a report on standard output");
    }
    Document document = session.read_input(named[0], !is_predicate());
    session.begin(&document);
    const bool answer = body(document, session);
    if (is_predicate()) session.write_report(common.json, "");
    if (!is_predicate() && answer) session.write_mesh(document, {});
    if (is_predicate() || answer) session.finish();
    return answer ? exit_done : exit_no;
  };
  return run(argc, argv, Kind{.is_predicate = true}, work);
}

Program::Program(std::string name, std::string synopsis, std::string summary)
    : implementation_(std::make_unique<Implementation>(
          Description{std::move(name), std::move(synopsis), std::move(summary), "", "", {}})) {}

Program::~Program() = default;

void Program::flag(const std::string& option, bool* value, const std::string& help) {
  implementation_->table.add(flag_option(option, value, help));
}

void Program::number(const std::string& option, double* value, double minimum, double maximum,
                     const std::string& help) {
  implementation_->table.add(number_option(option, value, minimum, maximum, help));
}

void Program::integer(const std::string& option, long* value, long minimum, long maximum,
                      const std::string& help) {
  implementation_->table.add(integer_option(option, value, minimum, maximum, help));
}

void Program::integer(const std::string& option, std::optional<long>* value, long minimum,
                      long maximum, const std::string& help) {
  implementation_->table.add(integer_option(option, value, minimum, maximum, help));
}

void Program::length(const std::string& option, Length* value, const std::string& help,
                     bool may_be_negative) {
  implementation_->table.add(length_option(option, value, help, may_be_negative));
}

void Program::length(const std::string& option, std::optional<Length>* value,
                     const std::string& help, bool may_be_negative) {
  implementation_->table.add(length_option(option, value, help, may_be_negative));
}

void Program::text(const std::string& option, std::string* value, const std::string& placeholder,
                   const std::string& help) {
  implementation_->table.add(text_option(option, value, placeholder, help));
}

void Program::choice(const std::string& option, std::string* value, std::vector<std::string> names,
                     const std::string& help) {
  implementation_->table.add(choice_option(option, value, std::move(names), help));
}

void Program::point(const std::string& option, std::vector<double>* value,
                    const std::string& help) {
  implementation_->table.add(point_option(option, value, help));
}

void Program::words(std::vector<std::string>* values, const std::string& placeholder,
                    const std::string& help) {
  implementation_->words = values;
  implementation_->description.words = placeholder;
  implementation_->description.words_help = help;
}

void Program::seed(long* value) {
  integer("seed", value, 0, std::numeric_limits<long>::max(), "seed of the random numbers");
}

void Program::keep_out_of_provenance(const std::string& option) {
  if (Option* found = implementation_->table.find(option)) found->affects_result = false;
}

void Program::print_only(const std::string* key) { implementation_->only_key = key; }

void Program::epilog(std::string text) {
  implementation_->description.epilogs.push_back(std::move(text));
}

int Program::filter(int argc, char** argv, const std::function<void(Document&, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& inputs) {
    Document document = session.read_input(inputs[0], true);
    session.begin(&document);
    body(document, session);
    session.write_mesh(document, {});
    session.finish();
    return exit_done;
  };
  return implementation_->run(argc, argv, Kind{}, work);
}

int Program::source(int argc, char** argv, const std::function<Document(Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>&) {
    session.begin(nullptr);
    Document document = body(session);
    const std::vector<std::string>* words = implementation_->words;
    session.write_mesh(document, words == nullptr ? std::vector<std::string>() : *words);
    session.finish();
    return exit_done;
  };
  return implementation_->run(argc, argv, Kind{.reads_mesh = false}, work);
}

int Program::combine(int argc, char** argv,
                     const std::function<Document(std::vector<Document>, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& inputs) {
    std::vector<Document> documents;
    for (const std::string& input : inputs) documents.push_back(session.read_input(input, true));
    session.begin(&documents[0]);
    Document document = body(std::move(documents), session);
    session.write_mesh(document, {});
    session.finish();
    return exit_done;
  };
  return implementation_->run(argc, argv, Kind{.many_inputs = true}, work);
}

int Program::predicate(int argc, char** argv, const std::function<bool(Document&, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& inputs) {
    Document document = session.read_input(inputs[0], false);
    session.begin(&document);
    const bool answer = body(document, session);
    const std::string* key = implementation_->only_key;
    session.write_report(implementation_->common.json, key == nullptr ? "" : *key);
    session.finish();
    return answer ? exit_done : exit_no;
  };
  return implementation_->run(argc, argv, Kind{.writes_mesh = false, .is_predicate = true}, work);
}

int Program::filter_or_predicate(int argc, char** argv, const bool* is_predicate,
                                 const std::function<bool(Document&, Run&)>& body) {
  return implementation_->run_either(
      argc, argv, [=] { return *is_predicate; }, body);
}

int Program::predicate_or_filter(int argc, char** argv, const bool* is_filter,
                                 const std::function<bool(Document&, Run&)>& body) {
  return implementation_->run_either(
      argc, argv, [=] { return !*is_filter; }, body);
}

int Program::picture(int argc, char** argv,
                     const std::function<std::string(std::vector<Document>, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& inputs) {
    if (implementation_->common.output == "-" && is_terminal(STDOUT_FILENO)) {
      throw UsageError("not writing a picture to a terminal: redirect it or name a file with -o");
    }
    std::vector<Document> documents;
    for (const std::string& input : inputs) documents.push_back(session.read_input(input, false));
    session.begin(&documents[0]);
    session.write_bytes(body(std::move(documents), session));
    session.finish();
    return exit_done;
  };
  return implementation_->run(argc, argv, Kind{.many_inputs = true, .writes_mesh = false}, work);
}

}  // namespace transformesh::tool
