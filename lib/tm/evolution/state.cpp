#include "tm/evolution/state.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

#include "tm/io/atomic_file.h"
#include "tm/io/mesh_io.h"
#include "tm/support/error.h"
#include "tm/support/length.h"

namespace transformesh {
namespace {

constexpr const char* mesh_name = "mesh.ply";
constexpr std::string_view settings_key = "tm:settings ";
constexpr std::string_view state_key = "tm:state ";
constexpr const char* iteration_key = "iteration";
constexpr const char* paused_key = "paused";

std::optional<std::string> bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// Removes the comment that begins with the key, and returns the rest of it.
std::string taken(std::vector<std::string>& comments, std::string_view key,
                  const std::string& file) {
  const auto found = std::find_if(comments.begin(), comments.end(),
                                  [&](const std::string& line) { return line.starts_with(key); });
  if (found == comments.end())
    throw InputError("'" + file +
                     "' is no state of a run; remove its folder, or name another output");
  std::string rest = found->substr(key.size());
  comments.erase(found);
  return rest;
}

double taken(Values& values, const char* key) {
  const auto found = values.find(key);
  if (found == values.end()) return 0;
  const double value = found->second;
  values.erase(found);
  return value;
}

double number_of(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && rest == end) return value;
  throw InputError("a state holds '" + text + "', which is no number; begin anew with --restart");
}

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw OutputError("cannot make the folder '" + path + "': " + error.message());
}

}  // namespace

double value_or(const Values& values, const std::string& key, double otherwise) {
  const auto found = values.find(key);
  return found == values.end() ? otherwise : found->second;
}

std::string text_of(const Values& values) {
  std::string text;
  for (const auto& [key, value] : values)
    text += (text.empty() ? "" : " ") + key + ' ' + shortest_text(value);
  return text;
}

Values values_of(const std::string& text) {
  Values values;
  std::istringstream words(text);
  for (std::string key, number; words >> key >> number;) values[key] = number_of(number);
  return values;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return text;
}

std::optional<SavedState> StateFolder::load() const {
  const auto bytes = bytes_of(file(mesh_name));
  if (!bytes) return std::nullopt;
  SavedState state;
  state.document = read_mesh(*bytes, file(mesh_name)).document;
  std::vector<std::string>& comments = state.document.style.comments;
  state.settings = taken(comments, settings_key, file(mesh_name));
  state.values = values_of(taken(comments, state_key, file(mesh_name)));
  state.iteration = static_cast<std::size_t>(taken(state.values, iteration_key));
  state.is_paused = taken(state.values, paused_key) != 0;
  return state;
}

void StateFolder::save(const Document& document, const State& state) const {
  make_folder(path_);
  Values values = state.values;
  values[iteration_key] = static_cast<double>(state.iteration);
  values[paused_key] = state.is_paused ? 1 : 0;
  Document written = document;
  written.style.format = Format::ply_little;
  std::vector<std::string>& comments = written.style.comments;
  comments.push_back(std::string(settings_key) + one_line(state.settings));
  comments.push_back(std::string(state_key) + text_of(values));
  write_file(file(mesh_name), write_mesh(written).bytes);
}

void StateFolder::add(const std::string& name, const std::string& bytes) const {
  make_folder(path_);
  write_file(file(name), bytes);
}

std::optional<std::string> StateFolder::find(const std::string& name) const {
  return bytes_of(file(name));
}

void StateFolder::remove() const {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(path_, ignored))
    if (entry.is_regular_file(ignored)) std::filesystem::remove(entry.path(), ignored);
  std::filesystem::remove(path_, ignored);
}

}  // namespace transformesh
