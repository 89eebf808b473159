#include "picture/renderer.h"

#include <algorithm>
#include <utility>

#include "picture/blur.h"
#include "picture/camera.h"
#include "picture/cloth_corners.h"
#include "picture/gl_api.h"
#include "picture/gl_context.h"
#include "picture/gl_objects.h"
#include "picture/reduce.h"
#include "picture/renderer_checks.h"
#include "picture/shaders.h"
#include "picture/viridis.h"

namespace {

// Lengths in units of the scene's size.
constexpr double shadow_reach = 2.0;  // of the cloth's shadow on itself
constexpr double mask_reach = 3.2;    // of its shadow on the floor
constexpr double floor_half_side = 14;
constexpr double pin_radius = 0.021;

constexpr int shadow_side = 1024, mask_side = 512, mask_blur = 5;  // pixels

// Towards the main light: from the left, above, in front.
Vec3 key_direction() {
  return Vec3(-0.56, 0.74, 0.37).normalized();
}

GlProgram program(const char* vertex_source, const char* fragment_source) {
  const std::string studio = studio_source;
  return GlProgram(studio + vertex_source, studio + fragment_source);
}

std::vector<std::array<Vec2, 3>> in_squares(const Surface& surface) {
  std::vector<std::array<Vec2, 3>> squares = surface.texture;
  for (std::array<Vec2, 3>& face : squares)
    for (Vec2& corner : face) corner /= surface.checker;
  return squares;
}

// OpenGL's rows begin at the bottom.
Image upside_down(const Image& image) {
  Image result = image;
  const std::ptrdiff_t row = 3 * image.width;
  for (int y = 0; y < image.height; ++y)
    std::copy_n(image.rgb.begin() + y * row, row,
                result.rgb.begin() + (image.height - 1 - y) * row);
  return result;
}

// Where things are, in the picture's own units: origin on the floor below the target, lengths
// divided by the scene's size. So the same shaders serve a handkerchief and a sail.
struct Scene {
  Vec3 origin, eye, target, shadow_centre;
  Eigen::Matrix4f view_projection, shadow_matrix, ground_matrix;

  Scene(const Stage& stage, const Style& style)
      : origin(stage.target.x(), stage.ground, stage.target.z()),
        eye((stage.eye - origin) / stage.size), target((stage.target - origin) / stage.size),
        shadow_centre(target - key_direction() * target.y() / key_direction().y()) {
    const double aspect = static_cast<double>(style.width) / style.height;
    const double distance = (eye - target).norm();
    view_projection =
        (perspective(aspect, 0.02 * distance, distance + 60) * look_at(eye, target)).cast<float>();
    shadow_matrix = from_light(key_direction(), target, shadow_reach).cast<float>();
    ground_matrix = onto_ground(key_direction(), shadow_centre, mask_reach).cast<float>();
  }
};

}  // namespace

struct Renderer::Parts {
  const Surface surface;
  const std::vector<std::array<Vec2, 3>> squares;
  GlContext context;  // before everything that lives in it
  const GlProgram backdrop = program(backdrop_vertex_source, backdrop_fragment_source);
  const GlProgram shadow = program(shadow_vertex_source, shadow_fragment_source);
  const GlProgram floor = program(floor_vertex_source, floor_fragment_source);
  const GlProgram cloth = program(cloth_vertex_source, cloth_fragment_source);
  const GlProgram pin = program(pin_vertex_source, pin_fragment_source);
  GlVertices corners{{3, 3, 2, 1}};
  GlVertices pins{{3}, true};
  const GlVertices none{{}};  // for shaders that compute their own vertices
  const GlFramebuffer shadow_map{GlFramebuffer::Kind::SHADOW, shadow_side, shadow_side};
  const GlFramebuffer mask{GlFramebuffer::Kind::MASK, mask_side, mask_side};

  explicit Parts(Surface s) : surface(std::move(s)), squares(in_squares(surface)) {}
  ~Parts() { context.make_current(); }

  int corner_count() const { return static_cast<int>(3 * surface.faces.size()); }

  void upload(const Scene& scene, const Stage& stage, const VecX& x, const VecX& strain) {
    const VecX staged_x = staged(x, scene.origin, stage.size);
    corners.upload(corner_floats(surface.faces, squares, staged_x, strain));
    std::vector<float> centres;
    for (const int i : surface.pins)
      for (int d = 0; d < 3; ++d) centres.push_back(static_cast<float>(staged_x[3 * i + d]));
    pins.upload(centres);
  }

  void draw_shadow(const Eigen::Matrix4f& matrix) const {
    shadow.use();
    shadow.set("light_matrix", matrix);
    corners.bind();
    glDrawArrays(GL_TRIANGLES, 0, corner_count());
  }

  void draw_shadow_map(const Scene& scene) const {
    shadow_map.bind();
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);  // away from the light, or the cloth would shadow itself
    glPolygonOffset(2, 4);
    draw_shadow(scene.shadow_matrix);
    glDisable(GL_POLYGON_OFFSET_FILL);
  }

  void draw_floor_shadow(const Scene& scene) const {
    mask.bind();
    glDisable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT);
    draw_shadow(scene.ground_matrix);
    std::vector<unsigned char> bytes = mask.bytes();
    blur(bytes, mask_side, mask_blur);
    mask.upload(bytes);
  }

  void use(const GlProgram& p, const Scene& scene, const Style& style) const {
    p.use();
    p.set("view_projection", scene.view_projection);
    p.set("eye", Eigen::Vector3f(scene.eye.cast<float>()));
    p.set("key", Eigen::Vector3f(key_direction().cast<float>()));
    p.set("viewport", Eigen::Vector2f(Eigen::Vector2i(style.width, style.height).cast<float>() *
                                      style.supersampling));
  }

  void draw_backdrop(const Scene& scene, const Style& style) const {
    use(backdrop, scene, style);
    none.bind();
    glDisable(GL_DEPTH_TEST);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
  }

  void draw_cloth(const Scene& scene, const Style& style) const {
    use(cloth, scene, style);
    shadow_map.bind_texture(0);
    cloth.set("shadow_map", 0);
    cloth.set("shadow_matrix", scene.shadow_matrix);
    cloth.set("shadow_texel", 1.0f / shadow_side);
    cloth.set("show_strain", style.strain_scale ? 1 : 0);
    cloth.set("show_wires", style.wireframe ? 1 : 0);
    cloth.set("pixel_side", static_cast<float>(style.supersampling));
    cloth.set("scale_colours", viridis_table);
    corners.bind();
    glDrawArrays(GL_TRIANGLES, 0, corner_count());
  }

  void draw_pins(const Scene& scene, const Style& style) const {
    use(pin, scene, style);
    pin.set("radius", static_cast<float>(pin_radius));
    pins.bind();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<int>(surface.pins.size()));
  }

  void draw_floor(const Scene& scene, const Style& style) const {
    if (scene.eye.y() <= 0) return;  // from below, the floor is transparent
    use(floor, scene, style);
    mask.bind_texture(0);
    floor.set("shadow_mask", 0);
    floor.set("mask_centre", Eigen::Vector2f(static_cast<float>(scene.shadow_centre.x()),
                                             static_cast<float>(scene.shadow_centre.z())));
    floor.set("mask_reach", static_cast<float>(mask_reach));
    floor.set("half_side", static_cast<float>(floor_half_side));
    none.bind();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
};

Renderer::Renderer(Surface surface) {
  check_surface(surface);
  parts = std::make_unique<Parts>(std::move(surface));
}

Renderer::~Renderer() = default;

std::string Renderer::description() const {
  parts->context.make_current();
  return parts->context.description();
}

Image Renderer::draw(const Stage& stage, const VecX& x, const Style& style, const VecX& strain) {
  parts->context.make_current();
  check_stage(stage);
  check_style(style, largest_framebuffer_side());
  check_vertices(parts->surface, x);
  if (style.strain_scale) check_strain(strain, x);

  const Scene scene(stage, style);
  parts->upload(scene, stage, x, style.strain_scale ? VecX(strain / *style.strain_scale) : VecX());
  parts->draw_shadow_map(scene);
  parts->draw_floor_shadow(scene);

  Image large{style.width * style.supersampling, style.height * style.supersampling, {}};
  const GlFramebuffer picture(GlFramebuffer::Kind::COLOUR_AND_DEPTH, large.width, large.height);
  picture.bind();
  parts->draw_backdrop(scene, style);
  parts->draw_cloth(scene, style);
  parts->draw_pins(scene, style);
  parts->draw_floor(scene, style);
  large.rgb = picture.bytes();
  return upside_down(box_reduce(large, style.width, style.height));
}
