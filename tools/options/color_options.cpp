#include "options/color_options.h"

#include <filesystem>

#include "io/formats/file_format.h"
#include "support/counted.h"
#include "transformesh/errors.h"
#include "transformesh/image.h"
#include "transformesh/mesh_io.h"
#include "views/cameras/view_files.h"

namespace transformesh::tool {
namespace {

constexpr const char* material = "photographs";

Format output_format(const Run& run) {
  return format_for(Format::ply_little, run.program().common.format, run.out().name());
}

/// True if place_picture() can add a texture to a mesh in this format.
bool can_have_texture(Format format) {
  return format == Format::obj || format == Format::glb || is_ply(format);
}

std::string with_ending(const std::string& path, const char* ending) {
  return std::filesystem::path(path).replace_extension(ending).string();
}

std::string name_of_file(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

/// Writes a material file for OBJ, which names the texture image.
void add_material(Document& document, const std::string& picture, Run& run) {
  const std::string path = with_ending(run.out().name(), ".mtl");
  run.out().write(path, std::string("newmtl ") + material +
                            "\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " + picture + '\n');
  std::vector<std::string>& comments = document.style.comments;
  std::erase_if(comments, [](const std::string& comment) {
    return comment.starts_with("tm:mtllib ") || comment.starts_with("tm:material ");
  });
  comments.push_back("tm:mtllib " + name_of_file(path));
  comments.emplace_back("tm:material 1 ").append(material);
  Column& column =
      document.mesh.face_columns.get("material", Scalar::int32, document.mesh.faces.size());
  std::fill(column.values.begin(), column.values.end(), 1);
}

void place_picture(Document& document, const Image& picture, Run& run) {
  std::string png = write_png(picture);
  const Format format = output_format(run);
  if (format == Format::glb) {
    document.texture = std::move(png);
    return;
  }
  const std::string path = with_ending(run.out().name(), ".png");
  run.out().write(path, std::move(png));
  std::erase_if(document.style.comments,
                [](const std::string& comment) { return comment.starts_with("TextureFile "); });
  if (format == Format::obj)
    add_material(document, name_of_file(path), run);
  else
    document.style.comments.push_back("TextureFile " + name_of_file(path));
}

}  // namespace

void declare_texture(Program& program, ColorChoices& choices) {
  program.options.flag(
      "texture", &choices.has_texture,
      "make a texture: NAME.png beside -o NAME.obj or -o NAME.ply, or inside -o NAME.glb");
  program.options.integer("texture-size", &choices.atlas.most_size, 16, 32768,
                          "maximum width and height of the texture, in texels");
}

void check_texture(const ColorChoices& choices, const Run& run) {
  if (!choices.has_texture) return;
  if (run.out().name() == "-")
    throw UsageError(
        "--texture needs -o NAME.obj, NAME.glb or NAME.ply, because the picture is written beside "
        "the mesh");
  if (const Format format = output_format(run); !can_have_texture(format))
    throw UsageError("--texture is for .obj, .glb and .ply, not for " +
                     std::string(name_of(format)));
}

void color(Document& document, std::span<const PictureView> views, const ColorChoices& choices,
           Run& run) {
  ColorResult result;
  if (choices.has_texture) {
    const Atlas atlas = texture_surface(document.mesh, views, choices.atlas, run.progress());
    place_picture(document, atlas.picture, run);
    result = atlas.color;
    run.report("texture_width", atlas.picture.width);
    run.report("texture_height", atlas.picture.height);
    run.report("charts", atlas.charts);
    run.report("texel", atlas.texel);
  } else {
    result = color_vertices(document.mesh, views, run.progress());
  }
  run.report("unseen", result.unseen);
  run.report("disagreement", result.disagreement);
  run.report("largest_gain", result.largest_gain);
  if (result.unseen > 0)
    run.say().detail(counted(result.unseen, "vertex") + " visible in no photograph");
}

}  // namespace transformesh::tool
