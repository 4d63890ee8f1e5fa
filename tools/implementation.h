/// What a Program holds, and how it runs.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "common_options.h"
#include "help_text.h"
#include "option_table.h"
#include "session.h"
#include "terminal.h"
#include "tool.h"

namespace transformesh::tool {

struct Program::Implementation {
  explicit Implementation(Description program_description)
      : description(std::move(program_description)), terminal(description.name) {}

  using Work = std::function<int(Session&, const std::vector<std::string>& words)>;
  /// Parses, answers --help and --version, works, and turns exceptions into exit codes.
  int run(int argc, char** argv, const Kind& kind, const Work& work);
  int run_unguarded(const std::vector<std::string>& arguments, const Kind& kind, const Work& work);
  /// A mesh in, its report out.
  int run_report(int argc, char** argv, const Kind& kind,
                 const std::function<bool(Document&, Run&)>& body);
  /// A filter or a predicate, as `is_predicate` says once the options are parsed.
  int run_either(int argc, char** argv, const std::function<bool()>& is_predicate,
                 const std::function<bool(Document&, Run&)>& body);
  void check_required();
  int fail(int code, std::string_view message);

  Description description;
  OptionTable table;
  CommonOptions common;
  std::vector<std::string>* words = nullptr;
  const std::string* only_key = nullptr;
  std::vector<std::string> required;
  Terminal terminal;
};

}  // namespace transformesh::tool
