#include "frame/run.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>

#include "clean/intersect/rounding_intersections.h"
#include "clean/stitch/join_soup.h"
#include "frame/advice.h"
#include "io/comments.h"
#include "io/formats/file_format.h"
#include "io/length_basis.h"
#include "io/streams/output_target.h"
#include "mesh/touching_borders.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh::tool {
namespace {

namespace fs = std::filesystem;

std::string described(const Document& document) {
  return std::string(name_of(document.style.format)) + ", " +
         counted(document.mesh.positions.size(), "vertex") + ", " +
         counted(document.mesh.faces.size(), "face");
}

Entries counts_of(std::span<const Document> documents) {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (const Document& document : documents) {
    vertices += document.mesh.positions.size();
    faces += document.mesh.faces.size();
  }
  return {{"vertices", vertices}, {"faces", faces}};
}

/// `.a, .b or .c`
std::string listed(const std::vector<std::string>& words) {
  std::string text = words[0];
  for (std::size_t i = 1; i < words.size(); ++i)
    text += (i + 1 < words.size() ? ", " : " or ") + words[i];
  return text;
}

}  // namespace

Run::Run(Program& program, Terminal& terminal)
    : program_(program),
      terminal_(terminal),
      basis_(program.common.reference_edge),
      progress_([this](std::string_view phase, double fraction) {
        show_settings();
        phases_.begin(phase);
        if (!program_.is_evolution()) terminal_.progress(phase, fraction);
        return true;
      }) {}

bool Run::writes_to_terminal() const { return output() == "-" && isatty(STDOUT_FILENO) == 1; }

void Run::print_line(const std::string& text) {
  if (!write_all(STDOUT_FILENO, text + '\n')) throw_not_written("standard output");
}

std::string Run::version() { return TM_VERSION; }

void Run::report(const std::string& key, const Value& value) { result_.emplace_back(key, value); }

// --- Input ---------------------------------------------------------------------------------------

void Run::check_ending() const {
  const auto check = [&](const std::vector<std::string>& known, const std::string& advice) {
    const std::string ending = unknown_ending(output(), known);
    if (!ending.empty())
      throw UsageError("--output: '" + output() + "' ends in " + ending +
                       ", which is not written; " + advice);
  };
  const std::vector<std::string>& pictures = program_.picture_endings;
  if (program_.writes == Writes::picture) check(pictures, "pictures are " + listed(pictures));
  if (program_.writes == Writes::page) check({".html", ".htm"}, "pages are .html");
  if (program_.writes_mesh() && program_.common.format.empty())
    check(written_endings(),
          "take " + listed(written_endings()) + ", or name its format with --format");
}

void Run::start() {
  const CommonValues& values = program_.common;
  check_ending();
  if (values.json && program_.writes_mesh())
    throw UsageError("--json needs a report on standard output");
  if (program_.writes == Writes::picture && writes_to_terminal())
    throw UsageError("not writing a picture to a terminal: redirect it or name a file with -o");
  if (program_.is_evolution()) {
    if (program_.writes_mesh()) set_output_style(document());
    return;
  }
  check_writable(output());
  if (!values.report.empty()) check_writable(values.report);
  if (program_.reads_mesh()) read_input();
  if (program_.soups == Soups::joined) report("joined_vertices", joined_vertices_);
}

Document& Run::read_input() {
  documents_.clear();
  const std::size_t count = program_.reads == Reads::meshes ? inputs().size() : 1;
  for (std::size_t i = 0; i < count; ++i) {
    Document& document = documents_.emplace_back(read(inputs()[i]));
    if (program_.is_evolution()) {
      document.style.format = Format::ply_little;
    } else if (program_.writes_mesh()) {
      set_output_style(document);
    }
  }
  input_counts_ = counts_of(documents_);
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
  for (const Option& option : program_.options) resolved(option);
}

Bytes Run::read_once(const std::string& path) {
  if (path == "-" && stdin_is_read_)
    throw UsageError("standard input is named twice: name a file for one of the inputs");
  stdin_is_read_ = stdin_is_read_ || path == "-";
  return read_all(path);
}

void Run::treat_soup(Mesh& mesh, const std::string& name, bool is_reported) {
  if (program_.soups == Soups::joined) {
    const StitchResult result = join_soup(mesh);
    joined_vertices_ += result.joined_vertices;
    if (result.joined_vertices > 0)
      note(name + ": " + counted(result.joined_vertices, "vertex") +
           " joined with others in the same place, as tm-stitch does");
    if (result.dropped_faces > 0)
      note(name + ": " + counted(result.dropped_faces, "face") +
           " with two corners in one place dropped");
  } else if (program_.soups == Soups::reported && !is_reported) {
    const std::size_t count = count_touching_borders(mesh);
    if (count > 0)
      note(with_advice(
          {ErrorKind::not_joined, name + ": " + counted(count, "border edge") +
                                      " lie upon each other: the faces share no vertices there"},
          program_));
  }
}

Document Run::read(const std::string& path) {
  phases_.begin("read");
  ReadResult result = read_mesh(read_once(path).view(), input_name(path), reading());
  const bool is_mended = program_.soups == Soups::own || program_.soups == Soups::joined;
  if (result.soup_note && !is_mended) {
    std::string& line = result.notes[*result.soup_note];
    line = with_advice({ErrorKind::not_joined, line}, program_);
  }
  note_all(result.notes);
  treat_soup(result.document.mesh, input_name(path), result.soup_note.has_value());
  detail(input_name(path) + ": " + described(result.document));
  phases_.begin("");
  return std::move(result.document);
}

void Run::note_all(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) note(line);
}

void Run::note_all(const std::vector<Problem>& warnings) {
  for (const Problem& warning : warnings) note(with_advice(warning, program_));
}

// --- Output --------------------------------------------------------------------------------------

void Run::set_style(Document& document, const std::string& path) {
  const CommonValues& values = program_.common;
  std::optional<Scalar> coordinate;
  if (values.as_float || values.as_double)
    coordinate = values.as_float ? Scalar::float32 : Scalar::float64;
  const Format format = format_for(document.style.format, values.format, path);
  const bool is_rounded =
      document.style.coordinate == Scalar::float64 && (values.as_float || holds_floats(format));
  const std::vector<Vec3> before = is_rounded ? document.mesh.positions : std::vector<Vec3>();
  const std::size_t collapsed = set_format(document, format, coordinate);
  if (is_rounded && !program_.cleans)
    note_rounding_intersections(count_rounding_intersections(document.mesh, before));
  if (collapsed > 0) note(counted(collapsed, "face") + " with two corners in one place as floats");
}

void Run::set_output_style(Document& document) {
  set_style(document, output());
  if (output() == "-" && !is_text(document.style.format) && isatty(STDOUT_FILENO) == 1)
    throw UsageError(
        "not writing binary data to a terminal: redirect it with > or |, name a file with -o, or "
        "ask for text with --format ply-ascii");
}

void Run::note_rounding_intersections(std::size_t pairs) {
  if (pairs == 0 || are_self_intersections_reported_) return;
  are_self_intersections_reported_ = true;
  note(counted(pairs, "pair") + " of faces " + (pairs == 1 ? "intersects" : "intersect") +
       " only as floats: let tm-clean write the file, or write doubles, in PLY, OFF, OBJ or VTP");
}

void Run::stage(const std::string& path, std::string bytes) {
  AtomicFile file(path, std::move(bytes));
  if (!file.is_direct() && !staged_places_.insert(file.place()).second)
    throw UsageError("two outputs are called '" + file.target() + "': give each its own file");
  staged_.push_back(std::move(file));
}

// What has no name to be given comes first, and of that the output last: where it fails, no file
// appears, and no output seems complete where another one has failed.
void Run::commit() {
  Terminal::clear_bar();
  std::for_each(staged_.rbegin(), staged_.rend(), [](AtomicFile& file) {
    if (file.is_direct()) file.commit();
  });
  // From here on it would leave some files without the others.
  release_time();
  for (AtomicFile& file : staged_)
    if (!file.is_direct()) file.commit();
}

void Run::write(const std::string& path, std::string bytes) {
  if (path == "-" && output() == "-" && !writes_nothing_)
    throw UsageError("two outputs on standard output: name a file for one of them");
  check_writable(path);
  further_files_.emplace_back(path, std::move(bytes));
}

void Run::write_mesh_file(const std::string& path, Document document) {
  set_style(document, path);
  add_comments(document);
  WriteResult result = transformesh::write_mesh(document);
  note_once(result.notes);
  write(path, std::move(result.bytes));
}

void Run::write_into(const std::string& folder, const std::string& name, std::string bytes) {
  // Where it cannot be made, writing says why.
  std::error_code ignored;
  fs::create_directories((fs::path(folder) / name).parent_path(), ignored);
  write(folder + '/' + name, std::move(bytes));
}

void Run::check_outputs(const std::vector<std::string>& options) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const std::string& name : options) {
    const std::string path = program_.find(name)->text();
    if (path == "-" && name != "output")
      throw UsageError("--" + name + ": name a file, as standard output is the mesh's");
    if (path == "-" || (path.empty() && name != "output")) continue;
    check_writable(path);
    if (is_written_directly(end_of_links(path))) continue;
    for (const auto& [other, other_path] : names)
      if (is_same_place(path, other_path))
        throw UsageError(std::string("give either --")
                             .append(other)
                             .append(" or --")
                             .append(name)
                             .append(" its own file, not both"));
    names.emplace_back(name, path);
  }
}

void Run::note_once(const std::vector<std::string>& lines) {
  for (const std::string& line : lines)
    if (reported_.insert(line).second) note(line);
}

void Run::stamp(Document& document) {
  is_stamped_ = true;
  add_comments(document);
}

void Run::add_comments(Document& document) {
  std::vector<std::string>& comments = document.style.comments;
  if (basis_.has_reference_edge()) set_reference_edge(comments, basis_.reference_edge());
  if (drop_bad_reference_edges(comments) > 0)
    note("a tm:reference-edge comment that holds no positive length is dropped");
  if (!program_.common.no_provenance) add_provenance(comments, provenance(program_));
}

void Run::write_mesh() {
  set_output_style(document());
  if (document().style.coordinate == Scalar::float32 && !program_.cleans)
    note_rounding_intersections(count_rounding_intersections(document().mesh, Scalar::float32));
  if (!is_stamped_) stamp(document());
  WriteResult result = transformesh::write_mesh(document());
  note_once(result.notes);
  detail((output() == "-" ? "standard output" : output()) + ": " + described(document()));
  output_counts_ = counts_of({&document(), 1});
  stage(output(), std::move(result.bytes));
}

void Run::write_kept() {
  if (!kept_) return;
  std::string outcome = "is not written";
  try {
    if (output() != "-") {
      write_mesh();
      staged_.back().commit();
      outcome = "holds " + kept_->second;
    }
  } catch (const std::bad_alloc&) {
    terminal_.out_of_memory();
  } catch (const Error& error) {
    terminal_.error(with_advice(error.problem(), program_));
  }
  terminal_.error(kept_->first + "; '" + output() + "' " + outcome);
}

int Run::finish() {
  // What is measured from now on would be another mesh.
  basis_.set_document(nullptr);
  const bool prints_report = program_.may_print_report() && !program_.writes_mesh();
  if (prints_report) bytes_ = report_text();
  if (!writes_nothing_) {
    phases_.begin("write");
    program_.writes_mesh() ? write_mesh() : stage(output(), std::move(bytes_));
    phases_.begin("");
  }
  show_settings();
  for (const auto& [key, value] : result_)
    if (!prints_report) detail(key + ": " + text_of(value));
  for (auto& [path, bytes] : further_files_) stage(path, std::move(bytes));
  if (!program_.common.report.empty()) stage(program_.common.report, full_report());
  commit();
  if (when_written_) when_written_();
  return answer_ ? exit_done : exit_no;
}

// --- Settings and report -------------------------------------------------------------------------

std::optional<double> Run::resolved(const Option& option) {
  const Value value = option.value();
  const auto* length = std::get_if<Length>(&value);
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
  for (const Option& option : program_.options) {
    const std::string value = option.text();
    if (option.is_common || value.empty() || value == "false") continue;
    const auto absolute = resolved(option);
    detail("--" + option.name() + (option.is_flag() ? "" : " " + value) +
           (absolute ? " = " + shortest_text(*absolute) : ""));
  }
  if (basis_.has_reference_edge())
    detail("reference edge " + shortest_text(basis_.reference_edge()));
}

std::string Run::report_text() const {
  std::string lines;
  for (const auto& [key, value] : result_) {
    if (program_.only_key != nullptr && key == *program_.only_key) return text_of(value) + '\n';
    lines += key + ": " + text_of(value) + '\n';
  }
  return program_.common.json ? json_text(object_of(result_)) : lines;
}

std::string Run::full_report() {
  Json report = {{"tool", program_.name}, {"version", TM_VERSION}, {"options", Json::object()}};
  for (const Option& option : program_.options) {
    if (option.is_common && !option.is_given) continue;
    std::string key = option.name();
    std::replace(key.begin(), key.end(), '-', '_');
    const auto absolute = resolved(option);
    report["options"][key] = absolute ? Json(*absolute) : json_of(option.value());
  }
  if (!input_counts_.empty()) report["input"] = object_of(input_counts_);
  if (!output_counts_.empty()) report["output"] = object_of(output_counts_);
  report["result"] = object_of(result_);
  report["timings"] = phases_.seconds();
  report["peak_memory_bytes"] = peak_memory_bytes();
  return json_text(report);
}

}  // namespace transformesh::tool
