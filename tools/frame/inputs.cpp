#include "frame/inputs.h"

#include "clean/box/tile.h"
#include "clean/open/join_soup.h"
#include "io/formats/file_format.h"
#include "io/streams/expand.h"
#include "io/streams/file_list.h"
#include "mesh/touching_borders.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace transformesh::tool {

std::string described(const Document& document) {
  return std::string(name_of(document.style.format)) + ", " +
         counted(document.mesh.positions.size(), "vertex") + ", " +
         counted(document.mesh.faces.size(), "face");
}

Entries counts_of(const std::vector<Document>& documents) {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (const Document& document : documents) {
    vertices += document.mesh.positions.size();
    faces += document.mesh.faces.size();
  }
  return {{"vertices", vertices}, {"faces", faces}};
}

namespace {

/// Returns the place of an input file; for stdin, the place of the file that it comes from.
std::string input_place(const std::string& path) {
  return place_of(path == "-" ? "/dev/stdin" : path);
}

/// Returns the places of all files that the command line names as inputs.
std::set<std::string> named_places(const Program& program) {
  std::set<std::string> places;
  for (const std::string& path : program.inputs) places.insert(input_place(path));
  for (const Option& option : program.options) {
    const std::string& kind = option.placeholder;
    const bool is_input = !option.is_output && (kind == "FILE" || kind == "WHERE");
    if (!is_input || option.text().empty()) continue;
    places.insert(input_place(option.text()));
    try {
      for (const std::string& path : files_at(option.text())) places.insert(place_of(path));
    } catch (const InputError&) {
      // The program reports the missing file when it reads it.
    }
  }
  return places;
}

}  // namespace

Inputs::Inputs(const Program& program, Messages& messages, Phases& phases)
    : program_(program),
      messages_(messages),
      phases_(phases),
      basis_(program.common.reference_edge),
      places_(named_places(program)) {}

void Inputs::read_all() {
  documents_.clear();
  const std::size_t count = program_.input.reads == Reads::meshes ? names().size() : 1;
  for (std::size_t i = 0; i < count; ++i) documents_.push_back(read_document(names()[i]));
  counts_ = counts_of(documents_);
}

void Inputs::continue_from(Document document) {
  documents_[0] = std::move(document);
  basis_ = LengthBasis("");
  refer_to_mesh();
}

void Inputs::refer_to_mesh() {
  basis_.set_document(&documents_[0]);
  if (basis_.is_reference_edge_chosen()) basis_.reference_edge();
  for (const Option& option : program_.options) resolved(option);
}

Bytes Inputs::read_once(const std::string& path) {
  if (path == "-" && stdin_is_read_)
    throw UsageError("standard input is named twice: name a file for one of the inputs");
  stdin_is_read_ = stdin_is_read_ || path == "-";
  places_.insert(input_place(path));
  return transformesh::read_all(path);
}

void Inputs::treat_soup(Mesh& mesh, const std::string& name, bool is_noted) {
  if (program_.input.soups == Soups::joined) {
    const StitchResult result = join_soup(mesh);
    joined_vertices_ += result.joined_vertices;
    if (result.joined_vertices > 0)
      messages_.note(name + ": " + counted(result.joined_vertices, "vertex") +
                     " joined with others in the same place, as tm-stitch does");
    if (result.dropped_faces > 0)
      messages_.note(name + ": " + counted(result.dropped_faces, "face") +
                     " with two corners in one place dropped");
  } else if (program_.input.soups == Soups::reported && !is_noted && is_soup(mesh)) {
    messages_.note(Problem{ErrorKind::not_joined,
                           name + ": " + counted(count_touching_borders(mesh), "border edge") +
                               " coincide: the faces share no vertices there"});
  }
}

/// A tile is a part of a larger mesh, written by tm-tile, whose borders are cuts. Only programs
/// that are made for tiles give correct results. If another program reads a tile, throws InputError
/// if it writes a mesh, and prints a note otherwise.
void Inputs::check_tile(const Document& document, const std::string& name) {
  if (program_.input.takes_tiles || !has_tile_comment(document.style.comments)) return;
  const std::string problem = name + " is a tile of a larger mesh, cut at its borders";
  if (program_.writes_mesh())
    throw InputError(problem + "; clean each tile with tm-clean, and join them with tm-tile join");
  messages_.note(problem);
}

void Inputs::keep_bytes(std::string_view bytes, const ReadResult& result) {
  if (!program_.input.keeps_bytes) return;
  // Every note, except the note on soups, states something that the reader left out or changed.
  const bool is_exact = result.notes.size() == (result.soup_note ? 1U : 0U) && !is_gzip(bytes);
  bytes_ = is_exact ? std::string(bytes) : std::string();
  format_ = result.document.style.format;
}

Document Inputs::read(const std::string& path) {
  Document document = read_document(path);
  note_unit(unit_of(document));
  return document;
}

void Inputs::note_unit(const Unit* other) const {
  messages_.note_all(notes_of_units(unit_of(documents_.front()), other));
}

Document Inputs::read_document(const std::string& path) {
  phases_.begin("read");
  const Bytes bytes = read_once(path);
  ReadResult result = read_mesh(bytes.view(), input_name(path), reading(path));
  keep_bytes(bytes.view(), result);
  const Soups soups = program_.input.soups;
  if (result.soup_note && soups != Soups::own && soups != Soups::joined) {
    std::string& line = result.notes[*result.soup_note];
    line = with_advice({ErrorKind::not_joined, line}, program_);
  }
  messages_.note_all(result.notes);
  check_tile(result.document, input_name(path));
  treat_soup(result.document.mesh, input_name(path), result.soup_note.has_value());
  messages_.detail(input_name(path) + ": " + described(result.document));
  phases_.begin("");
  return std::move(result.document);
}

std::optional<double> Inputs::used_reference_edge() {
  if (!basis_.has_reference_edge()) return std::nullopt;
  return basis_.reference_edge();
}

std::optional<double> Inputs::resolved(const Option& option) {
  const Value value = option.value();
  const auto* length = std::get_if<Length>(&value);
  if (length == nullptr) return std::nullopt;
  try {
    return basis_.resolve(*length);
  } catch (const std::runtime_error&) {
    // The error is not lost: if the program's body needs this length, it calls length() and
    // receives the error.
    return std::nullopt;
  }
}

}  // namespace transformesh::tool
