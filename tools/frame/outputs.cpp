#include "frame/outputs.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "clean/intersect/rounding_intersections.h"
#include "io/comments.h"
#include "io/formats/file_format.h"
#include "io/streams/output_target.h"
#include "support/counted.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh::tool {
namespace {

namespace fs = std::filesystem;

/// Returns the words as a list such as ".a, .b or .c".
std::string listed(const std::vector<std::string>& words) {
  std::string text = words[0];
  for (std::size_t i = 1; i < words.size(); ++i)
    text += (i + 1 < words.size() ? ", " : " or ") + words[i];
  return text;
}

/// Throws UsageError if the name of a file that an option writes has none of the endings.
void check_ending(const std::string& option, const std::string& name,
                  const std::vector<std::string>& known, const std::string& advice) {
  const std::string ending = unknown_ending(name, known);
  if (!ending.empty())
    throw UsageError("--" + option + ": '" + name + "' ends in " + ending +
                     ", which is not an output format; " + advice);
}

}  // namespace

bool Outputs::is_terminal() const { return name() == "-" && isatty(STDOUT_FILENO) == 1; }

void Outputs::print_line(const std::string& text) {
  if (!write_all(STDOUT_FILENO, text + '\n')) throw_not_written("standard output");
}

// --- Checks --------------------------------------------------------------------------------------

void Outputs::check_name() const {
  const auto check = [&](const std::vector<std::string>& known, const std::string& advice) {
    check_ending("output", name(), known, advice);
  };
  const OutputRules& rules = program_.output;
  if (rules.writes == Writes::picture)
    check(rules.picture_endings, "pictures are " + listed(rules.picture_endings));
  if (rules.writes == Writes::page) check({".html", ".htm"}, "pages are .html");
  if (program_.writes_mesh() && program_.common.format.empty())
    check(written_endings(),
          "take " + listed(written_endings()) + ", or name its format with --format");
  if (rules.writes == Writes::picture && is_terminal())
    throw UsageError("not writing a picture to a terminal: redirect it or name a file with -o");
}

void Outputs::check_files(bool is_main_folder) const {
  const bool may_replace_input = program_.writes_mesh() || program_.output.writes == Writes::text;
  std::map<std::string, std::string> options;  // names of options by the place of their file
  for (const Option& option : program_.options) {
    const std::string path = option.text();
    const std::string dashed = "--" + option.name();
    const bool is_main = option.name() == "output";
    if (!option.is_output || (is_main ? is_main_folder : path.empty())) continue;
    if (path == "-" && !is_main && program_.is_evolution())
      throw UsageError(dashed + ": name a file, because standard output holds the mesh");
    if (!option.endings.empty())
      check_ending(option.name(), path, option.endings, "take " + listed(option.endings));
    check_writable(path);
    const std::string target = end_of_links(path);
    if (is_written_directly(target)) continue;
    const auto [other, is_new] = options.emplace(place_of(target), dashed);
    if (!is_new)
      throw UsageError(other->second + " and " + dashed + " have the same file: give each its own");
    if (!is_main || !may_replace_input) check_is_no_input(path);
  }
}

void Outputs::check_is_no_input(const std::string& path) const {
  if (inputs_.contains(path))
    throw UsageError("'" + path + "' is an input, which would be lost: name another output");
}

// --- The mesh ------------------------------------------------------------------------------------

void Outputs::set_style_of(Document& document, const std::string& path) {
  const CommonValues& values = program_.common;
  std::optional<Scalar> coordinate;
  if (values.as_float || values.as_double)
    coordinate = values.as_float ? Scalar::float32 : Scalar::float64;
  const Format format = format_for(document.style.format, values.format, path);
  const bool is_rounded =
      document.style.coordinate == Scalar::float64 && (values.as_float || holds_floats(format));
  const std::vector<Vec3> before = is_rounded ? document.mesh.positions : std::vector<Vec3>();
  const std::size_t collapsed = set_format(document, format, coordinate);
  if (is_rounded && !program_.output.is_clean && !are_intersections_noted_)
    note_rounding_intersections(count_rounding_intersections(document.mesh, before));
  if (collapsed > 0)
    messages_.note(counted(collapsed, "face") +
                   " with two corners at one position after rounding to floats");
}

void Outputs::set_style(Document& document) {
  set_style_of(document, name());
  if (is_terminal() && !is_text(document.style.format))
    throw UsageError(
        "not writing binary data to a terminal: redirect it with > or |, name a file with -o, or "
        "ask for text with --format ply-ascii");
}

void Outputs::note_rounding_intersections(std::size_t pairs) {
  if (pairs == 0) return;
  are_intersections_noted_ = true;
  messages_.note(
      counted(pairs, "pair") + " of faces " + (pairs == 1 ? "intersects" : "intersect") +
      " only as floats: let tm-clean write the file, or write doubles, in PLY, OFF, OBJ or VTP");
}

void Outputs::stamp(Document& document) {
  is_stamped_ = true;
  add_comments(document);
}

void Outputs::add_comments(Document& document) {
  std::vector<std::string>& comments = document.style.comments;
  if (const auto edge = inputs_.used_reference_edge()) set_reference_edge(comments, *edge);
  if (drop_bad_reference_edges(comments) > 0)
    messages_.note("a tm:reference-edge comment without a positive length is dropped");
  if (!program_.common.no_provenance) add_provenance(comments, provenance(program_));
}

void Outputs::stage_mesh() {
  Document& document = inputs_.document();
  set_style(document);
  if (document.style.coordinate == Scalar::float32 && !program_.output.is_clean &&
      !are_intersections_noted_)
    note_rounding_intersections(count_rounding_intersections(document.mesh, Scalar::float32));
  if (!is_stamped_) stamp(document);
  WriteResult result = transformesh::write_mesh(document);
  messages_.note_once(result.notes);
  messages_.detail((name() == "-" ? "standard output" : name()) + ": " + described(document));
  counts_ = {{"vertices", document.mesh.positions.size()}, {"faces", document.mesh.faces.size()}};
  stage(name(), std::move(result.bytes));
}

// --- Files ---------------------------------------------------------------------------------------

void Outputs::write(const std::string& path, std::string bytes) {
  if (path == "-" && name() == "-" && !writes_nothing_)
    throw UsageError("two outputs would go to standard output: name a file for one of them");
  check_writable(path);
  further_files_.emplace_back(path, std::move(bytes));
}

void Outputs::write_mesh_file(const std::string& path, Document document) {
  set_style_of(document, path);
  add_comments(document);
  WriteResult result = transformesh::write_mesh(document);
  messages_.note_once(result.notes);
  write(path, std::move(result.bytes));
}

void Outputs::write_into(const std::string& folder, const std::string& name, std::string bytes) {
  // If the folder cannot be created, writing the file fails and reports the reason.
  std::error_code ignored;
  fs::create_directories((fs::path(folder) / name).parent_path(), ignored);
  write(folder + '/' + name, std::move(bytes));
}

void Outputs::stage(const std::string& path, std::string bytes) {
  AtomicFile file(path, std::move(bytes));
  if (!file.is_direct() && path != name()) check_is_no_input(path);
  if (!file.is_direct() && !staged_places_.insert(file.place()).second)
    throw UsageError("two outputs have the name '" + file.target() + "': give each its own file");
  staged_.push_back(std::move(file));
}

void Outputs::stage_all() {
  if (!writes_nothing_) program_.writes_mesh() ? stage_mesh() : stage(name(), std::move(bytes_));
  for (auto& [path, bytes] : further_files_) stage(path, std::move(bytes));
}

// First writes the outputs that cannot be renamed, such as stdout; the main output is the last of
// them. If one of these writes fails, no other file has been renamed to its final name yet.
void Outputs::commit() {
  Terminal::clear_bar();
  std::for_each(staged_.rbegin(), staged_.rend(), [](AtomicFile& file) {
    if (file.is_direct()) file.commit();
  });
  // The time limit is released, because it must not end the program between the renaming of two
  // files.
  release_time();
  for (AtomicFile& file : staged_)
    if (!file.is_direct()) file.commit();
  if (when_written_) when_written_();
}

void Outputs::write_kept() {
  if (!kept_) return;
  std::string outcome = "is not written";
  try {
    if (name() != "-") {
      stage_mesh();
      staged_.back().commit();
      outcome = "holds " + kept_->second;
    }
  } catch (const std::bad_alloc&) {
    messages_.out_of_memory();
  } catch (const Error& error) {
    messages_.error(with_advice(error.problem(), program_));
  }
  messages_.error(kept_->first + "; '" + name() + "' " + outcome);
}

}  // namespace transformesh::tool
