#include "evolution/loop/record.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "evolution/loop/event_row.h"
#include "io/streams/atomic_file.h"
#include "io/streams/output_target.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

constexpr const char* mesh_name = "/mesh.ply";
constexpr std::string_view settings_key = "tm:settings ";
constexpr std::string_view memory_key = "tm:state ";

std::optional<std::string> bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// Replaces control characters, such as line ends, which a PLY comment cannot contain.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return text;
}

/// Removes the comment that begins with `key` from `comments`, and returns the rest of its text.
std::string taken(std::vector<std::string>& comments, std::string_view key,
                  const std::string& file) {
  const auto found = std::find_if(comments.begin(), comments.end(),
                                  [&](const std::string& line) { return line.starts_with(key); });
  if (found == comments.end())
    throw InputError("'" + file +
                     "' is not the state of a run; remove its folder, or name another output");
  std::string rest = found->substr(key.size());
  comments.erase(found);
  return rest;
}

std::optional<SavedState> saved_in(const std::string& folder) {
  const std::string file = folder + mesh_name;
  const auto bytes = bytes_of(file);
  if (!bytes) return std::nullopt;
  SavedState state;
  state.document = read_mesh(*bytes, file).document;
  std::vector<std::string>& comments = state.document.style.comments;
  state.settings = taken(comments, settings_key, file);
  state.loop_state = LoopState(taken(comments, memory_key, file));
  state.loop_state("iteration", state.iteration)("paused", state.is_paused);
  return state;
}

void check_may_continue(const SavedState& state, const RecordOptions& options) {
  if (state.settings == options.settings) return;
  throw UsageError(
      ErrorKind::other_settings,
      "'" + options.state + "' holds a run with other settings (" + state.settings + ")",
      {.name = options.state});
}

void check_may_begin(const SavedState& state, const RecordOptions& options) {
  if (state.is_paused || options.restart) return;
  throw UsageError(ErrorKind::interrupted_run,
                   "'" + options.state + "' is the state of an interrupted run",
                   {.name = options.state});
}

/// Returns the text of a CSV file up to iteration `last`: the header and the rows of these
/// iterations.
std::string rows_until(const std::string& path, const std::string& header, std::size_t last) {
  std::string kept;
  if (is_written_directly(end_of_links(path))) return header + '\n';
  std::ifstream csv(path);
  for (std::string line; std::getline(csv, line);) {
    if (kept.empty() || std::strtoull(line.c_str(), nullptr, 10) <= last) kept += line + '\n';
  }
  return kept.empty() ? header + '\n' : kept;
}

std::string frame_name(std::size_t iteration) {
  const std::string digits = std::to_string(iteration);
  const std::string zeros(5 - std::min<std::size_t>(digits.size(), 5), '0');
  return '/' + std::string(frame_prefix) + zeros + digits + ".ply";
}

}  // namespace

namespace {

void remove_files_in(const std::string& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.is_regular_file(ignored)) std::filesystem::remove(entry.path(), ignored);
}

}  // namespace

void remove_state(const std::string& folder) {
  remove_files_in(folder);
  std::error_code ignored;
  std::filesystem::remove(folder, ignored);
}

Record::Record(RecordOptions options) : options_(std::move(options)) {
  options_.settings = one_line(options_.settings);
  std::optional<SavedState> state;
  if (!options_.state.empty()) {
    if (options_.is_alone) lock_ = std::make_shared<FolderLock>(options_.state);
    state = saved_in(options_.state);
  }
  if (!state) return;
  if (!options_.resume) {
    check_may_begin(*state, options_);
  } else {
    check_may_continue(*state, options_);
    iteration_ = state->iteration;
    resumed_ = std::move(state);
  }
}

std::optional<std::string> Record::find(const std::string& name) const {
  return resumed_ ? bytes_of(options_.state + '/' + name) : std::nullopt;
}

void Record::forget_earlier_state() const {
  if (!resumed_ && !options_.state.empty()) remove_files_in(options_.state);
}

void Record::begin(const Document& document, const std::string& csv_header,
                   const LoopState& loop_state) {
  iteration_ = resumed_ ? resumed_->iteration : 0;
  rows_ = opened(options_.csv, csv_header);
  event_rows_ = opened(options_.events, event_row({}).header());
  if (resumed_) return;
  if (!options_.state.empty()) {
    forget_earlier_state();
    make_folder(options_.state);
    for (const auto& [name, bytes] : std::exchange(added_, {}))
      write_file(options_.state + '/' + name, bytes);
  }
  keep_frame(document, 0);
  save(document, 0, loop_state);
}

/// Opens a CSV file. If the run is continued, the file keeps its rows up to the recorded state.
/// Returns null if `path` is empty.
std::shared_ptr<const LineFile> Record::opened(const std::string& path,
                                               const std::string& header) const {
  if (path.empty()) return nullptr;
  return std::make_shared<LineFile>(
      path, resumed_ ? rows_until(path, header, iteration_) : header + '\n');
}

void Record::keep(const Document& document, std::size_t iteration, const std::string& row,
                  const LoopState& loop_state, const std::vector<std::string>& event_rows) {
  if (rows_) rows_->append(row);
  if (event_rows_)
    for (const std::string& event_row : event_rows) event_rows_->append(event_row);
  keep_frame(document, iteration);
  save(document, iteration, loop_state);
  iteration_ = iteration;
}

void Record::save(const Document& document, std::size_t iteration, LoopState loop_state,
                  bool is_paused) const {
  if (options_.state.empty()) return;
  loop_state("iteration", iteration)("paused", is_paused);
  Document written = document;
  written.style.format = Format::ply_little;
  std::vector<std::string>& comments = written.style.comments;
  comments.push_back(std::string(settings_key) + options_.settings);
  comments.push_back(std::string(memory_key) + loop_state.text());
  make_folder(options_.state);
  write_file(options_.state + mesh_name, write_mesh(written).bytes);
}

void Record::keep_frame(const Document& document, std::size_t iteration) const {
  const bool is_nothing = document.mesh.positions.empty() && document.mesh.faces.empty();
  if (options_.frames.empty() || iteration % options_.every != 0 || is_nothing) return;
  make_folder(options_.frames);
  write_file(options_.frames + frame_name(iteration), write_mesh(document).bytes);
}

}  // namespace transformesh
