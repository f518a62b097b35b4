#include "pipeline/primitive_recorder.hpp"

#include <algorithm>
#include <bit>

#include "math/edge_function.hpp"
#include "pipeline/clipping.hpp"

namespace tuberia {
namespace {

/// The slots of triangle i of a batch.
std::array<std::uint32_t, 3> slots_of(const TriangleBatch& triangles, int i) {
  const auto at = static_cast<std::size_t>(i);
  return {triangles.v0[at], triangles.v1[at], triangles.v2[at]};
}

/// Calls body(i) for every triangle of the batch that belongs to the primitive.
template <class Body>
void for_each_of(const TriangleBatch& triangles, std::uint32_t primitive, Body&& body) {
  for (int i = 0; i < triangles.count; ++i)
    if (triangles.primitive[static_cast<std::size_t>(i)] == primitive) body(i);
}

ClipPosition clip_position(const VertexBatch& vertices, std::uint32_t slot) {
  return {vertices.clip_x[slot], vertices.clip_y[slot], vertices.clip_z[slot], vertices.clip_w[slot]};
}

}  // namespace

void PrimitiveRecorder::begin(const DrawCall& draw, const AcceptedDraw& accepted) {
  draw_ = &draw;
  life_.draw = {std::string(draw.program.interface().name), accepted.output, draw.state.rasterization.flat_shading};
  life_.topology = draw.state.assembly.topology;
  life_.attributes = draw.program.interface().attributes();
  life_.viewport = accepted.viewport;
  life_.clip_rect = accepted.clip;
  life_.limits = clip_limits(accepted.viewport, draw.state.clipping.volume);
  life_.culling = draw.state.culling;
  watch_.begin(accepted.output, 0);
}

bool PrimitiveRecorder::holds(const Chunk& chunk) const noexcept {
  const auto number = static_cast<std::int64_t>(life_.primitive);
  return number >= chunk.range.first && number < chunk.range.first + chunk.range.count;
}

void PrimitiveRecorder::after(Stage stage, const Chunk& chunk) {
  if (!holds(chunk)) return;
  switch (stage) {
    case Stage::primitive_assembly: return assembled(chunk);
    case Stage::clipping: return clipped(chunk);
    case Stage::perspective_divide: return projected(chunk);
    case Stage::culling: return culled(chunk);
    case Stage::vertex_attributes: return attributes(chunk);
    case Stage::set_up: return set_up(chunk);
    case Stage::binning: return binned(chunk);
    default: return;
  }
}

void PrimitiveRecorder::assembled(const Chunk& chunk) {
  for_each_of(chunk.triangles, life_.primitive, [&](int i) {
    life_.found = true;
    vertex_slot_ = slots_of(chunk.triangles, i);
    for (const std::uint32_t slot : vertex_slot_) {
      PrimitiveVertex vertex{.number = chunk.vertices.source[slot], .object = {}, .clip = clip_position(chunk.vertices, slot),
                             .outcode = chunk.vertices.outcode[slot]};
      if (!draw_->mesh.positions.empty()) vertex.object = ObjectPosition{draw_->mesh.positions[vertex.number]};
      life_.vertices.push_back(vertex);
    }
  });
}

void PrimitiveRecorder::clipped(const Chunk& chunk) {
  std::uint32_t any = 0;
  for (const PrimitiveVertex& vertex : life_.vertices) any |= vertex.outcode;
  for_each_of(chunk.triangles, life_.primitive, [&](int i) {
    PrimitivePiece piece;
    const auto slots = slots_of(chunk.triangles, i);
    for (std::size_t k = 0; k < 3; ++k) piece.corner[k] = corner_of(chunk, slots[k]);
    life_.pieces.push_back(piece);
  });
  if (any == 0) life_.clip = PrimitiveLife::Clip::untouched;
  else if ((any & outcode::invalid) != 0) life_.clip = PrimitiveLife::Clip::not_finite;
  else life_.clip = life_.pieces.empty() ? PrimitiveLife::Clip::outside : PrimitiveLife::Clip::cut;
}

std::size_t PrimitiveRecorder::corner_of(const Chunk& chunk, std::uint32_t slot) {
  const auto known = std::find_if(life_.corners.begin(), life_.corners.end(), [&](const PrimitiveCorner& c) { return c.slot == slot; });
  if (known != life_.corners.end()) return static_cast<std::size_t>(known - life_.corners.begin());
  PrimitiveCorner corner{.slot = slot, .clip = clip_position(chunk.vertices, slot)};
  const std::size_t originals = chunk.vertices.source.size();
  corner.is_new = slot >= originals;
  if (corner.is_new) {
    const ClippedVertex& made = chunk.vertices.clipped[slot - originals];
    std::copy(made.weight, made.weight + 3, corner.weight.begin());
  } else {
    for (std::size_t k = 0; k < 3; ++k) corner.weight[k] = slot == vertex_slot_[k] ? 1 : 0;
  }
  life_.corners.push_back(std::move(corner));
  return life_.corners.size() - 1;
}

void PrimitiveRecorder::projected(const Chunk& chunk) {
  for (PrimitiveCorner& corner : life_.corners) {
    const auto w = static_cast<double>(corner.clip.w);
    corner.ndc = {static_cast<double>(corner.clip.x) / w, static_cast<double>(corner.clip.y) / w, static_cast<double>(corner.clip.z) / w};
    corner.x_units = chunk.vertices.screen_x[corner.slot];
    corner.y_units = chunk.vertices.screen_y[corner.slot];
    corner.depth = chunk.vertices.depth[corner.slot];
  }
  const auto place = [&](std::size_t corner) { return SnappedPoint{life_.corners[corner].x_units, life_.corners[corner].y_units}; };
  for (PrimitivePiece& piece : life_.pieces) {
    piece.twice_area = twice_area(place(piece.corner[0]), place(piece.corner[1]), place(piece.corner[2]));
    piece.is_front = (piece.twice_area > 0) == (life_.culling.front_face == Winding::clockwise);
  }
}

PrimitivePiece* PrimitiveRecorder::piece_with(const std::array<std::uint32_t, 3>& slots) {
  for (PrimitivePiece& piece : life_.pieces) {
    const auto slot = [&](std::size_t k) { return life_.corners[piece.corner[k]].slot; };
    // Culling may have exchanged the last two.
    if (slot(0) == slots[0] && std::min(slot(1), slot(2)) == std::min(slots[1], slots[2]) &&
        std::max(slot(1), slot(2)) == std::max(slots[1], slots[2]))
      return &piece;
  }
  return nullptr;
}

void PrimitiveRecorder::culled(const Chunk& chunk) {
  const CullFace cull = life_.culling.cull;
  for (PrimitivePiece& piece : life_.pieces) {
    const bool unwanted = (cull == CullFace::front && piece.is_front) || (cull == CullFace::back && !piece.is_front);
    piece.verdict = piece.twice_area == 0 ? PrimitivePiece::Verdict::no_area
                    : unwanted            ? PrimitivePiece::Verdict::turned_away
                                          : PrimitivePiece::Verdict::no_pixel_centre;
  }
  for_each_of(chunk.triangles, life_.primitive, [&](int i) {
    const auto slots = slots_of(chunk.triangles, i);
    PrimitivePiece* piece = piece_with(slots);
    if (piece == nullptr) return;
    piece->verdict = PrimitivePiece::Verdict::drawn;
    for (std::size_t k = 0; k < 3; ++k) piece->corner[k] = corner_of(chunk, slots[k]);
  });
}

void PrimitiveRecorder::attributes(const Chunk& chunk) {
  const auto stride = static_cast<std::size_t>(chunk.vertices.stride);
  const auto scalars = static_cast<std::size_t>(scalar_count(life_.attributes));
  for (const PrimitivePiece& piece : life_.pieces) {
    if (piece.verdict != PrimitivePiece::Verdict::drawn || scalars == 0) continue;
    for (const std::size_t number : piece.corner) {
      PrimitiveCorner& corner = life_.corners[number];
      const float* record = chunk.vertices.attributes.data() + corner.slot * stride;
      corner.attributes.assign(record, record + scalars);
    }
  }
}

void PrimitiveRecorder::set_up(const Chunk& chunk) {
  for (std::size_t i = 0; i < chunk.screen_triangles.size(); ++i) {
    const ScreenTriangle& record = chunk.screen_triangles[i];
    if (record.primitive != life_.primitive) continue;
    PrimitivePiece* piece = piece_with({record.vertex[0], record.vertex[1], record.vertex[2]});
    if (piece == nullptr) continue;
    piece->set_up = record;
    if (!chunk.shapes.empty() && chunk.shapes[i].kind != ScreenShape::Kind::triangle) piece->shape = chunk.shapes[i];
  }
}

void PrimitiveRecorder::binned(const Chunk& chunk) {
  for (int tile = 0; tile < chunk.tiles.tile_count(); ++tile)
    for (const std::uint16_t number : chunk.tiles.of_tile(tile)) {
      const ScreenTriangle& record = chunk.screen_triangles[number];
      if (record.primitive != life_.primitive) continue;
      if (PrimitivePiece* piece = piece_with({record.vertex[0], record.vertex[1], record.vertex[2]})) piece->tiles.push_back(tile);
    }
}

void PrimitiveRecorder::before(Stage, const Chunk&, const FragmentBlock& block, const Tile&) {
  live_before_ = std::popcount(block.live);
}

void PrimitiveRecorder::after(Stage stage, const Chunk& chunk, const FragmentBlock& block, const Tile& tile) {
  if (block.triangle->primitive != life_.primitive) return;
  if (stage == Stage::rasterization) {
    rasterized(block);
    return watch_.rasterized(chunk, block, tile);
  }
  watch_.after(stage, block, tile);
  const int died = live_before_ - std::popcount(block.live);
  if (stage == Stage::fragment_shading) life_.fates.discarded += died;
  if (stage == Stage::alpha_test) life_.fates.failed_alpha += died;
  if (stage == Stage::depth_test) life_.fates.failed_depth += died;
  life_.fates.reached -= died;
}

void PrimitiveRecorder::rasterized(const FragmentBlock& block) {
  const int fragments = std::popcount(block.live);
  life_.fates.covered += fragments;
  life_.fates.reached += fragments;
  const auto& v = block.triangle->vertex;
  if (PrimitivePiece* piece = piece_with({v[0], v[1], v[2]})) ++piece->blocks;
  for (int i = 0; i < kBlockPixels; ++i) {
    if ((block.live >> i & 1u) == 0) continue;
    const int x = block.left + block_x(i), y = block.top + block_y(i);
    PixelRect& all = life_.covered;
    all = all.empty() ? PixelRect{x, y, x + 1, y + 1}
                      : PixelRect{std::min(all.left, x), std::min(all.top, y), std::max(all.right, x + 1), std::max(all.bottom, y + 1)};
  }
}

}  // namespace tuberia
