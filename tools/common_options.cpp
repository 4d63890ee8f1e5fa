#include "common_options.h"

#include "command.h"
#include "tm/support/error.h"

namespace transformesh::tool {
namespace {

// Adds options to the common section.
class CommonSection {
 public:
  explicit CommonSection(OptionTable& table) : table_(table) {}

  void add(Option option, bool affects_result = false, char short_name = 0) {
    option.is_common = true;
    option.affects_result = affects_result;
    option.short_name = short_name;
    table_.add(std::move(option));
  }

 private:
  OptionTable& table_;
};

void add_mesh_output(CommonSection& section, const Command& command, CommonOptions& values) {
  section.add(choice_option("format", &values.format, {"ply", "ply-ascii", "ply-be", "off"},
                            command.is_evolution()
                                ? "format of the output (default ply)"
                                : "format of the output instead of the input's"));
  if (!command.is_evolution()) {
    section.add(flag_option("float", &values.as_float, "write coordinates as 32-bit floats"), true);
    section.add(flag_option("double", &values.as_double, "write coordinates as 64-bit floats"),
                true);
  }
  section.add(
      flag_option("no-provenance", &values.no_provenance, "add no comment with the options used"));
}

}  // namespace

void add_common_options(Command& command) {
  CommonOptions& values = command.common;
  CommonSection section(command.table);
  Option output = text_option("output", &values.output, "FILE", "where to write; - is stdout");
  section.add(output, false, 'o');
  if (command.may_write_mesh()) add_mesh_output(section, command, values);
  if (command.may_write_mesh() && command.reads_mesh()) {
    section.add(reference_edge_option(&values.reference_edge,
                                      "length that x refers to: measured anew, or set (default: "
                                      "the mesh's tm:reference-edge comment, else measured)"),
                true);
  }
  if (command.may_print_report()) {
    section.add(flag_option("json", &values.json, "print the report as JSON"));
  }
  section.add(text_option("report", &values.report, "FILE", "also write a JSON report there"));
  section.add(
      integer_option("threads", &values.threads, 0, 1024, "threads to use, 0: one per core"));
  section.add(flag_option("progress", &values.progress,
                          "report progress on stderr, also where it is not a terminal"));
  section.add(flag_option("no-progress", &values.no_progress, "never report progress"));
  section.add(flag_option("quiet", &values.quiet, "print errors only"), false, 'q');
  section.add(flag_option("verbose", &values.verbose, "print the settings and what was done"),
              false, 'v');
  section.add(flag_option("help", &values.help, "print this text"), false, 'h');
  section.add(flag_option("version", &values.version, "print the version"));
}

void check_common_options(const CommonOptions& values) {
  const auto exclude = [](bool first, bool second, const char* names) {
    if (first && second) throw UsageError(std::string("give either ") + names + ", not both");
  };
  exclude(values.as_float, values.as_double, "--float or --double");
  exclude(values.quiet, values.verbose, "--quiet or --verbose");
  exclude(values.progress, values.no_progress, "--progress or --no-progress");
  exclude(values.output == values.report, !values.report.empty(),
          "--output or --report its own file");
}

}  // namespace transformesh::tool
