#include "run.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "command.h"
#include "report.h"
#include "signals.h"
#include "tm/io/comments.h"
#include "tm/io/mesh_io.h"
#include "tm/support/counted.h"

namespace transformesh::tool {
namespace {

namespace fs = std::filesystem;

std::string described(const Document& document) {
  return std::string(name_of(document.style.format)) + ", " +
         counted(document.mesh.positions.size(), "vertex") + ", " +
         counted(document.mesh.faces.size(), "face");
}

void add_counts(const Mesh& mesh, Json& counts) {
  const auto add = [&counts](const char* key, std::size_t count) {
    counts[key] = count + (counts.contains(key) ? counts[key].get<std::size_t>() : 0);
  };
  add("vertices", mesh.positions.size());
  add("faces", mesh.faces.size());
}

}  // namespace

Run::Run(Command& command, Terminal& terminal)
    : command_(command),
      terminal_(terminal),
      basis_(command.common.reference_edge),
      report_(std::make_unique<Report>()),
      progress_([this](std::string_view phase, double fraction) {
        show_settings();
        report_->phases.begin(phase);
        if (!command_.is_evolution()) terminal_.progress(phase, fraction);
        return true;
      }) {}

Run::~Run() = default;

// --- Input ---------------------------------------------------------------------------------------

void Run::start() {
  const bool is_for_terminal = output() == "-" && is_terminal(STDOUT_FILENO);
  if (command_.common.json && command_.writes_mesh())
    throw UsageError("--json needs a report on standard output");
  if (command_.writes == Writes::picture && is_for_terminal)
    throw UsageError("not writing a picture to a terminal: redirect it or name a file with -o");
  if (command_.is_evolution()) {
    if (command_.writes_mesh()) set_output_style(document());
    return;
  }
  check_writable(output());
  if (!command_.common.report.empty()) check_writable(command_.common.report);
  if (command_.reads_mesh()) read_input();
}

Document& Run::read_input() {
  documents_.clear();
  const std::size_t count = command_.reads == Reads::meshes ? inputs().size() : 1;
  for (std::size_t i = 0; i < count; ++i) {
    Document& document = documents_.emplace_back(read(inputs()[i]));
    if (command_.is_evolution()) {
      document.style.format = Format::ply_little;
    } else if (command_.writes_mesh()) {
      set_output_style(document);
    }
    add_counts(document.mesh, report_->input);
  }
  refer_to(documents_[0]);
  return documents_[0];
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
  for (const Option* option : command_.options) resolved(*option);
}

const std::vector<std::string>& Run::inputs() const { return command_.inputs; }
const std::string& Run::output() const { return command_.common.output; }
const std::string& Run::program() const { return command_.name; }
std::string Run::value(const std::string& option) const { return command_.find(option)->text(); }

std::string Run::settings(const std::vector<std::string>& but) const {
  std::string text;
  for (const std::string& input : inputs()) text += '\'' + input + "' ";
  for (const Option* option : command_.options) {
    if (option->is_common || std::find(but.begin(), but.end(), option->name()) != but.end())
      continue;
    text += option->name() + " '" + option->text() + "' ";
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
  report_->phases.begin("read");
  ReadResult result = read_mesh(read_once(path).view(), input_name(path));
  for (const std::string& line : result.notes) note(line);
  detail(input_name(path) + ": " + described(result.document));
  report_->phases.begin("");
  return std::move(result.document);
}

std::string Run::read_bytes(const std::string& path) { return std::string(read_once(path).view()); }

// --- Output --------------------------------------------------------------------------------------

void Run::set_output_style(Document& document) {
  const CommonValues& values = command_.common;
  std::optional<Scalar> coordinate;
  if (values.as_float || values.as_double)
    coordinate = values.as_float ? Scalar::float32 : Scalar::float64;
  const Format format = format_for(document.style.format, values.format, output());
  const std::size_t collapsed = set_format(document, format, coordinate);
  if (collapsed > 0) note(counted(collapsed, "face") + " with two corners in one place as floats");
  if (output() == "-" && !is_text(format) && is_terminal(STDOUT_FILENO))
    throw UsageError(
        "not writing binary PLY to a terminal: redirect it with > or |, name a file with -o, or "
        "ask for text with --format ply-ascii");
}

void Run::stage(const std::string& path, std::string_view bytes) {
  AtomicFile file(path, bytes);
  for (const AtomicFile& other : staged_)
    if (other.has_target_of(file))
      throw UsageError("two outputs are called '" + file.target() + "': give each its own file");
  staged_.push_back(std::move(file));
}

void Run::write(const std::string& path, std::string bytes) {
  if (path == "-" && output() == "-" && !writes_nothing_)
    throw UsageError("two outputs on standard output: name a file for one of them");
  check_writable(path);
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
    const std::string path = value(name);
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
  if (!command_.common.no_provenance) add_provenance(comments, provenance(command_));
}

void Run::write_mesh() {
  // What is measured from now on would be another mesh.
  basis_.set_document(nullptr);
  report_->phases.begin("write");
  set_output_style(document());
  if (!is_stamped_) stamp(document());
  const WriteResult result = transformesh::write_mesh(document());
  for (const std::string& line : result.notes) note(line);
  detail((output() == "-" ? "standard output" : output()) + ": " + described(document()));
  add_counts(document().mesh, report_->output);
  write_bytes(result.bytes);
}

void Run::write_bytes(std::string_view bytes) {
  report_->phases.begin("write");
  terminal_.clear_bar();
  stage(output(), bytes);
  report_->phases.begin("");
}

void Run::commit() {
  for (AtomicFile& file : staged_) file.commit();
  staged_.clear();
}

void Run::write_kept() {
  std::string outcome = "is not written";
  try {
    if (output() != "-") {
      write_mesh();
      commit();
      outcome = "holds " + kept_->second;
    }
  } catch (const std::runtime_error& error) {
    terminal_.error(error.what());
  }
  terminal_.error(kept_->first + "; '" + output() + "' " + outcome);
}

int Run::finish() {
  const bool prints_report = command_.may_print_report() && !command_.writes_mesh();
  if (prints_report) bytes_ = report_text();
  if (writes_nothing_) {
    // What the body has written is all.
  } else if (command_.writes_mesh()) {
    write_mesh();
  } else {
    write_bytes(bytes_);
  }
  basis_.set_document(nullptr);
  show_settings();
  for (const auto& [key, value] : report_->result.items())
    if (!prints_report) detail(key + ": " + text_of(value));
  for (const auto& [path, bytes] : further_files_) stage(path, bytes);
  if (!command_.common.report.empty()) stage(command_.common.report, full_report());
  commit();
  if (when_written_) when_written_();
  return answer_ ? exit_done : exit_no;
}

// --- Settings and report -------------------------------------------------------------------------

std::optional<double> Run::resolved(const Option& option) {
  if (option.length() == nullptr) return std::nullopt;
  try {
    return basis_.resolve(*option.length());
  } catch (const std::runtime_error&) {
    // The body will ask again if it really needs this length, and then it is an error.
    return std::nullopt;
  }
}

void Run::show_settings() {
  if (settings_are_shown_ || !terminal_.is_verbose()) return;
  settings_are_shown_ = true;
  for (const Option* option : command_.options) {
    const std::string value = option->text();
    if (option->is_common || value.empty() || value == "false") continue;
    const auto absolute = resolved(*option);
    detail("--" + option->name() + (option->is_flag() ? "" : " " + value) +
           (absolute ? " = " + shortest_text(*absolute) : ""));
  }
  if (basis_.has_reference_edge())
    detail("reference edge " + shortest_text(basis_.reference_edge()));
}

void Run::set(const std::string& key, const Value& value) {
  std::visit([&](const auto& typed) { report_->result[key] = typed; }, value);
}

std::string Run::report_text() const {
  if (command_.only_key != nullptr && !command_.only_key->empty())
    return text_of(report_->result[*command_.only_key]) + '\n';
  if (command_.common.json) return json_text(report_->result);
  std::string lines;
  for (const auto& [key, value] : report_->result.items())
    lines += key + ": " + text_of(value) + '\n';
  return lines;
}

std::string Run::full_report() {
  Json report = {{"tool", command_.name}, {"version", TM_VERSION}, {"options", Json::object()}};
  for (const Option* option : command_.options) {
    if (option->is_common && !command_.is_given(option->name())) continue;
    std::string key = option->name();
    std::replace(key.begin(), key.end(), '-', '_');
    const auto absolute = resolved(*option);
    report["options"][key] = absolute ? Json(*absolute) : option->value();
  }
  if (!report_->input.is_null()) report["input"] = report_->input;
  if (!report_->output.is_null()) report["output"] = report_->output;
  report["result"] = report_->result;
  report["timings"] = report_->phases.seconds();
  report["peak_memory_bytes"] = peak_memory_bytes();
  return json_text(report);
}

}  // namespace transformesh::tool
