#include "boolean/boolean_script.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "boolean/local_boolean.h"
#include "mesh/coordinate_spacing.h"
#include "support/suggestion.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

std::string in_line(std::size_t line, const std::string& what) {
  return "line " + std::to_string(line) + " of the script: " + what;
}

[[noreturn]] void refuse(std::size_t line, const std::string& what) {
  throw InputError(in_line(line, what));
}

constexpr std::string_view blanks = " \t\r";

// Splits a line into words at blanks. A word in double quotes may contain blanks; '#' at the start
// of a word begins a comment.
std::vector<std::string> words_of(std::string_view line, std::size_t number) {
  std::vector<std::string> words;
  for (;;) {
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos || line[begin] == '#') return words;
    const bool is_quoted = line[begin] == '"';
    line.remove_prefix(is_quoted ? begin + 1 : begin);
    std::size_t end = is_quoted ? line.find('"') : line.find_first_of(blanks);
    if (end == std::string_view::npos && is_quoted) refuse(number, "a quote is not closed");
    end = std::min(end, line.size());
    words.emplace_back(line.substr(0, end));
    line.remove_prefix(std::min(line.size(), is_quoted ? end + 1 : end));
  }
}

ScriptLine line_of(const std::vector<std::string>& words, std::size_t number) {
  if (words.size() < 4 || words[1] != "=") refuse(number, "expected NAME = OPERATION OPERAND...");
  const std::vector<std::string>& names = boolean_operation_names();
  const std::string nearest = nearest_name(words[2], names);
  if (nearest != words[2])
    refuse(number, "unknown operation '" + words[2] + "'; did you mean '" + nearest + "'?");
  return {number, words[0], boolean_operation(words[2]), {words.begin() + 3, words.end()}};
}

/// The mesh that a name in the script stands for: a mesh from a file, or the result of a line. The
/// result of a line may be an EditedSolid, which can be changed in place.
struct Value {
  Mesh mesh;
  /// If set, holds the mesh instead of `mesh`, which is empty then.
  std::optional<EditedSolid> solid;
  /// Bound on the displacement of the surface by merged flat faces.
  double displacement = 0;

  Mesh& whole() {
    if (solid) mesh = solid->take();
    solid.reset();
    return mesh;
  }
};

class ScriptRun {
 public:
  ScriptRun(const std::vector<ScriptLine>& lines,
            const std::function<Mesh(const std::string&)>& read, const BooleanOptions& options,
            const Progress& progress)
      : lines_(lines), read_(read), options_(options), progress_(progress) {}
  ScriptResult run();

 private:
  void find_last_uses();
  bool run_in_place(const ScriptLine& line);
  Value run_line(std::size_t at);
  void run_named_line(std::size_t at);
  Value& value_of(const std::string& name);
  void drop_unused(std::size_t at);

  const std::vector<ScriptLine>& lines_;
  const std::function<Mesh(const std::string&)>& read_;
  const BooleanOptions& options_;
  const Progress& progress_;
  std::map<std::string, std::size_t> last_use_;  ///< for each operand the last line that uses it
  std::map<std::string, Value> values_;
  ScriptResult result_;
};

void ScriptRun::find_last_uses() {
  for (std::size_t at = 0; at < lines_.size(); ++at)
    for (const std::string& operand : lines_[at].operands) last_use_[operand] = at;
}

Value& ScriptRun::value_of(const std::string& name) {
  const auto known = values_.find(name);
  if (known != values_.end()) return known->second;
  Mesh mesh = read_(name);
  round_positions(mesh, options_.coordinate);
  return values_.emplace(name, Value{std::move(mesh), {}, 0}).first->second;
}

// Runs a line of the form A = union A B or A = difference A B by changing A in place, if A is the
// result of an earlier line. Returns false if the line has another form, or if combine_in_place()
// does not change A.
bool ScriptRun::run_in_place(const ScriptLine& line) {
  const bool can_be =
      line.operation == BooleanOperation::unite || line.operation == BooleanOperation::subtract;
  const std::vector<std::string>& names = line.operands;
  if (!can_be || names.size() != 2 || names[0] != line.result || names[1] == names[0]) return false;
  Value& changed = value_of(names[0]);
  if (!changed.solid) return false;
  Value& other = value_of(names[1]);
  const std::optional<LocalBooleanResult> made =
      combine_in_place(line.operation, *changed.solid, other.whole(), options_);
  if (!made) return false;
  result_.pairs += made->pairs;
  changed.displacement =
      std::max(changed.displacement, other.displacement) + made->merge_displacement;
  ++result_.in_place;
  return true;
}

Value ScriptRun::run_line(std::size_t at) {
  const ScriptLine& line = lines_[at];
  std::vector<Operand> operands;
  std::vector<std::string> names;
  double displacement = 0;
  for (const std::string& name : line.operands) {
    Value& value = value_of(name);
    operands.push_back({&value.whole(), name});
    names.push_back(in_line(line.number, name));
    displacement = std::max(displacement, value.displacement);
  }
  BooleanResult made = boolean(line.operation, operands, options_);
  for (Problem& problem : problems_of(made, names)) result_.problems.push_back(std::move(problem));
  result_.pairs += made.pairs;
  result_.rounding_repairs += made.rounding_repairs;
  return {{}, EditedSolid(std::move(made.mesh)), displacement + made.merge_displacement};
}

void ScriptRun::run_named_line(std::size_t at) {
  const auto in_this_line = [&](const Error& error) {
    return in_line(lines_[at].number, error.what());
  };
  try {
    if (run_in_place(lines_[at])) return;
    Value made = run_line(at);
    values_.insert_or_assign(lines_[at].result, std::move(made));
  } catch (const GoalError& error) {
    throw GoalError(error.kind(), in_this_line(error), error.data());
  } catch (const InputError& error) {
    throw InputError(error.kind(), in_this_line(error), error.data());
  }
}

void ScriptRun::drop_unused(std::size_t at) {
  std::erase_if(values_, [&](const auto& value) {
    const auto use = last_use_.find(value.first);
    const bool is_used = use != last_use_.end() && use->second > at;
    return !is_used && value.first != lines_[at].result;
  });
}

ScriptResult ScriptRun::run() {
  find_last_uses();
  for (std::size_t at = 0; at < lines_.size(); ++at) {
    progress_("combine", static_cast<double>(at) / static_cast<double>(lines_.size()));
    run_named_line(at);
    drop_unused(at);
  }
  Value& last = values_.at(lines_.back().result);
  result_.merge_displacement = last.displacement;
  result_.mesh = std::move(last.whole());
  return std::move(result_);
}

}  // namespace

const std::vector<std::string>& boolean_operation_names() {
  static const std::vector<std::string> names{"union", "intersection", "difference", "xor"};
  return names;
}

BooleanOperation boolean_operation(std::string_view name) {
  const std::vector<std::string>& names = boolean_operation_names();
  return static_cast<BooleanOperation>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::vector<Problem> problems_of(const BooleanResult& result,
                                 const std::vector<std::string>& names) {
  std::vector<Problem> problems;
  for (const std::size_t i : result.inside_out)
    problems.push_back(
        {ErrorKind::inside_out, names[i] + " encloses nothing: its faces are oriented inwards"});
  for (const std::size_t i : result.canceling)
    problems.push_back({ErrorKind::double_sided,
                        names[i] + " encloses nothing: its faces coincide and cancel out"});
  if (result.reason == ErrorKind::thinner_than_rounding)
    problems.push_back(
        {ErrorKind::thinner_than_rounding,
         names[0] + ": the result is thinner than the rounding error, so nothing of it remains"});
  return problems;
}

std::vector<ScriptLine> parse_boolean_script(std::string_view text) {
  std::vector<ScriptLine> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::vector<std::string> words = words_of(text.substr(0, end), number);
    if (!words.empty()) lines.push_back(line_of(words, number));
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  if (lines.empty()) throw InputError("the script has no line with an operation");
  return lines;
}

ScriptResult run_boolean_script(const std::vector<ScriptLine>& lines,
                                const std::function<Mesh(const std::string& file)>& read,
                                const BooleanOptions& options, const Progress& progress) {
  return ScriptRun(lines, read, options, progress).run();
}

}  // namespace transformesh
