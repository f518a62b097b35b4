#include "pipeline/primitive_recorder.hpp"

#include <algorithm>
#include <bit>

#include "math/edge_function.hpp"
#include "pipeline/clipping.hpp"

namespace tuberia {
namespace {

/// A triangle, line or point of a batch.
struct Slots {
  std::array<std::uint32_t, 3> slot{};
  int count = 3;
  bool is_back = false;
};

/// What there is of a primitive at the moment, in order.
std::vector<Slots> slots_of(const Chunk& chunk, std::uint32_t primitive) {
  std::vector<Slots> all;
  const TriangleBatch& triangles = chunk.triangles;
  for (std::size_t i = 0; i < static_cast<std::size_t>(triangles.count); ++i)
    if (triangles.primitive[i] == primitive)
      all.push_back({{triangles.v0[i], triangles.v1[i], triangles.v2[i]}, 3, triangles.is_back[i] != 0});
  for (const AssembledLine& line : chunk.lines)
    if (line.primitive == primitive) all.push_back({{line.v0, line.v1, 0}, 2, line.is_back});
  for (const AssembledPoint& point : chunk.points)
    if (point.primitive == primitive) all.push_back({{point.vertex, 0, 0}, 1, point.is_back});
  return all;
}

/// All 0 for vertices that come from the screen.
ClipPosition clip_position(const VertexBatch& vertices, std::uint32_t slot) {
  if (slot >= vertices.clip_x.size()) return {0, 0, 0, 0};
  return {vertices.clip_x[slot], vertices.clip_y[slot], vertices.clip_z[slot], vertices.clip_w[slot]};
}

}  // namespace

void PrimitiveRecorder::begin(const DrawCall& draw, const AcceptedDraw& accepted) {
  draw_ = &draw;
  life_.draw = {std::string(draw.program.interface().name), accepted.output, draw.state.rasterization.flat_shading};
  life_.topology = draw.state.assembly.topology;
  life_.attributes = accepted.attributes;
  life_.viewport = accepted.viewport;
  life_.clip_rect = accepted.clip;
  life_.limits = clip_limits(accepted.viewport, draw.state.clipping);
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
  for (const Slots& assembled : slots_of(chunk, life_.primitive)) {
    life_.found = true;
    vertex_slot_.assign(assembled.slot.begin(), assembled.slot.begin() + assembled.count);
    for (const std::uint32_t slot : vertex_slot_) {
      PrimitiveVertex vertex{.number = chunk.vertices.source[slot], .object = {}, .clip = clip_position(chunk.vertices, slot),
                             .outcode = slot < chunk.vertices.outcode.size() ? chunk.vertices.outcode[slot] : 0};
      if (!draw_->mesh.positions.empty()) vertex.object = ObjectPosition{draw_->mesh.positions[vertex.number]};
      life_.vertices.push_back(vertex);
    }
  }
}

void PrimitiveRecorder::clipped(const Chunk& chunk) {
  std::uint32_t any = 0;
  for (const PrimitiveVertex& vertex : life_.vertices) any |= vertex.outcode;
  for (const Slots& left : slots_of(chunk, life_.primitive)) add_piece(chunk, left.slot, left.count);
  if (any == 0) life_.clip = PrimitiveLife::Clip::untouched;
  else if ((any & outcode::invalid) != 0) life_.clip = PrimitiveLife::Clip::not_finite;
  else life_.clip = life_.pieces.empty() ? PrimitiveLife::Clip::outside : PrimitiveLife::Clip::cut;
}

PrimitivePiece& PrimitiveRecorder::add_piece(const Chunk& chunk, const std::array<std::uint32_t, 3>& slots, int corner_count) {
  PrimitivePiece piece{.corner_count = corner_count};
  for (std::size_t k = 0; k < static_cast<std::size_t>(corner_count); ++k) piece.corner[k] = corner_of(chunk, slots[k]);
  life_.pieces.push_back(std::move(piece));
  return life_.pieces.back();
}

std::size_t PrimitiveRecorder::corner_of(const Chunk& chunk, std::uint32_t slot) {
  const auto known = std::find_if(life_.corners.begin(), life_.corners.end(), [&](const PrimitiveCorner& c) { return c.slot == slot; });
  if (known != life_.corners.end()) return static_cast<std::size_t>(known - life_.corners.begin());
  PrimitiveCorner corner{.slot = slot, .clip = clip_position(chunk.vertices, slot)};
  const std::size_t originals = chunk.vertices.source.size();
  corner.is_new = slot >= originals;
  if (corner.is_new) {
    const ClippedVertex& made = chunk.vertices.clipped[slot - originals];
    std::copy(made.weight, made.weight + made.count, corner.weight.begin());
  } else {
    for (std::size_t k = 0; k < vertex_slot_.size(); ++k) corner.weight[k] = slot == vertex_slot_[k] ? 1 : 0;
  }
  life_.corners.push_back(std::move(corner));
  return life_.corners.size() - 1;
}

void PrimitiveRecorder::projected(const Chunk& chunk) {
  for (PrimitiveCorner& corner : life_.corners) {
    const auto w = static_cast<double>(corner.clip.w);
    corner.ndc = {static_cast<double>(corner.clip.x) / w, static_cast<double>(corner.clip.y) / w, static_cast<double>(corner.clip.z) / w};
    const ScreenVertex& screen = chunk.vertices.screen[corner.slot];
    corner.x_units = screen.x;
    corner.y_units = screen.y;
    corner.depth = screen.depth;
  }
  const auto place = [&](std::size_t corner) { return SnappedPoint{life_.corners[corner].x_units, life_.corners[corner].y_units}; };
  for (PrimitivePiece& piece : life_.pieces) {
    if (piece.corner_count < 3) continue;  // points and lines count as front
    piece.twice_area = twice_area(place(piece.corner[0]), place(piece.corner[1]), place(piece.corner[2]));
    piece.is_front = (piece.twice_area > 0) == (life_.culling.front_face == Winding::clockwise);
  }
}

PrimitivePiece* PrimitiveRecorder::piece_with(const std::array<std::uint32_t, 3>& slots, int corner_count) {
  for (PrimitivePiece& piece : life_.pieces) {
    if (piece.corner_count != corner_count) continue;
    const auto slot = [&](std::size_t k) { return life_.corners[piece.corner[k]].slot; };
    if (slot(0) != slots[0]) continue;
    if (corner_count == 1 || (corner_count == 2 && slot(1) == slots[1])) return &piece;
    // Culling may have exchanged the last two.
    if (corner_count == 3 && std::minmax({slot(1), slot(2)}) == std::minmax({slots[1], slots[2]})) return &piece;
  }
  return nullptr;
}

void PrimitiveRecorder::culled(const Chunk& chunk) {
  const CullFace cull = life_.culling.cull;
  for (PrimitivePiece& piece : life_.pieces) {
    const bool unwanted = (cull == CullFace::front && piece.is_front) || (cull == CullFace::back && !piece.is_front);
    const bool is_flat = piece.corner_count == 3 && piece.twice_area == 0;
    piece.verdict = is_flat                                ? PrimitivePiece::Verdict::no_area
                    : piece.corner_count == 3 && unwanted ? PrimitivePiece::Verdict::turned_away
                                                          : PrimitivePiece::Verdict::no_pixel_centre;
  }
  const std::size_t before = life_.pieces.size();
  for (const Slots& left : slots_of(chunk, life_.primitive)) {
    PrimitivePiece* known = piece_with(left.slot, left.count);
    // Polygon modes make lines and points of triangles.
    PrimitivePiece& piece = known != nullptr ? *known : add_piece(chunk, left.slot, left.count);
    piece.verdict = PrimitivePiece::Verdict::drawn;
    if (left.count < 3) piece.is_front = !left.is_back;
    for (std::size_t k = 0; k < static_cast<std::size_t>(left.count); ++k) piece.clockwise[k] = corner_of(chunk, left.slot[k]);
  }
  for (std::size_t i = 0; i < before && before < life_.pieces.size(); ++i) life_.pieces[i].verdict = PrimitivePiece::Verdict::drawn_as_others;
}

void PrimitiveRecorder::attributes(const Chunk& chunk) {
  const auto stride = static_cast<std::size_t>(chunk.vertices.stride);
  const auto scalars = static_cast<std::size_t>(scalar_count(life_.attributes));
  for (const PrimitivePiece& piece : life_.pieces) {
    if (piece.verdict != PrimitivePiece::Verdict::drawn || scalars == 0) continue;
    const auto back = static_cast<std::size_t>(piece.is_front ? 0 : chunk.vertices.back_slots);
    for (std::size_t k = 0; k < static_cast<std::size_t>(piece.corner_count); ++k) {
      PrimitiveCorner& corner = life_.corners[piece.corner[k]];
      const float* record = chunk.vertices.attributes.data() + (corner.slot + back) * stride;
      corner.attributes.assign(record, record + scalars);
    }
  }
}

PrimitivePiece* PrimitiveRecorder::piece_of(const Chunk& chunk, std::size_t record) {
  const auto kind = chunk.shapes.empty() ? ScreenShape::Kind::triangle : chunk.shapes[record].kind;
  std::array<std::uint32_t, 3> slots;
  for (std::size_t k = 0; k < 3; ++k) slots[k] = own_slot(chunk.vertices, chunk.screen_triangles[record].vertex[k]);
  return piece_with(slots, kind == ScreenShape::Kind::triangle ? 3 : kind == ScreenShape::Kind::line ? 2 : 1);
}

void PrimitiveRecorder::set_up(const Chunk& chunk) {
  for (std::size_t i = 0; i < chunk.screen_triangles.size(); ++i) {
    if (chunk.screen_triangles[i].primitive != life_.primitive) continue;
    PrimitivePiece* piece = piece_of(chunk, i);
    if (piece == nullptr) continue;
    piece->set_up = chunk.screen_triangles[i];
    if (piece->corner_count < 3) piece->shape = chunk.shapes[i];
  }
}

void PrimitiveRecorder::binned(const Chunk& chunk) {
  for (int tile = 0; tile < chunk.tiles.tile_count(); ++tile)
    for (const std::uint16_t number : chunk.tiles.of_tile(tile)) {
      if (chunk.screen_triangles[number].primitive != life_.primitive) continue;
      if (PrimitivePiece* piece = piece_of(chunk, number)) piece->tiles.push_back(tile);
    }
}

void PrimitiveRecorder::before(Stage, const Chunk&, const FragmentBlock& block, const Tile&) {
  live_before_ = std::popcount(block.live);
}

void PrimitiveRecorder::after(Stage stage, const Chunk& chunk, const FragmentBlock& block, const Tile& tile) {
  if (block.triangle->primitive != life_.primitive) return;
  if (stage == Stage::rasterization) {
    rasterized(chunk, block);
    return watch_.rasterized(chunk, block, tile);
  }
  watch_.after(stage, block, tile);
  const int died = live_before_ - std::popcount(block.live);
  if (stage == Stage::fragment_shading) life_.fates.discarded += died;
  if (stage == Stage::alpha_test) life_.fates.failed_alpha += died;
  if (stage == Stage::depth_test) life_.fates.failed_depth += died;
  life_.fates.reached -= died;
}

void PrimitiveRecorder::rasterized(const Chunk& chunk, const FragmentBlock& block) {
  const int fragments = std::popcount(block.live);
  life_.fates.covered += fragments;
  life_.fates.reached += fragments;
  if (PrimitivePiece* piece = piece_of(chunk, static_cast<std::size_t>(block.triangle - chunk.screen_triangles.data()))) ++piece->blocks;
  for (int i = 0; i < kBlockPixels; ++i) {
    if ((block.live >> i & 1u) == 0) continue;
    const int x = block.left + block_x(i), y = block.top + block_y(i);
    PixelRect& all = life_.covered;
    all = all.empty() ? PixelRect{x, y, x + 1, y + 1}
                      : PixelRect{std::min(all.left, x), std::min(all.top, y), std::max(all.right, x + 1), std::max(all.bottom, y + 1)};
  }
}

}  // namespace tuberia
