/// One run of a program: reads the inputs, answers what the body asks, writes the outputs.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common_options.h"
#include "help_text.h"
#include "length_basis.h"
#include "output.h"
#include "phases.h"
#include "report.h"
#include "terminal.h"
#include "tm/io/streams.h"
#include "tool.h"

namespace transformesh::tool {

class Session : public Run {
 public:
  Session(const Description& program, OptionTable& table, const CommonOptions& options,
          Terminal& terminal);

  /// A mesh in the style of the output, if the program writes one.
  Document read_input(const std::string& path, bool writes_mesh);
  std::vector<Document> read_inputs(const std::vector<std::string>& paths, bool writes_mesh);
  /// Resolves the lengths among the options and shows the settings; to be called before the body
  /// changes the mesh. Without a mesh the body has to set the basis first.
  void begin(const Document* basis);

  /// What goes to -o: one of these, then finish().
  void write_mesh(Document& document, const std::vector<std::string>& words);
  void write_bytes(std::string_view bytes);
  void write_report(bool as_json, const std::string& only_key);
  /// Writes the further files and the report, and gives all files their names.
  void finish();

  double length(const Length& length) override;
  double reference_edge() override;
  void set_basis(double diagonal) override;
  Document read(const std::string& path) override;
  std::string read_bytes(const std::string& path) override;
  void write(const std::string& path, std::string bytes) override;
  void write_into(const std::string& folder, const std::string& name, std::string bytes) override;
  void note(const std::string& message) override;
  void detail(const std::string& message) override;
  using Run::report;
  void report(const std::string& key, double value) override;
  void report(const std::string& key, long value) override;
  void report(const std::string& key, bool value) override;
  void report(const std::string& key, const std::string& value) override;
  void report(const std::string& key, const std::vector<double>& values) override;
  const Progress& progress() override { return progress_; }

 private:
  struct Counts {
    std::size_t vertices = 0;
    std::size_t faces = 0;
  };

  /// Throws UsageError where stdin is to be read a second time.
  Bytes read_once(const std::string& path);
  Document read_document(const std::string& path);
  void set_output_style(Document& document);
  void refuse_binary_on_terminal(Format format) const;
  std::optional<double> resolved(const Option& option);
  void show_settings();
  void show_report();
  nlohmann::ordered_json option_values();
  nlohmann::ordered_json full_report();

  const Description& program_;
  OptionTable& table_;
  const CommonOptions& options_;
  Terminal& terminal_;
  LengthBasis basis_;
  Phases phases_;
  Progress progress_;
  Report report_;
  Counts input_counts_;
  std::optional<Counts> output_counts_;
  bool has_mesh_ = false;
  bool stdin_is_read_ = false;
  bool settings_are_shown_ = false;
  bool report_is_written_ = false;
  std::vector<std::pair<std::string, std::string>> further_files_;
  Outputs outputs_;
};

}  // namespace transformesh::tool
