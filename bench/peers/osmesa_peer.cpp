#define GL_GLEXT_PROTOTYPES
#include "bench/peers/peer.hpp"

#include <GL/osmesa.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace tuberia::bench {

namespace {

constexpr int kWidth = 1920, kHeight = 1080, kDepthOnlySize = 2048;

struct ContextDeleter {
  void operator()(osmesa_context* context) const { OSMesaDestroyContext(context); }
};

std::string text(const GLubyte* characters) {
  return characters ? reinterpret_cast<const char*>(characters) : "unknown";
}

// A framebuffer of renderbuffers: OSMesa's own would be copied back to memory at every glFinish.
GLuint make_framebuffer(int width, int height, bool with_colour) {
  GLuint framebuffer = 0, colour = 0, depth = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  if (with_colour) {
    glGenRenderbuffers(1, &colour);
    glBindRenderbuffer(GL_RENDERBUFFER, colour);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour);
  } else {
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  }
  glGenRenderbuffers(1, &depth);
  glBindRenderbuffer(GL_RENDERBUFFER, depth);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE ? framebuffer : 0;
}

template <class Element>
void upload(GLenum target, GLuint buffer, const std::vector<Element>& elements) {
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(), GL_STATIC_DRAW);
}

void set_enabled(GLenum capability, bool enabled) { enabled ? glEnable(capability) : glDisable(capability); }

GLint minification(Filter filter) {
  switch (filter) {
    case Filter::none:
    case Filter::nearest: return GL_NEAREST;
    case Filter::linear: return GL_LINEAR;
    case Filter::nearest_mipmap_nearest: return GL_NEAREST_MIPMAP_NEAREST;
    case Filter::linear_mipmap_nearest: return GL_LINEAR_MIPMAP_NEAREST;
    case Filter::linear_mipmap_linear: return GL_LINEAR_MIPMAP_LINEAR;
  }
  return GL_NEAREST;
}

GLint magnification(Filter filter) {
  return filter == Filter::nearest || filter == Filter::nearest_mipmap_nearest ? GL_NEAREST : GL_LINEAR;
}

// The light of the lit workloads. Its ambient part is set so that OpenGL, adding the scene's
// ambient 0.2 to the light's 1, arrives at kLighting.ambient.
void set_lighting(const Workload& workload) {
  const GLfloat one[] = {1, 1, 1, 1}, black[] = {0, 0, 0, 1}, scene_ambient[] = {0.2f, 0.2f, 0.2f, 1};
  const glm::vec4 to_light(kLighting.to_light, 0), ambient(kLighting.ambient / 1.2f, 1), diffuse(kLighting.diffuse, 1);
  const glm::vec4 specular(glm::vec3(kLighting.specular), 1);
  // A position is taken as seen through the current matrix; ours is in view space already.
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, scene_ambient);
  glLightfv(GL_LIGHT0, GL_POSITION, glm::value_ptr(to_light));
  for (const GLenum part : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) glLightfv(GL_LIGHT0, part, one);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, glm::value_ptr(ambient));
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, glm::value_ptr(diffuse));
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, workload.specular ? glm::value_ptr(specular) : black);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, workload.specular ? kLighting.shininess : 0.0f);
  glEnable(GL_LIGHT0);
}

class OsmesaPeer final : public Peer {
 public:
  Result<Nothing> start();

  std::string name() const override { return "llvmpipe"; }
  Result<Nothing> prepare(const Workload& workload) override;
  void frame() override;
  Image<Rgba8> picture() override;

 private:
  enum Buffer { kPositions, kNormals, kTextureCoordinates, kColours, kIndices, kBufferCount };

  void upload_mesh(const WorkloadMesh& mesh);
  void point_to_vertices();
  void set_state();
  void draw_indices(std::size_t first, std::size_t end, GLuint texture);

  std::unique_ptr<osmesa_context, ContextDeleter> context_;
  std::vector<Rgba8> own_framebuffer_;  // OSMesa insists on one
  GLuint colour_framebuffer_ = 0, depth_framebuffer_ = 0;
  std::array<GLuint, 2> textures_{};
  std::array<GLuint, kBufferCount> buffers_{};
  const Workload* workload_ = nullptr;
};

Result<Nothing> OsmesaPeer::start() {
  context_.reset(OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr));
  own_framebuffer_.resize(static_cast<std::size_t>(kWidth) * kHeight);
  if (!context_ || !OSMesaMakeCurrent(context_.get(), own_framebuffer_.data(), GL_UNSIGNED_BYTE, kWidth, kHeight))
    return Error{"OSMesa gives no context"};
  const std::string renderer = text(glGetString(GL_RENDERER));
  if (renderer.find("llvmpipe") == std::string::npos) return Error{"OSMesa draws with " + renderer + ", not llvmpipe"};

  colour_framebuffer_ = make_framebuffer(kWidth, kHeight, true);
  depth_framebuffer_ = make_framebuffer(kDepthOnlySize, kDepthOnlySize, false);
  if (colour_framebuffer_ == 0 || depth_framebuffer_ == 0) return Error{"OSMesa refuses a framebuffer"};

  glGenTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
  const auto images = workload_textures();
  for (std::size_t i = 0; i < textures_.size(); ++i) {
    glBindTexture(GL_TEXTURE_2D, textures_[i]);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, images[i].width(), images[i].height(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 images[i].pixels().data());
  }
  return Nothing{};
}

Result<Nothing> OsmesaPeer::prepare(const Workload& workload) {
  workload_ = &workload;
  const int width = workload.depth_only ? kDepthOnlySize : kWidth;
  const int height = workload.depth_only ? kDepthOnlySize : kHeight;
  if (workload.width_pixels != width || workload.height_pixels != height)
    return Error{workload.name + " has a size that was not prepared for"};
  if (workload.texture_size_texels != kTextureSizeTexels) return Error{workload.name + " has textures that were not prepared"};
  glBindFramebuffer(GL_FRAMEBUFFER, workload.depth_only ? depth_framebuffer_ : colour_framebuffer_);
  glViewport(0, 0, width, height);

  glDeleteBuffers(kBufferCount, buffers_.data());
  upload_mesh(workload.mesh);
  set_state();
  point_to_vertices();
  glFinish();
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
    return Error{workload.name + ": OpenGL error " + std::to_string(error)};
  return Nothing{};
}

void OsmesaPeer::upload_mesh(const WorkloadMesh& mesh) {
  glGenBuffers(kBufferCount, buffers_.data());
  upload(GL_ARRAY_BUFFER, buffers_[kPositions], mesh.positions);
  upload(GL_ARRAY_BUFFER, buffers_[kNormals], mesh.normals);
  upload(GL_ARRAY_BUFFER, buffers_[kTextureCoordinates], mesh.texture_coordinates);
  upload(GL_ARRAY_BUFFER, buffers_[kColours], mesh.colours);
  upload(GL_ELEMENT_ARRAY_BUFFER, buffers_[kIndices], mesh.indices);
}

// Only the attributes that this workload reads.
void OsmesaPeer::point_to_vertices() {
  const bool textured = workload_->filter != Filter::none;
  const bool coloured = !workload_->lit && !textured && !workload_->depth_only;
  const auto point = [this](GLenum array, Buffer buffer, bool used, auto set_pointer) {
    if (!used) return glDisableClientState(array);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[buffer]);
    set_pointer();
    glEnableClientState(array);
  };
  point(GL_VERTEX_ARRAY, kPositions, true, [] { glVertexPointer(3, GL_FLOAT, 0, nullptr); });
  point(GL_NORMAL_ARRAY, kNormals, workload_->lit, [] { glNormalPointer(GL_FLOAT, 0, nullptr); });
  point(GL_TEXTURE_COORD_ARRAY, kTextureCoordinates, textured, [] { glTexCoordPointer(2, GL_FLOAT, 0, nullptr); });
  point(GL_COLOR_ARRAY, kColours, coloured, [] { glColorPointer(4, GL_UNSIGNED_BYTE, 0, nullptr); });
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[kIndices]);
}

void OsmesaPeer::set_state() {
  const Workload& workload = *workload_;
  set_enabled(GL_LIGHTING, workload.lit);
  if (workload.lit) set_lighting(workload);
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(glm::value_ptr(workload.clip_from_view));
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(glm::value_ptr(workload.view_from_object));

  glShadeModel(workload.flat ? GL_FLAT : GL_SMOOTH);
  set_enabled(GL_DEPTH_TEST, workload.depth_test);
  glDepthFunc(GL_LESS);
  set_enabled(GL_BLEND, workload.blend);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  set_enabled(GL_CULL_FACE, workload.cull_back);
  glCullFace(GL_BACK);
  const GLboolean colour = workload.depth_only ? GL_FALSE : GL_TRUE;
  glColorMask(colour, colour, colour, colour);
  glColor4f(1, 1, 1, 1);

  set_enabled(GL_TEXTURE_2D, workload.filter != Filter::none);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  for (const GLuint texture : textures_) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minification(workload.filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnification(workload.filter));
  }
}

void OsmesaPeer::draw_indices(std::size_t first, std::size_t end, GLuint texture) {
  if (first == end) return;
  if (workload_->filter != Filter::none) glBindTexture(GL_TEXTURE_2D, texture);
  // With an index buffer bound, the "pointer" is a byte offset into it.
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(end - first), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

void OsmesaPeer::frame() {
  glDepthMask(GL_TRUE);
  const GLbitfield colour = workload_->depth_only ? 0u : GL_COLOR_BUFFER_BIT;
  glClear(colour | GL_DEPTH_BUFFER_BIT);
  glDepthMask(workload_->blend ? GL_FALSE : GL_TRUE);
  const WorkloadMesh& mesh = workload_->mesh;
  draw_indices(0, mesh.second_texture_begins, textures_[0]);
  draw_indices(mesh.second_texture_begins, mesh.indices.size(), textures_[1]);
  glFinish();
}

Image<Rgba8> OsmesaPeer::picture() {
  const int width = workload_->width_pixels, height = workload_->height_pixels;
  Image<Rgba8> below_first(width, height), picture(width, height);
  if (workload_->depth_only) {
    std::vector<float> depth(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
    for (std::size_t i = 0; i < depth.size(); ++i) {
      const auto grey = static_cast<std::uint8_t>(std::lround(255.0f * depth[i]));
      below_first.pixels()[i] = {grey, grey, grey, 255};
    }
  } else {
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, below_first.pixels().data());
  }
  // OpenGL's first row is the lowest.
  for (int y = 0; y < height; ++y) {
    const auto from = below_first.row(height - 1 - y);
    std::copy(from.begin(), from.end(), picture.row(y).begin());
  }
  return picture;
}

}  // namespace

Result<std::unique_ptr<Peer>> make_osmesa_peer(int threads) {
  if (threads < 1 || threads > 16) return Error{"llvmpipe takes 1 to 16 threads, not " + std::to_string(threads)};
  // Mesa reads these once, when its screen is made.
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  auto peer = std::make_unique<OsmesaPeer>();
  if (const auto started = peer->start(); !started) return started.error();
  return Result<std::unique_ptr<Peer>>(std::move(peer));
}

}  // namespace tuberia::bench
