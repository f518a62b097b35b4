#include <chrono>
#include <cstdio>

#include "examples/tuberia/gallery/gallery.hpp"
#include "examples/tuberia/render_model.hpp"
#include "scene/description/read_scene.hpp"
#include "scene/content/develop.hpp"
#include "scene/frame/scene_frame.hpp"

namespace tuberia::cli {

Result<GalleryDrawing> scene_drawing(const std::filesystem::path& file, Pipeline& pipeline) {
  auto scene = read_scene(file);
  if (!scene) return scene.error();
  auto frame = SceneFrame::create(*std::move(scene));
  if (!frame) return Error{file.string() + ": " + frame.error().message};
  const auto start = std::chrono::steady_clock::now();
  auto light = frame->draw(pipeline);
  if (!light) return Error{file.string() + ": " + light.error().message};
  const double milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();

  char performance[96];
  std::snprintf(performance, sizeof performance, "%s triangles, %zu passes, %.0f ms", with_commas(frame->triangle_count()).c_str(),
                frame->passes().size(), milliseconds);
  const SceneDescription& shown = frame->scene();
  return GalleryDrawing{srgb_codes_of(developed(*std::move(light), shown.picture)), shown.title, shown.source, shown.caption, performance};
}

}  // namespace tuberia::cli
