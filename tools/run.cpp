#include "run.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "command.h"
#include "comments.h"
#include "exit_code.h"
#include "output_style.h"
#include "signals.h"
#include "suggestion.h"
#include "tm/io/mesh_io.h"
#include "tm/support/counted.h"

namespace transformesh::tool {
namespace {

namespace fs = std::filesystem;

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

Run::Run(Command& command, Terminal& terminal)
    : command_(command),
      terminal_(terminal),
      basis_(command.common.reference_edge),
      progress_([this](std::string_view phase, double fraction) {
        show_settings();
        phases_.begin(phase);
        if (!command_.is_evolution()) terminal_.progress(phase, fraction);
        return true;
      }),
      documents_(1) {}

// --- Input ---------------------------------------------------------------------------------------

void Run::start() {
  if (command_.common.json && command_.writes_mesh())
    throw UsageError("--json needs a report on standard output");
  if (command_.writes == Writes::picture && output() == "-" && is_terminal(STDOUT_FILENO))
    throw UsageError("not writing a picture to a terminal: redirect it or name a file with -o");
  if (command_.is_evolution()) {
    documents_[0].style.format = output_format(Format::ply_little, command_.common);
    if (command_.writes_mesh()) refuse_binary_on_terminal(documents_[0].style.format);
    return;
  }
  check_output(output());
  if (!command_.common.report.empty()) check_output(command_.common.report);
  if (command_.reads_mesh()) read_meshes();
}

void Run::read_meshes() {
  documents_.clear();
  documents_.reserve(command_.inputs.size());
  has_output_style_ = command_.writes_mesh();
  input_counts_.emplace();
  for (const std::string& path : command_.inputs) {
    Document& document = documents_.emplace_back(read(path));
    if (has_output_style_) {
      set_output_style(document);
      refuse_binary_on_terminal(document.style.format);
    }
    input_counts_->add(document.mesh);
  }
  refer_to(documents_[0]);
}

Document& Run::read_input() {
  document() = read(input());
  document().style.format = Format::ply_little;
  input_counts_.emplace().add(document().mesh);
  refer_to(document());
  return document();
}

Document& Run::continue_from(Document document) {
  documents_[0] = std::move(document);
  is_stamped_ = true;
  basis_ = LengthBasis("");
  refer_to(documents_[0]);
  return documents_[0];
}

void Run::refer_to(const Document& document) {
  basis_.set_document(&document);
  if (basis_.is_reference_edge_chosen()) basis_.reference_edge();
  for (const Option& option : command_.table.options()) resolved(option);
}

const std::vector<std::string>& Run::inputs() const { return command_.inputs; }
const std::string& Run::output() const { return command_.common.output; }
const std::string& Run::program() const { return command_.name; }

std::string Run::value(const std::string& option) const {
  return command_.table.find(option)->value_text();
}

std::string Run::settings(const std::vector<std::string>& but) const {
  std::string text;
  for (const std::string& input : command_.inputs) text += '\'' + input + "' ";
  for (const Option& option : command_.table.options()) {
    if (option.is_common || std::find(but.begin(), but.end(), option.name) != but.end()) continue;
    text += option.name + " '" + option.value_text() + "' ";
  }
  text.pop_back();
  return text;
}

Bytes Run::read_once(const std::string& path) {
  if (path == "-" && stdin_is_read_)
    throw UsageError("standard input is named twice: name a file for one of the inputs");
  stdin_is_read_ = stdin_is_read_ || path == "-";
  return read_all(path);
}

Document Run::read(const std::string& path) {
  phases_.begin("read");
  const Bytes bytes = read_once(path);
  ReadResult result = read_mesh(bytes.view(), input_name(path));
  for (const std::string& line : result.notes) note(line);
  detail(input_name(path) + ": " + described(result.document));
  phases_.begin("");
  return std::move(result.document);
}

std::string Run::read_bytes(const std::string& path) { return std::string(read_once(path).view()); }

void Run::Counts::add(const Mesh& mesh) {
  vertices += mesh.positions.size();
  faces += mesh.faces.size();
}

// --- Output --------------------------------------------------------------------------------------

void Run::set_output_style(Document& document) {
  const std::size_t collapsed = apply_output_style(document, command_.common);
  if (collapsed > 0) note(counted(collapsed, "face") + " with two corners in one place as floats");
}

void Run::refuse_binary_on_terminal(Format format) const {
  if (output() != "-" || is_text(format) || !is_terminal(STDOUT_FILENO)) return;
  throw UsageError(
      "not writing binary PLY to a terminal: redirect it with > or |, name a file with -o, or ask "
      "for text with --format ply-ascii");
}

void Run::write(const std::string& path, std::string bytes) {
  if (path == "-" && output() == "-" && !writes_nothing_)
    throw UsageError("two outputs on standard output: name a file for one of them");
  check_output(path);
  further_files_.emplace_back(path, std::move(bytes));
}

void Run::write_into(const std::string& folder, const std::string& name, std::string bytes) {
  // Where it cannot be made, writing says why.
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  write(folder + '/' + name, std::move(bytes));
}

void Run::check_outputs(const std::vector<std::string>& options) {
  std::map<fs::path, std::string> names;
  for (const std::string& name : options) {
    const std::string path = command_.table.find(name)->value_text();
    if (path == "-" && name != "output")
      throw UsageError("--" + name + ": name a file, as standard output is the mesh's");
    if (path == "-" || (path.empty() && name != "output")) continue;
    const auto [other, is_new] = names.emplace(fs::weakly_canonical(fs::absolute(path)), name);
    if (!is_new && (fs::is_regular_file(path) || !fs::exists(path)))
      throw UsageError("give either --" + other->second + " or --" + name +
                       " its own file, not both");
    check_writable(path);
  }
}

void Run::resumable(bool is_resumable) {
  tell_interruption(command_.name, is_resumable ? "; --resume continues" : "");
}

void Run::stamp(Document& document) {
  std::vector<std::string>& comments = document.style.comments;
  is_stamped_ = true;
  if (basis_.has_reference_edge()) set_reference_edge(comments, basis_.reference_edge());
  if (command_.common.no_provenance) return;
  const std::vector<std::string>* words = command_.words;
  add_provenance(
      comments, provenance(command_.name, TM_VERSION,
                           words == nullptr ? std::vector<std::string>() : *words, command_.table));
}

void Run::write_mesh() {
  // What is measured from now on would be another mesh.
  basis_.set_document(nullptr);
  phases_.begin("write");
  if (!has_output_style_) set_output_style(document());
  refuse_binary_on_terminal(document().style.format);
  if (!is_stamped_) stamp(document());
  const WriteResult result = transformesh::write_mesh(document());
  for (const std::string& line : result.notes) note(line);
  detail((output() == "-" ? "standard output" : output()) + ": " + described(document()));
  output_counts_.emplace().add(document().mesh);
  write_bytes(result.bytes);
}

void Run::write_bytes(std::string_view bytes) {
  phases_.begin("write");
  terminal_.clear_bar();
  outputs_.stage(output(), bytes);
  phases_.begin("");
}

void Run::write_kept() {
  bool is_written = false;
  try {
    if (output() != "-") {
      write_mesh();
      outputs_.commit();
      is_written = true;
    }
  } catch (const std::runtime_error& error) {
    terminal_.error(error.what());
  }
  const auto& [stopped, what] = *kept_;
  terminal_.error(stopped + "; '" + output() + "' " +
                  (is_written ? "holds " + what : "is not written"));
}

int Run::finish() {
  if (writes_nothing_) {
    // What the body has written is all.
  } else if (command_.writes_mesh()) {
    write_mesh();
  } else {
    write_bytes(command_.may_print_report() ? report_text() : bytes_);
  }
  basis_.set_document(nullptr);
  show_settings();
  if (command_.writes_mesh() || !command_.may_print_report()) show_report();
  for (const auto& [path, bytes] : further_files_) outputs_.stage(path, bytes);
  if (!command_.common.report.empty())
    outputs_.stage(command_.common.report, json_text(full_report()));
  outputs_.commit();
  if (when_written_) when_written_();
  return answer_ ? exit_done : exit_no;
}

// --- Settings and report -------------------------------------------------------------------------

std::optional<double> Run::resolved(const Option& option) {
  const Length* length = length_of(option);
  if (length == nullptr) return std::nullopt;
  try {
    return basis_.resolve(*length);
  } catch (const std::runtime_error&) {
    // The body will ask again if it really needs this length, and then it is an error.
    return std::nullopt;
  }
}

void Run::show_settings() {
  if (settings_are_shown_ || !terminal_.is_verbose()) return;
  settings_are_shown_ = true;
  for (const Option& option : command_.table.options()) {
    const std::string value = option.value_text();
    if (option.is_common || value.empty() || value == "false") continue;
    std::string line = "--" + option.name + (option.is_flag() ? "" : " " + value);
    const auto absolute = resolved(option);
    if (absolute) line += " = " + shortest_text(*absolute);
    detail(line);
  }
  if (basis_.has_reference_edge())
    detail("reference edge " + shortest_text(basis_.reference_edge()));
}

void Run::show_report() {
  for (const std::string& key : report_.keys()) detail(key + ": " + text_of(*report_.find(key)));
}

std::string Run::report_text() const {
  if (command_.only_key == nullptr || command_.only_key->empty())
    return command_.common.json ? json_text(report_.json()) : report_.lines();
  const ReportValue* value = report_.find(*command_.only_key);
  if (value != nullptr) return text_of(*value) + '\n';
  throw UsageError("unknown key '" + *command_.only_key + "'; did you mean '" +
                   nearest_name(*command_.only_key, report_.keys()) + "'?");
}

nlohmann::ordered_json Run::full_report() {
  using Json = nlohmann::ordered_json;
  const auto counts_json = [](const Counts& counts) {
    return Json{{"vertices", counts.vertices}, {"faces", counts.faces}};
  };
  Json report = {{"tool", command_.name}, {"version", TM_VERSION}, {"options", Json::object()}};
  for (const Option& option : command_.table.options()) {
    if (option.is_common && !option.given) continue;
    const auto absolute = resolved(option);
    report["options"][key_of(option)] = absolute ? Json(*absolute) : value_of(option);
  }
  if (input_counts_) report["input"] = counts_json(*input_counts_);
  if (output_counts_) report["output"] = counts_json(*output_counts_);
  report["result"] = report_.json();
  for (const auto& [phase, seconds] : phases_.seconds()) report["timings"][phase] = seconds;
  report["timings"]["total"] = phases_.total_seconds();
  report["peak_memory_bytes"] = peak_memory_bytes();
  return report;
}

}  // namespace transformesh::tool
