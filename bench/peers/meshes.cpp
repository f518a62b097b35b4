#include "bench/peers/meshes.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <unordered_map>

namespace tuberia::bench {

namespace {

constexpr float kPi = 3.14159265f;
constexpr std::array<glm::vec2, 4> kQuadCorners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

// Scrambles all bits: neighbouring numbers give unrelated ones (two rounds of xorshift-multiply).
std::uint32_t scramble(std::uint32_t bits) {
  bits = (bits ^ (bits >> 16)) * 0x7feb352du;
  bits = (bits ^ (bits >> 15)) * 0x846ca68bu;
  return bits ^ (bits >> 16);
}

// In [0, 1), a multiple of 2^-24.
float scramble_to_unit(std::uint32_t bits) { return static_cast<float>(scramble(bits) >> 8) * 0x1p-24f; }

std::uint8_t low_byte(std::uint32_t bits) { return static_cast<std::uint8_t>(bits & 255u); }

std::uint32_t vertex_count(const WorkloadMesh& mesh) { return static_cast<std::uint32_t>(mesh.positions.size()); }

void add_vertex(WorkloadMesh& mesh, const glm::vec3& position, const glm::vec3& normal,
                const glm::vec2& texture_coordinate = glm::vec2(0), const Rgba8& colour = {255, 255, 255, 255}) {
  mesh.positions.push_back(position);
  mesh.normals.push_back(normal);
  mesh.texture_coordinates.push_back(texture_coordinate);
  mesh.colours.push_back(colour);
}

void add_quad_indices(WorkloadMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
}

// The quads of a grid whose vertex (i, j) is first + j * (columns + 1) + i, in bands of 32 columns:
// a vertex comes back within about 33 others, which suits every vertex cache.
void add_grid_indices(WorkloadMesh& mesh, std::uint32_t first, int columns, int rows) {
  constexpr int kBand = 32;
  const auto stride = static_cast<std::uint32_t>(columns + 1);
  for (int band = 0; band < columns; band += kBand)
    for (int j = 0; j < rows; ++j)
      for (int i = band; i < std::min(band + kBand, columns); ++i) {
        const std::uint32_t below = first + static_cast<std::uint32_t>(j) * stride + static_cast<std::uint32_t>(i);
        add_quad_indices(mesh, below, below + 1, below + stride + 1, below + stride);
      }
}

float layer_depth(int layer, int layers, LayerOrder order) {
  const float part = static_cast<float>(layer) / static_cast<float>(layers);
  return order == LayerOrder::back_to_front ? 0.9f - 1.8f * part : -0.9f + 1.8f * part;
}

// Every index uses texture 0.
WorkloadMesh with_one_texture(WorkloadMesh mesh) {
  mesh.second_texture_begins = mesh.indices.size();
  return mesh;
}

// Vertex normals weighted by the triangles' areas.
void compute_smooth_normals(WorkloadMesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
    const glm::vec3 twice_area =
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    for (const std::uint32_t corner : {a, b, c}) mesh.normals[corner] += twice_area;
  }
  for (glm::vec3& normal : mesh.normals)
    if (const float length = std::sqrt(glm::dot(normal, normal)); length > 0) normal /= length;
}

// White, untextured vertices and smooth normals for positions and indices that are there already.
void finish_model(WorkloadMesh& mesh) {
  mesh.texture_coordinates.assign(mesh.positions.size(), glm::vec2(0));
  mesh.colours.assign(mesh.positions.size(), Rgba8{255, 255, 255, 255});
  compute_smooth_normals(mesh);
}

}  // namespace

WorkloadMesh filling_quads(int layers, bool smooth, std::uint8_t alpha, LayerOrder order) {
  WorkloadMesh mesh;
  for (int layer = 0; layer < layers; ++layer) {
    const std::uint32_t first = vertex_count(mesh);
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      const std::uint32_t seed = 3u * (smooth ? first + corner : static_cast<std::uint32_t>(layer)) + 77u;
      add_vertex(mesh, glm::vec3(kQuadCorners[corner], layer_depth(layer, layers, order)), {0, 0, 1}, {0, 0},
                 {low_byte(scramble(seed)), low_byte(scramble(seed + 1)), low_byte(scramble(seed + 2)), alpha});
    }
    add_quad_indices(mesh, first, first + 1, first + 2, first + 3);
  }
  return with_one_texture(std::move(mesh));
}

WorkloadMesh leaning_planes(int layers, float aspect) {
  const float lean = 38.0f * kPi / 180.0f, half_height = std::tan(30.0f * kPi / 180.0f);
  constexpr float kOverscan = 1.0005f;  // no pixel at the rim may be missed
  WorkloadMesh mesh;
  for (int layer = 0; layer < layers; ++layer) {
    const auto number = static_cast<float>(layer);
    const float distance = 3.0f - 0.2f * number;
    const std::uint32_t first = vertex_count(mesh);
    for (const glm::vec2& corner : kQuadCorners) {
      // Where the line of sight through the corner meets cos(lean) y + sin(lean) (z + distance) = 0.
      const glm::vec3 sight(corner.x * half_height * aspect * kOverscan, corner.y * half_height * kOverscan, -1);
      const float reach =
          -std::sin(lean) * distance / (std::cos(lean) * sight.y + std::sin(lean) * sight.z);
      const glm::vec3 hit = sight * reach;
      const float along_slope = hit.y / std::sin(lean);
      add_vertex(mesh, hit, {0, 0, 1},
                 {hit.x / distance + 0.13f * number, along_slope / distance + 0.07f * number});
    }
    add_quad_indices(mesh, first, first + 1, first + 2, first + 3);
  }
  return with_one_texture(std::move(mesh));
}

WorkloadMesh jittered_grids(int columns, int rows, int layers, LayerOrder order) {
  constexpr float kJitter = 0.25f;
  WorkloadMesh mesh;
  for (int layer = 0; layer < layers; ++layer) {
    const std::uint32_t first = vertex_count(mesh);
    const float z = layer_depth(layer, layers, order);
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i) {
        const std::uint32_t vertex = vertex_count(mesh);
        float x = static_cast<float>(i), y = static_cast<float>(j);
        if (i > 0 && i < columns) x += kJitter * (2 * scramble_to_unit(2 * vertex) - 1);
        if (j > 0 && j < rows) y += kJitter * (2 * scramble_to_unit(2 * vertex + 1) - 1);
        const std::uint32_t bits = scramble(vertex + 9999u);
        add_vertex(mesh, {2 * x / static_cast<float>(columns) - 1, 2 * y / static_cast<float>(rows) - 1, z}, {0, 0, 1},
                   {0, 0}, {low_byte(bits), low_byte(bits >> 8), low_byte(bits >> 16), 255});
      }
    add_grid_indices(mesh, first, columns, rows);
  }
  return with_one_texture(std::move(mesh));
}

WorkloadMesh unit_sphere(int segments) {
  WorkloadMesh mesh;
  const auto count = static_cast<float>(segments);
  const auto code = [](float coordinate) { return static_cast<std::uint8_t>(127.5f + 127.0f * coordinate); };
  for (int j = 0; j <= segments; ++j)
    for (int i = 0; i <= segments; ++i) {
      const float across = static_cast<float>(i) / count, up = static_cast<float>(j) / count;
      const float longitude = 6.2831853f * static_cast<float>(i) / count, latitude = kPi * (up - 0.5f);
      const glm::vec3 point(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                            -std::cos(latitude) * std::sin(longitude));
      add_vertex(mesh, point, point, {across, up}, {code(point.x), code(point.y), code(point.z), 255});
    }
  add_grid_indices(mesh, 0, segments, segments);
  return with_one_texture(std::move(mesh));
}

Result<WorkloadMesh> model_of_height_2(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) return Error{"cannot open " + path.string()};
  WorkloadMesh mesh;
  glm::vec3 smallest(std::numeric_limits<float>::max()), largest(-smallest);
  for (std::string line; std::getline(file, line);) {
    glm::vec3 position;
    unsigned a = 0, b = 0, c = 0;
    if (std::sscanf(line.c_str(), "v %f %f %f", &position.x, &position.y, &position.z) == 3) {
      mesh.positions.push_back(position);
      smallest = glm::min(smallest, position);
      largest = glm::max(largest, position);
    } else if (std::sscanf(line.c_str(), "f %u %u %u", &a, &b, &c) == 3) {
      mesh.indices.insert(mesh.indices.end(), {a - 1, b - 1, c - 1});
    }
  }
  if (mesh.indices.empty()) return Error{path.string() + " has no triangles"};
  for (const std::uint32_t index : mesh.indices)
    if (index >= mesh.positions.size()) return Error{path.string() + " has a face without its vertex"};

  const float scale = 2.0f / (largest.y - smallest.y);
  for (glm::vec3& position : mesh.positions) position = (position - 0.5f * (smallest + largest)) * scale;
  finish_model(mesh);
  return with_one_texture(std::move(mesh));
}

WorkloadMesh subdivided(const WorkloadMesh& coarse) {
  WorkloadMesh mesh;
  mesh.positions = coarse.positions;
  std::unordered_map<std::uint64_t, std::uint32_t> midpoints;  // by the edge's two vertices
  midpoints.reserve(coarse.indices.size());
  const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t edge = static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
    const auto [entry, is_new] = midpoints.try_emplace(edge, vertex_count(mesh));
    if (is_new) {
      const glm::vec3 &from = coarse.positions[a], &to = coarse.positions[b];
      const glm::vec3 &normal_from = coarse.normals[a], &normal_to = coarse.normals[b];
      const glm::vec3 along = to - from;
      const glm::vec3 pull = glm::dot(along, normal_to) * normal_to - glm::dot(along, normal_from) * normal_from;
      mesh.positions.push_back(0.5f * (from + to) + 0.0625f * pull);
    }
    return entry->second;
  };
  for (std::size_t i = 0; i < coarse.indices.size(); i += 3) {
    const std::uint32_t a = coarse.indices[i], b = coarse.indices[i + 1], c = coarse.indices[i + 2];
    const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    mesh.indices.insert(mesh.indices.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
  }
  finish_model(mesh);
  return with_one_texture(std::move(mesh));
}

namespace {

// One box of the city: for each axis the two faces across it, their texture once over each face.
void add_box(WorkloadMesh& mesh, const glm::vec3& centre, const glm::vec3& half_size) {
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {1.0f, -1.0f}) {
      const std::uint32_t first = vertex_count(mesh);
      glm::vec3 normal(0);
      normal[axis] = side;
      for (const glm::vec2& corner : kQuadCorners) {
        // Going round the other way on the far side keeps both faces counter-clockwise.
        glm::vec3 outward(0);
        outward[axis] = side;
        outward[(axis + 1) % 3] = side * corner.x;
        outward[(axis + 2) % 3] = corner.y;
        add_vertex(mesh, centre + outward * half_size, normal, corner * 0.5f + 0.5f);
      }
      add_quad_indices(mesh, first, first + 1, first + 2, first + 3);
    }
}

}  // namespace

WorkloadMesh city(int blocks) {
  constexpr int kFloorCells = 20;
  constexpr float kBlock = 3.0f;
  const float half = static_cast<float>(blocks) * (0.5f * kBlock);
  WorkloadMesh mesh;
  for (int j = 0; j <= kFloorCells; ++j)
    for (int i = 0; i <= kFloorCells; ++i) {
      const float x = -half + 2 * half * static_cast<float>(i) / kFloorCells;
      const float z = half - 2 * half * static_cast<float>(j) / kFloorCells;
      add_vertex(mesh, {x, 0, z}, {0, 1, 0}, {0.5f * x, 0.5f * z});
    }
  add_grid_indices(mesh, 0, kFloorCells, kFloorCells);
  mesh.second_texture_begins = mesh.indices.size();

  for (int row = 0; row < blocks; ++row)
    for (int column = 0; column < blocks; ++column) {
      const float height = 0.4f + 2.2f * scramble_to_unit(static_cast<std::uint32_t>(row * blocks + column) + 5u);
      add_box(mesh,
              {(static_cast<float>(column) + 0.5f) * kBlock - half, 0.5f * height,
               (static_cast<float>(row) + 0.5f) * kBlock - half},
              {0.8f, 0.5f * height, 0.8f});
    }
  return mesh;
}

Image<Rgba8> noisy_checkerboard(int size, std::uint32_t variant) {
  Image<Rgba8> texture(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const std::uint32_t noise = scramble(static_cast<std::uint32_t>(y * size + x) ^ variant);
      const std::uint32_t field = (((x >> 5) ^ (y >> 5)) & 1) != 0 ? 150u : 40u;
      texture.at(x, y) = {low_byte(field + (noise & 63)), low_byte(field + (noise >> 8 & 63)),
                          low_byte(90 + (noise >> 16 & 63)), 255};
    }
  return texture;
}

}  // namespace tuberia::bench
