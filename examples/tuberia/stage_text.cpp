#include "examples/tuberia/stage_text.hpp"

#include <algorithm>

#include "examples/tuberia/stage_words.hpp"

namespace tuberia::cli {
namespace {

/// "1 draw", "2,045 fragments".
std::string counted(std::int64_t count, const char* name) { return with_commas(count) + " " + name + (count == 1 ? "" : "s"); }

/// "v2 #17": the k-th vertex, number 17 of the mesh.
std::string vertex_name(const PrimitiveLife& life, std::size_t k) { return text("v%zu #%u", k, life.vertices[k].number); }

std::string header(const StageReport& report) {
  const RenderTarget& target = report.frame.target;
  std::string out = text("%s: %s in %s, target of %dx%d pixels, %s, %s\n", report.caption.c_str(),
                         counted(report.first_primitive.back(), "primitive").c_str(),
                         counted(static_cast<std::int64_t>(report.frame.draws.size()), "draw").c_str(), target.width(), target.height(),
                         name_of(target.colour_format()), name_of(target.depth_format()));
  const auto draw = static_cast<std::size_t>(report.draw);
  out += text("primitive %lld of the frame: primitive %lld of draw %d (mesh '%s', program '%s')%s\n",
              static_cast<long long>(report.first_primitive[draw] + report.primitive), static_cast<long long>(report.primitive), report.draw,
              report.mesh_of_draw[draw].c_str(), report.life.draw.program.c_str(), report.chosen ? "" : "; chosen since it is seen there");
  return out;
}

std::string vertex_stages(const PrimitiveLife& life) {
  std::string out = "\n1 vertex transform: object space -> clip space\n";
  for (std::size_t k = 0; k < life.vertices.size(); ++k) {
    const PrimitiveVertex& v = life.vertices[k];
    if (v.object)
      out += text("  %-10s object (%.6g, %.6g, %.6g)\n", vertex_name(life, k).c_str(), number(v.object->value.x),
                  number(v.object->value.y), number(v.object->value.z));
    out += text("  %-10s clip   x %.6f  y %.6f  z %.6f  w %.6f\n", v.object ? "" : vertex_name(life, k).c_str(), number(v.clip.x),
                number(v.clip.y), number(v.clip.z), number(v.clip.w));
    out += text("             outside of %s; beyond the view's borders: %s\n", planes_of(v.outcode).c_str(), view_borders_of(v.clip, life.limits).c_str());
  }
  out += "\n2 primitive assembly: vertices -> primitives\n  joins";
  for (std::size_t k = 0; k < life.vertices.size(); ++k) out += (k > 0 ? ", " : " ") + vertex_name(life, k);
  return out + "\n";
}

std::string clipping_stage(const PrimitiveLife& life) {
  std::string out = text("\n3 clipping: clip space -> clip space; z %s w and z <= w, guard band |x| <= %.4g w, |y| <= %.4g w\n  %s\n",
                         life.limits.z_low == 0 ? ">= 0" : ">= -", number(life.limits.guard_x), number(life.limits.guard_y), words_of(life.clip));
  for (std::size_t i = 0; i < life.corners.size(); ++i) {
    const PrimitiveCorner& c = life.corners[i];
    out += text("  c%zu%s  clip x %.6f  y %.6f  z %.6f  w %.6f  = %.4f v0 + %.4f v1 + %.4f v2\n", i, c.is_new ? " new" : "    ", number(c.clip.x),
                number(c.clip.y), number(c.clip.z), number(c.clip.w), c.weight[0], c.weight[1], c.weight[2]);
  }
  return out;
}

std::string screen_stages(const PrimitiveLife& life) {
  std::string out = text("\n4 perspective divide: clip space -> ndc -> screen; viewport %dx%d pixels at (%d, %d)\n", life.viewport.width_pixels,
                         life.viewport.height_pixels, life.viewport.x, life.viewport.y);
  for (std::size_t i = 0; i < life.corners.size(); ++i) {
    const PrimitiveCorner& c = life.corners[i];
    out += text("  c%zu  ndc (%.6f, %.6f, %.6f)  screen units (%d, %d) = pixels (%.4f, %.4f)  depth %.7f\n", i, c.ndc[0], c.ndc[1], c.ndc[2],
                c.x_units, c.y_units, c.x_units / 256.0, c.y_units / 256.0, number(c.depth));
  }
  constexpr const char* kCull[] = {"nothing", "back faces", "front faces"};
  out += text("\n5 culling: screen space; the front is %s, %s left out\n",
              life.culling.front_face == Winding::clockwise ? "clockwise" : "counter-clockwise", kCull[static_cast<int>(life.culling.cull)]);
  for (std::size_t i = 0; i < life.pieces.size(); ++i) {
    const PrimitivePiece& p = life.pieces[i];
    out += text("  t%zu", i);
    for (std::size_t k = 0; k < static_cast<std::size_t>(p.corner_count); ++k) out += text(" c%zu", p.corner[k]);
    if (p.corner_count == 3)
      out += text("  twice the area %lld square units (area %.4f pixels), %s", static_cast<long long>(p.twice_area),
                  std::abs(static_cast<double>(p.twice_area)) / 131072, p.is_front ? "front" : "back");
    out += text(": %s\n", words_of(p.verdict));
  }
  return out;
}

std::string attribute_stage(const PrimitiveLife& life) {
  const auto named = named_attributes(life.attributes);
  if (named.empty()) return {};
  std::string out = "\n  vertex attributes, of the corners that are drawn\n";
  for (std::size_t i = 0; i < life.corners.size(); ++i)
    for (const NamedAttribute& one : named) {
      if (life.corners[i].attributes.empty()) continue;
      out += text("  c%zu  %-18s", i, one.name);
      for (int k = 0; k < one.scalars; ++k) out += text(" %.6f", number(life.corners[i].attributes[static_cast<std::size_t>(one.offset + k)]));
      out += "\n";
    }
  return out;
}

std::string set_up_stage(const PrimitiveLife& life) {
  std::string out = "\n6 rasterization: setup, tiles of 64x64 pixels, blocks of 8x8\n";
  for (std::size_t i = 0; i < life.pieces.size(); ++i) {
    const PrimitivePiece& p = life.pieces[i];
    if (!p.set_up) continue;
    for (std::size_t k = 0; k < 3 && !p.shape; ++k) {
      const EdgeWords edge = edge_of(life, p, k);
      out += text("  t%zu edge c%zu->c%zu  per x %lld, per y %lld (square units a unit)  a %s edge: centres on it are %s\n", i, p.clockwise[(k + 1) % 3],
                  p.clockwise[(k + 2) % 3], static_cast<long long>(edge.per_x), static_cast<long long>(edge.per_y), edge.kind,
                  edge.top_left ? "covered" : "its neighbour's");
    }
    out += text("  t%zu bounds: pixels %d..%d x %d..%d; %zu tiles; %d blocks with fragments; %s\n", i, p.set_up->left, p.set_up->right, p.set_up->top,
                p.set_up->bottom, p.tiles.size(), p.blocks, p.set_up->perspective == kIsAffine ? "w is equal: no division" : "perspective: weights are divided");
  }
  return out;
}

/// One letter a pixel: '#' reached the target, 'x' did not, '.' not covered.
std::string coverage_picture(const StageReport& report) {
  const PixelRect& window = report.window;
  const int width = window.right - window.left, height = window.bottom - window.top;
  if (window.empty() || width > 72 || height > 48) return {};
  std::vector<std::string> rows(static_cast<std::size_t>(height), std::string(static_cast<std::size_t>(width), '.'));
  for (const FragmentRecord& f : report.life.fragments)
    rows[static_cast<std::size_t>(f.y - window.top)][static_cast<std::size_t>(f.x - window.left)] = f.reached_the_target() ? '#' : 'x';
  std::string out = text("  pixels %d..%d x %d..%d: # reached the target, x died on the way\n", window.left, window.right - 1, window.top, window.bottom - 1);
  for (const std::string& row : rows) out += "    " + row + "\n";
  return out;
}

std::string fragment_text(const FragmentRecord& f, const RecordedDraw& draw) {
  std::string out = text("  pixel (%d, %d)  screen weights %.6f %.6f %.6f, with perspective %.6f %.6f %.6f\n", f.x, f.y, f.weight[0], f.weight[1],
                         f.weight[2], f.perspective[0], f.perspective[1], f.perspective[2]);
  if (f.colour) out += "    program  " + colour_text(*f.colour) + "\n";
  for (const SampleRecord& s : f.samples) {
    if (f.samples.size() > 1) out += text("    sample %d\n", s.sample);
    out += text("    depth    %.7f (screen), ", number(s.depth_value));
    out += s.depth_code ? text("code %d %s stored %d\n", *s.depth_code, sign_of(draw.output.depth.test), s.before.depth) : std::string("not compared\n");
    if (s.before.stencil) out += text("    stencil  %d before, %d after\n", *s.before.stencil, *s.after.stencil);
    out += "    pixel    before " + colour_text(s.before) + "\n    pixel    after  " + colour_text(s.after) + "\n";
    out += "    fate     " + fate_of(f, s, draw) + "\n";
  }
  return out;
}

std::string fragment_stages(const StageReport& report, int fragments) {
  const PrimitiveLife& life = report.life;
  const FragmentFates& fates = life.fates;
  std::string out = "  " + counted(fates.covered, "fragment") + "\n" + coverage_picture(report);
  out += text("\n7-9 fragment shading, alpha test, depth test, blending\n  %lld discarded by the program, %lld failed the alpha test, %lld the stencil or "
              "depth test, %lld reached the target\n",
              static_cast<long long>(fates.discarded), static_cast<long long>(fates.failed_alpha), static_cast<long long>(fates.failed_depth),
              static_cast<long long>(fates.reached));
  const auto listed = std::min(life.fragments.size(), static_cast<std::size_t>(fragments));
  for (std::size_t i = 0; i < listed; ++i) out += fragment_text(life.fragments[i], life.draw);
  const std::int64_t others = life.fates.covered - static_cast<std::int64_t>(listed);
  if (others > 0) out += "  and " + with_commas(others) + " more\n";
  return out;
}

}  // namespace

std::string primitive_text(const StageReport& report, int fragments) {
  const PrimitiveLife& life = report.life;
  std::string out = header(report) + vertex_stages(life) + clipping_stage(life);
  if (life.pieces.empty()) return out;
  out += screen_stages(life);
  const bool drawn = std::any_of(life.pieces.begin(), life.pieces.end(), [](const PrimitivePiece& p) { return p.set_up.has_value(); });
  return drawn ? out + attribute_stage(life) + set_up_stage(life) + fragment_stages(report, fragments) : out;
}

std::string pixel_text(const StageReport& report) {
  const PixelHistory& pixel = *report.pixel;
  std::string out = text("%s: the history of pixel (%d, %d), %s of %s\n", report.caption.c_str(), pixel.x, pixel.y,
                         counted(static_cast<std::int64_t>(pixel.fragments.size()), "fragment").c_str(),
                         counted(static_cast<std::int64_t>(pixel.draws.size()), "draw").c_str());
  for (const SampleContents& s : pixel.initial)
    out += "  cleared to " + colour_text(s) + text(", depth code %d\n", s.depth);
  for (std::size_t i = 0; i < pixel.fragments.size(); ++i) {
    const FragmentRecord& f = pixel.fragments[i];
    const RecordedDraw& draw = pixel.draws[static_cast<std::size_t>(f.draw)];
    out += text("\nfragment %zu: primitive %u of draw %d (mesh '%s', program '%s')\n", i, f.primitive, f.draw,
                report.mesh_of_draw[static_cast<std::size_t>(f.draw)].c_str(), draw.program.c_str());
    std::string stages;
    for (const Stage stage : f.stages) stages += (stages.empty() ? "" : " -> ") + std::string(name_of(stage));
    out += "  " + stages + "\n" + fragment_text(f, draw);
  }
  return out;
}

}  // namespace tuberia::cli
