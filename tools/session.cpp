#include "session.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "comments.h"
#include "output_style.h"
#include "suggestion.h"
#include "tm/io/mesh_io.h"
#include "tm/io/streams.h"
#include "tm/support/counted.h"

namespace transformesh::tool {
namespace {

// The length that an option holds, if it is a length.
const Length* length_of(const Option& option) {
  if (const auto* length = std::get_if<Length*>(&option.target)) return *length;
  const auto* optional = std::get_if<std::optional<Length>*>(&option.target);
  return optional != nullptr && (*optional)->has_value() ? &(*optional)->value() : nullptr;
}

std::string key_of(const Option& option) {
  std::string key = option.name;
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

nlohmann::ordered_json value_of(const Option& option) {
  if (const auto* flag = std::get_if<bool*>(&option.target)) return **flag;
  if (const auto* number = std::get_if<double*>(&option.target)) return **number;
  if (const auto* integer = std::get_if<long*>(&option.target)) return **integer;
  if (const auto* integer = std::get_if<std::optional<long>*>(&option.target);
      integer != nullptr && (*integer)->has_value())
    return (*integer)->value();
  if (const auto* numbers = std::get_if<std::vector<double>*>(&option.target)) return **numbers;
  return option.value_text();
}

std::string described(const Document& document) {
  return std::string(format_name(document.style.format)) + ", " +
         counted(document.mesh.positions.size(), "vertex") + ", " +
         counted(document.mesh.faces.size(), "face");
}

}  // namespace

Session::Session(const Description& program, OptionTable& table, const CommonOptions& options,
                 Terminal& terminal)
    : program_(program),
      table_(table),
      options_(options),
      terminal_(terminal),
      basis_(options.reference_edge),
      progress_([this](std::string_view phase, double fraction) {
        show_settings();
        phases_.begin(phase);
        terminal_.progress(phase, fraction);
        return true;
      }) {
  check_output(options_.output);
  if (!options_.report.empty()) check_output(options_.report);
}

Bytes Session::read_once(const std::string& path) {
  if (path == "-" && stdin_is_read_)
    throw UsageError("standard input is named twice: name a file for one of the inputs");
  stdin_is_read_ = stdin_is_read_ || path == "-";
  return read_all(path);
}

Document Session::read_document(const std::string& path) {
  phases_.begin("read");
  const Bytes bytes = read_once(path);
  ReadResult result = read_mesh(bytes.view(), input_name(path));
  for (const std::string& line : result.notes) note(line);
  detail(input_name(path) + ": " + described(result.document));
  phases_.begin("");
  return std::move(result.document);
}

void Session::set_output_style(Document& document) {
  const std::size_t collapsed = apply_output_style(document, options_);
  if (collapsed > 0) note(counted(collapsed, "face") + " with two corners in one place as floats");
}

Document Session::read_input(const std::string& path, bool writes_mesh) {
  Document document = read_document(path);
  input_counts_.vertices += document.mesh.positions.size();
  input_counts_.faces += document.mesh.faces.size();
  if (writes_mesh) {
    set_output_style(document);
    refuse_binary_on_terminal(document.style.format);
  }
  return document;
}

std::vector<Document> Session::read_inputs(const std::vector<std::string>& paths,
                                           bool writes_mesh) {
  std::vector<Document> documents;
  documents.reserve(paths.size());
  for (const std::string& path : paths) documents.push_back(read_input(path, writes_mesh));
  return documents;
}

void Session::refuse_binary_on_terminal(Format format) const {
  if (options_.output != "-" || is_text(format) || !is_terminal(STDOUT_FILENO)) return;
  throw UsageError(
      "not writing binary PLY to a terminal: redirect it with > or |, name a file with -o, or ask "
      "for text with --format ply-ascii");
}

void Session::begin(const Document* basis) {
  basis_.set_document(basis);
  has_mesh_ = basis != nullptr;
  if (!has_mesh_) return;
  if (basis_.is_reference_edge_chosen()) basis_.reference_edge();
  for (const Option& option : table_.options()) resolved(option);
}

std::optional<double> Session::resolved(const Option& option) {
  const Length* length = length_of(option);
  if (length == nullptr) return std::nullopt;
  try {
    return basis_.resolve(*length);
  } catch (const std::runtime_error&) {
    // The body will ask again if it really needs this length, and then it is an error.
    return std::nullopt;
  }
}

void Session::show_settings() {
  if (settings_are_shown_ || !terminal_.is_verbose()) return;
  settings_are_shown_ = true;
  for (const Option& option : table_.options()) {
    const std::string value = option.value_text();
    if (option.is_common || value.empty() || value == "false") continue;
    std::string line = "--" + option.name + (option.is_flag() ? "" : " " + value);
    const auto absolute = resolved(option);
    if (absolute) line += " = " + shortest_text(*absolute);
    detail(line);
  }
  if (basis_.has_reference_edge()) {
    detail("reference edge " + shortest_text(basis_.reference_edge()));
  }
}

void Session::show_report() {
  for (const std::string& key : report_.keys()) detail(key + ": " + text_of(*report_.find(key)));
}

void Session::write_mesh(Document& document, const std::vector<std::string>& words) {
  // What is measured from now on would be another mesh.
  basis_.set_document(nullptr);
  phases_.begin("write");
  if (!has_mesh_) set_output_style(document);
  refuse_binary_on_terminal(document.style.format);
  std::vector<std::string>& comments = document.style.comments;
  if (basis_.has_reference_edge()) set_reference_edge(comments, basis_.reference_edge());
  if (!options_.no_provenance) {
    add_provenance(comments, provenance(program_.name, TM_VERSION, words, table_));
  }
  const WriteResult result = transformesh::write_mesh(document);
  for (const std::string& line : result.notes) note(line);
  detail((options_.output == "-" ? "standard output" : options_.output) + ": " +
         described(document));
  output_counts_ = Counts{document.mesh.positions.size(), document.mesh.faces.size()};
  write_bytes(result.bytes);
}

void Session::write_bytes(std::string_view bytes) {
  phases_.begin("write");
  terminal_.clear_bar();
  outputs_.stage(options_.output, bytes);
  phases_.begin("");
}

void Session::write_report(bool as_json, const std::string& only_key) {
  report_is_written_ = true;
  if (only_key.empty()) return write_bytes(as_json ? json_text(report_.json()) : report_.lines());
  const ReportValue* value = report_.find(only_key);
  if (value == nullptr) {
    throw UsageError("unknown key '" + only_key + "'; did you mean '" +
                     nearest_name(only_key, report_.keys()) + "'?");
  }
  write_bytes(text_of(*value) + '\n');
}

void Session::finish() {
  basis_.set_document(nullptr);
  show_settings();
  if (!report_is_written_) show_report();
  for (const auto& [path, bytes] : further_files_) outputs_.stage(path, bytes);
  if (!options_.report.empty()) outputs_.stage(options_.report, json_text(full_report()));
  outputs_.commit();
}

nlohmann::ordered_json Session::option_values() {
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  for (const Option& option : table_.options()) {
    if (option.is_common && !option.given) continue;
    const auto absolute = resolved(option);
    values[key_of(option)] = absolute ? nlohmann::ordered_json(*absolute) : value_of(option);
  }
  return values;
}

nlohmann::ordered_json Session::full_report() {
  const auto counts_json = [](const Counts& counts) {
    return nlohmann::ordered_json{{"vertices", counts.vertices}, {"faces", counts.faces}};
  };
  nlohmann::ordered_json report;
  report["tool"] = program_.name;
  report["version"] = TM_VERSION;
  report["options"] = option_values();
  if (has_mesh_) report["input"] = counts_json(input_counts_);
  if (output_counts_) report["output"] = counts_json(*output_counts_);
  report["result"] = report_.json();
  nlohmann::ordered_json timings = nlohmann::ordered_json::object();
  for (const auto& [phase, seconds] : phases_.seconds()) timings[phase] = seconds;
  timings["total"] = phases_.total_seconds();
  report["timings"] = timings;
  report["peak_memory_bytes"] = peak_memory_bytes();
  return report;
}

double Session::length(const Length& length) { return basis_.resolve(length); }
double Session::reference_edge() { return basis_.reference_edge(); }
void Session::set_basis(double diagonal) { basis_.set_diagonal(diagonal); }

Document Session::read(const std::string& path) { return read_document(path); }

std::string Session::read_bytes(const std::string& path) {
  const Bytes bytes = read_once(path);
  return std::string(bytes.view());
}

void Session::write(const std::string& path, std::string bytes) {
  if (path == "-" && options_.output == "-") {
    throw UsageError("two outputs on standard output: name a file for one of them");
  }
  check_output(path);
  further_files_.emplace_back(path, std::move(bytes));
}

void Session::write_into(const std::string& folder, const std::string& name, std::string bytes) {
  // Where it cannot be made, writing says why.
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  write(folder + '/' + name, std::move(bytes));
}

void Session::note(const std::string& message) { terminal_.note(message); }
void Session::detail(const std::string& message) { terminal_.detail(message); }

void Session::report(const std::string& key, double value) { report_.set(key, value); }
void Session::report(const std::string& key, long value) { report_.set(key, value); }
void Session::report(const std::string& key, bool value) { report_.set(key, value); }
void Session::report(const std::string& key, const std::string& value) { report_.set(key, value); }
void Session::report(const std::string& key, const std::vector<double>& values) {
  report_.set(key, values);
}

}  // namespace transformesh::tool
