#include "playhouse/render/renderer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <optional>

#include "playhouse/base/log.h"
#include "playhouse/render/gl_context.h"
#include "playhouse/render/instance_list.h"
#include "playhouse/render/mirrors.h"
#include "playhouse/render/pages.h"
#include "playhouse/render/shaders.h"
#include "playhouse/render/shape_store.h"

namespace playhouse::render {
namespace {

using geom::Vec3;

constexpr PictureSize kPage{4096, 4096};  // px; larger pictures have pages of their own
constexpr std::array<GLsizei, 3> kShadowTexels{512, 1024, 2048};  // of a side of a shadow map
constexpr GLsizei kTexelsOfPixels = 2;  // of its side for each row of a picture, where that many can be
constexpr double kShadowReach = 12;     // m along the way a view looks, up to which things throw shadows
constexpr float kOpaque = 0.999f;       // of a tint
constexpr double kFigureRadius = 0.62;  // bounding sphere about its middle, in heights
// Height of figures for the first and the last level of detail.  [px]
constexpr double kFinePixels = 260, kCoarsePixels = 90;
constexpr std::size_t kPaints = 3;
constexpr std::uint32_t kMirrorTexels = 1 << 23;  // of a mirror at most; larger pictures have coarser ones
constexpr double kBeyond = 5e-4;                  // m, from the plane of a mirror on: itself is not before it

/// Layout as in shaders.cc.
struct ViewBlock {
  Matrix clip{}, sun_clip{};
  std::array<float, 4> ahead{}, left{}, up{}, viewport{}, to_sun{}, sky{}, fog{}, floor{}, eye{};
};
static_assert(sizeof(ViewBlock) == 2 * 64 + 9 * 16);

/// Layout as in shaders.cc.
struct LampBlock {
  std::array<float, 4> count{};
  std::array<std::array<float, 4>, kMostLamps> at{}, way{}, light{};
};
static_assert(sizeof(LampBlock) == 16 * (1 + 3 * 16));

std::array<float, 4> four(const Vec3& v, double w) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}
std::array<float, 4> four(const Rgb& rgb, double w) {
  return {rgb[0], rgb[1], rgb[2], static_cast<float>(w)};
}

/// A clip line across a picture: slope times the slope of a ray, plus offset.
struct Line {
  double slope = 0, offset = 1;
};

struct ShadowMap {
  Texture depth;
  Framebuffer target;
  GLsizei texels = 0;  // per side
};

ShadowMap make_shadow_map(GLsizei texels) {
  ShadowMap map{make_texture(GL_DEPTH_COMPONENT32F, texels, texels), {}, texels};
  glTextureParameteri(map.depth, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(map.depth, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(map.depth, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(map.depth, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  map.target = Framebuffer(name);
  glNamedFramebufferTexture(map.target, GL_DEPTH_ATTACHMENT, map.depth, 0);
  glNamedFramebufferDrawBuffer(map.target, GL_NONE);
  glNamedFramebufferReadBuffer(map.target, GL_NONE);
  return map;
}

Paints paints_of(Shows shows) {
  return shows == Shows::kColor   ? Paints::kColor
         : shows == Shows::kDepth ? Paints::kDepth
                                  : Paints::kSegments;
}

/// Projected height of a figure.  [px]
double pixels_of(const View& view, const Axes& axes, const Figure& figure) {
  const double depth = std::max(dot(axes.ahead, figure.p - view.eye), view.near);
  return figure.height / depth * view.height / (2 * view.half_height);
}

struct SurfaceProgram {
  Program program;
  GLint material = -1, base = -1, emission = -1, cut = -1;

  SurfaceProgram() = default;
  SurfaceProgram(const std::string& vertex, const std::string& fragment) : program(vertex, fragment) {
    material = program.at("material");
    base = program.at("material_base");
    emission = program.at("emission");
    cut = program.at("cut");
  }
};

/// From where one pass is drawn: by a view, or by its reflection in a mirror.
struct Sight {
  View view;
  Axes axes;
  PageSlot place;
  std::optional<std::size_t> mirror;  // in which of the view's mirrors
  std::array<float, 4> cut{};         // shown is where n p + d >= 0, in E, of a reflection
  double first = 0;                   // m along the optical axis, before which it shows nothing
};

/// How many pixels of the picture share a texel of a mirror, across and down.
std::uint32_t pixels_per_texel(const View& view) {
  std::uint32_t per_texel = 1;
  const auto texels = [&](std::uint32_t pixels) -> std::uint64_t { return (pixels - 1) / per_texel + 1; };
  while (texels(view.width) * texels(view.height) > kMirrorTexels) ++per_texel;
  return per_texel;
}

}  // namespace

class Renderer::Impl {
 public:
  explicit Impl(std::unique_ptr<GlContext> context) : context_(std::move(context)) {}
  ~Impl();

  Result<void> prepare();
  const std::string& name() const { return context_->renderer(); }
  std::uint32_t add_shape(const mesh::Mesh& mesh);
  void draw(const Environment& surroundings, const Scene& scene, std::span<const View> views,
            std::vector<Picture>& pictures);

 private:
  /// Inputs of the current draw().
  struct Drawn {
    const Environment& surroundings;
    const Scene& scene;
  };
  /// For pictures with mirrors.
  struct Mirrors {
    std::array<SurfaceProgram, 2> beyond;  // what they show; by Bends
    Program smoke_beyond;
    SurfaceProgram surface;  // themselves
    GLint planes = -1, windows = -1, shown = -1;
    bool is_sound = false;
    MirrorPage page;
  };
  /// OpenGL objects; destroyed while the context is current.
  struct OnCard {
    ShapeStore shapes;
    FigureStore figures;
    std::array<std::array<SurfaceProgram, kPaints>, 2> surface;  // by Bends and Paints
    std::array<Program, kPaints> floor;
    Program sky;
    Program smoke;
    VertexArray rigid, bent, empty;
    Buffer view, lamps, instances, bones;
    std::array<ShadowMap, kShadowTexels.size()> shadows;
    Texture white;
    Page colors{Shows::kColor}, depths{Shows::kDepth}, segments{Shows::kSegments};
    std::unique_ptr<Mirrors> mirrors;  // from the first mirror in a picture on
  };

  Result<void> make_programs();
  void make_arrays();
  void set_bones(std::span<const Figure> figures);
  void draw_kind(const Drawn& drawn, Shows shows, std::span<const View> views,
                 std::vector<Picture>& pictures);
  void draw_view(const Drawn& drawn, const View& view, const PageSlot& place);
  void find_mirrors(const Drawn& drawn, const View& view, const Axes& axes);
  void make_mirrors();
  void draw_reflection(const Drawn& drawn, const View& view, const Axes& axes, std::size_t mirror);
  void send_mirrors(const View& view);
  void draw_sight(const Drawn& drawn, const Sight& sight);
  void begin_target(const Sight& sight);
  void draw_bodies(const Drawn& drawn, const Sight& sight, Paints paints);
  void draw_glass(const Drawn& drawn, const Sight& sight);
  void draw_smokes(const Drawn& drawn, const Sight& sight);
  const ShadowMap& shadow_map_for(const View& view) const;
  void draw_shadows(const Drawn& drawn, const View& view, const SunBox& box, const ShadowMap& map);
  void draw_behind(const Program& program, const Line& a, const Line& b);
  void draw_floor(const View& view, Paints paints);
  void draw_sky(const View& view);
  const SurfaceProgram& program_for(const Sight* sight, Bends bends, Paints paints) const;
  void use(const SurfaceProgram& program, const Sight* sight) const;
  /// `sight` is null for shadows.
  void draw_runs(const InstanceList& list, const Sight* sight, Bends bends, Paints paints, bool see_through);
  void draw_surface(const SurfaceRange& range, const DrawRun& run, const SurfaceProgram& program,
                    Paints paints);
  ViewBlock block_of(const Drawn& drawn, const View& view, const Axes& axes, const PageSlot& place) const;
  void send(const ViewBlock& block);
  void send_lamps(const Drawn& drawn, const Vec3& eye);
  Page& page_of(Shows shows);

  std::unique_ptr<GlContext> context_;
  std::unique_ptr<OnCard> card_;
  InstanceList bodies_, people_, glass_;
  MirrorList mirrors_;  // of the view that is drawn
  std::vector<std::array<float, 12>> bone_rows_;
  std::vector<std::pair<float, std::uint32_t>> lamp_order_;
};

Renderer::Impl::~Impl() {
  const CurrentContext current(*context_);
  card_.reset();
}

Result<void> Renderer::Impl::prepare() {
  const CurrentContext current(*context_);
  card_ = std::make_unique<OnCard>();
  if (Result<void> made = make_programs(); !made) return made;
  card_->figures.upload();
  card_->shapes.upload();
  make_arrays();
  for (std::size_t i = 0; i < kShadowTexels.size(); ++i)
    card_->shadows[i] = make_shadow_map(kShadowTexels[i]);
  card_->white = make_texture(GL_RGBA8, 1, 1);
  // Rows from the top; reversed depth, 1 near to 0 far.
  glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_FRAMEBUFFER_SRGB);
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_DITHER);
  return {};
}

Result<void> Renderer::Impl::make_programs() {
  std::string error;
  const auto keep = [&error](const Program& program) {
    if (error.empty()) error = program.error();
  };
  for (std::size_t p = 0; p < kPaints; ++p) {
    const auto paints = static_cast<Paints>(p);
    for (const Bends bends : {Bends::kNo, Bends::kYes}) {
      SurfaceProgram& to = card_->surface[static_cast<std::size_t>(bends)][p];
      to = SurfaceProgram(vertex_shader(bends, paints), fragment_shader(paints));
      keep(to.program);
    }
    card_->floor[p] = Program(background_vertex_shader(), floor_fragment_shader(paints));
    keep(card_->floor[p]);
  }
  card_->sky = Program(background_vertex_shader(), sky_fragment_shader());
  keep(card_->sky);
  card_->smoke = Program(smoke_vertex_shader(), smoke_fragment_shader());
  keep(card_->smoke);
  if (!error.empty()) return Error{context_->renderer(), error};
  return {};
}

void Renderer::Impl::make_arrays() {
  const auto array = [] {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return VertexArray(name);
  };
  // Vertex attributes use binding 0, instance attributes binding 1.
  const auto attribute = [](GLuint to, GLuint location, GLint numbers, GLuint at, GLuint binding) {
    glEnableVertexArrayAttrib(to, location);
    glVertexArrayAttribFormat(to, location, numbers, GL_FLOAT, GL_FALSE, at);
    glVertexArrayAttribBinding(to, location, binding);
  };
  const auto instance_attributes = [&](GLuint to) {
    for (GLuint row = 0; row < 3; ++row) attribute(to, 4 + row, 4, 16 * row, 1);
    attribute(to, 7, 4, offsetof(CardInstance, tint), 1);
    glEnableVertexArrayAttrib(to, 8);
    glVertexArrayAttribIFormat(to, 8, 2, GL_UNSIGNED_INT, offsetof(CardInstance, segment));
    glVertexArrayAttribBinding(to, 8, 1);
    attribute(to, 9, 1, offsetof(CardInstance, glow), 1);
    glVertexArrayBindingDivisor(to, 1, 1);
  };
  constexpr GLuint kFloat = sizeof(float);
  card_->rigid = array();
  attribute(card_->rigid, 0, 3, 0, 0);
  attribute(card_->rigid, 1, 3, 3 * kFloat, 0);
  attribute(card_->rigid, 2, 2, 6 * kFloat, 0);
  instance_attributes(card_->rigid);
  card_->bent = array();
  attribute(card_->bent, 0, 3, 0, 0);
  attribute(card_->bent, 1, 3, 3 * kFloat, 0);
  attribute(card_->bent, 2, 4, 6 * kFloat, 0);
  attribute(card_->bent, 3, 4, 10 * kFloat, 0);
  instance_attributes(card_->bent);
  glVertexArrayVertexBuffer(card_->bent, 0, card_->figures.corners(), 0, FigureStore::kCornerBytes);
  glVertexArrayElementBuffer(card_->bent, card_->figures.indices());
  card_->empty = array();
}

/// The coarsest map that is fine enough for the picture.
const ShadowMap& Renderer::Impl::shadow_map_for(const View& view) const {
  const auto wanted = static_cast<GLsizei>(kTexelsOfPixels * std::max(view.width, view.height));
  std::size_t i = 0;
  while (i + 1 < card_->shadows.size() && 5 * card_->shadows[i].texels < 4 * wanted) ++i;
  return card_->shadows[i];
}

std::uint32_t Renderer::Impl::add_shape(const mesh::Mesh& mesh) {
  const CurrentContext current(*context_);
  return card_->shapes.add(mesh);
}

Page& Renderer::Impl::page_of(Shows shows) {
  return shows == Shows::kColor ? card_->colors : shows == Shows::kDepth ? card_->depths : card_->segments;
}

void Renderer::Impl::draw(const Environment& surroundings, const Scene& scene, std::span<const View> views,
                          std::vector<Picture>& pictures) {
  pictures.resize(views.size());
  if (views.empty()) return;
  const CurrentContext current(*context_);
  card_->shapes.upload();
  glVertexArrayVertexBuffer(card_->rigid, 0, card_->shapes.corners(), 0, ShapeStore::kCornerBytes);
  glVertexArrayElementBuffer(card_->rigid, card_->shapes.indices());
  set_bones(scene.figures);
  for (const Shows shows : {Shows::kColor, Shows::kDepth, Shows::kSegments})
    draw_kind({surroundings, scene}, shows, views, pictures);
}

void Renderer::Impl::set_bones(std::span<const Figure> figures) {
  bone_rows_.clear();
  for (const Figure& figure : figures) {
    const BoneRows rows = pose_humanoid(figure.gait);
    bone_rows_.insert(bone_rows_.end(), rows.begin(), rows.end());
  }
  card_->bones.set(std::span<const std::array<float, 12>>(bone_rows_), GL_STREAM_DRAW);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, card_->bones);
}

/// Draws all views of a format, page by page, with one read-back per page.
void Renderer::Impl::draw_kind(const Drawn& drawn, Shows shows, std::span<const View> views,
                               std::vector<Picture>& pictures) {
  std::vector<std::size_t> rows;
  std::vector<PictureSize> sizes;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i].shows != shows) continue;
    rows.push_back(i);
    sizes.push_back({views[i].width, views[i].height});
  }
  const std::vector<PageSlot> places = pack(sizes, kPage);
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    PictureSize used;
    for (end = begin; end < rows.size() && places[end].page == places[begin].page; ++end) {
      used.width = std::max(used.width, places[end].x + sizes[end].width);
      used.height = std::max(used.height, places[end].y + sizes[end].height);
    }
    Page& page = page_of(shows);
    page.begin(used);
    for (std::size_t i = begin; i < end; ++i) draw_view(drawn, views[rows[i]], places[i]);
    const std::span<const std::uint32_t> read = page.read();
    for (std::size_t i = begin; i < end; ++i) {
      const View& view = views[rows[i]];
      Picture& picture = pictures[rows[i]];
      picture.sample.clear();
      picture.depth.clear();
      for (std::uint32_t y = 0; y < view.height; ++y) {
        const auto row = read.subspan(std::size_t{places[i].y + y} * used.width + places[i].x, view.width);
        for (const std::uint32_t value : row) {
          if (shows == Shows::kDepth) picture.depth.push_back(depth_of(std::bit_cast<float>(value), view));
          if (shows == Shows::kSegments) picture.sample.push_back(value);
          if (shows == Shows::kColor)  // OpenGL has red in the low byte
            picture.sample.push_back((value & 0xff) << 16 | (value & 0xff00) | (value >> 16 & 0xff));
        }
      }
    }
  }
}

ViewBlock Renderer::Impl::block_of(const Drawn& drawn, const View& view, const Axes& axes,
                                   const PageSlot& place) const {
  const Environment& around = drawn.surroundings;
  ViewBlock block;
  block.clip = clip_from_eye(view, axes);
  block.ahead = four(axes.ahead, view.near);
  block.left = four(view.half_width * axes.left, view.far);
  block.up = four(view.half_height * axes.up, view.eye.z);
  block.viewport = {static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(view.width),
                    static_cast<float>(view.height)};
  block.to_sun = four(around.to_sun, around.to_sun.z > 0 ? around.sun : 0);
  block.sky = four(around.sky, around.ambient);
  block.fog = four(around.fog, around.visibility > 0 ? 3 / around.visibility : 0);
  block.floor = four(around.floor, 0);
  constexpr double kPattern = 64;  // m, period of the floor pattern
  block.eye = four(Vec3{view.eye.x - kPattern * std::floor(view.eye.x / kPattern),
                        view.eye.y - kPattern * std::floor(view.eye.y / kPattern), view.eye.z},
                   around.seconds);
  return block;
}

void Renderer::Impl::send(const ViewBlock& block) {
  card_->view.set(std::span<const ViewBlock>(&block, 1), GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, card_->view);
}

/// Uploads the lamps that are brightest at the eye; ties by index.
void Renderer::Impl::send_lamps(const Drawn& drawn, const Vec3& eye) {
  const std::span<const Lamp> lamps = drawn.scene.lamps;
  lamp_order_.clear();
  for (std::uint32_t row = 0; row < lamps.size(); ++row) {
    const Lamp& lamp = lamps[row];
    const Vec3 away = lamp.p - eye;
    const float light = std::max({lamp.light[0], lamp.light[1], lamp.light[2]});
    lamp_order_.emplace_back(-light / static_cast<float>(std::max(dot(away, away), 1.0)), row);
  }
  const std::size_t count = std::min(lamp_order_.size(), kMostLamps);
  std::ranges::partial_sort(lamp_order_, lamp_order_.begin() + static_cast<std::ptrdiff_t>(count));
  LampBlock block;
  block.count[0] = static_cast<float>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Lamp& lamp = lamps[lamp_order_[i].second];
    block.at[i] = four(lamp.p - eye, lamp.outer);
    block.way[i] = four(lamp.way, lamp.inner);
    for (std::size_t k = 0; k < 3; ++k) block.light[i][k] = lamp.light[k] / drawn.surroundings.white_lux;
  }
  card_->lamps.set(std::span<const LampBlock>(&block, 1), GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, 2, card_->lamps);
}

void Renderer::Impl::draw_view(const Drawn& drawn, const View& view, const PageSlot& place) {
  const Axes axes = axes_of(view.q_WC);
  find_mirrors(drawn, view, axes);
  for (std::size_t i = 0; i < mirrors_.mirrors().size(); ++i) draw_reflection(drawn, view, axes, i);
  if (!mirrors_.mirrors().empty()) send_mirrors(view);
  draw_sight(drawn, {view, axes, place, {}, {}, view.near});
}

/// The mirrors that a colour picture shows, with targets for what they show.
void Renderer::Impl::find_mirrors(const Drawn& drawn, const View& view, const Axes& axes) {
  mirrors_.begin(view, axes);
  if (view.shows != Shows::kColor || !card_->shapes.has_mirrors()) return;
  const Planes planes = planes_of(view, axes);
  for (const Instance& instance : drawn.scene.instances) {
    const ShapeOnCard& shape = card_->shapes[instance.shape];
    if (shape.mirrors.empty() || instance.tint[3] < kOpaque) continue;
    if (instance.group == view.hides && view.hides != kNoGroup) continue;
    const Vec3 p_E = instance.p - view.eye;
    if (planes.may_show(p_E + instance.q * shape.middle, shape.radius))
      mirrors_.add(p_E, instance.q, shape.mirrors);
  }
  mirrors_.finish();
  if (mirrors_.mirrors().empty()) return;
  make_mirrors();
  if (!card_->mirrors->is_sound) return mirrors_.begin(view, axes);
  const std::uint32_t per_texel = pixels_per_texel(view);
  card_->mirrors->page.begin({(view.width - 1) / per_texel + 1, (view.height - 1) / per_texel + 1},
                             mirrors_.mirrors().size());
}

void Renderer::Impl::make_mirrors() {
  if (card_->mirrors) return;
  card_->mirrors = std::make_unique<Mirrors>();
  Mirrors& made = *card_->mirrors;
  for (const Bends bends : {Bends::kNo, Bends::kYes})
    made.beyond[static_cast<std::size_t>(bends)] = SurfaceProgram(
        vertex_shader(bends, Paints::kColor, Shown::kBeyondPlane), fragment_shader(Paints::kColor));
  made.smoke_beyond = Program(smoke_vertex_shader(), smoke_fragment_shader(Shown::kBeyondPlane));
  made.surface = SurfaceProgram(vertex_shader(Bends::kNo, Paints::kColor), mirror_fragment_shader());
  made.planes = made.surface.program.at("mirrors");
  made.windows = made.surface.program.at("mirror_windows");
  made.shown = made.surface.program.at("mirrors_shown");
  for (const Program* program :
       {&made.beyond[0].program, &made.beyond[1].program, &made.smoke_beyond, &made.surface.program})
    if (!program->error().empty())
      return log::warn("cameras show mirrors without what they reflect: {}", program->error());
  made.is_sound = true;
}

/// What a mirror shows, where the view shows the mirror.
void Renderer::Impl::draw_reflection(const Drawn& drawn, const View& view, const Axes& axes,
                                     std::size_t number) {
  const Mirror& mirror = mirrors_.mirrors()[number];
  const std::uint32_t per_texel = pixels_per_texel(view);
  Sight sight{reflected(view, mirror), reflected(axes, mirror), {}, number, {}, 0};
  sight.view.width = (view.width - 1) / per_texel + 1;
  sight.view.height = (view.height - 1) / per_texel + 1;
  sight.cut = four(mirror.n, -mirror.d - kBeyond);  // the eye is behind the plane as far as it was before it
  sight.first = std::max(view.near, mirror.depth);
  const Window& window = mirror.window;
  const std::uint32_t left = window.left / per_texel, high = window.high / per_texel;
  glScissor(static_cast<GLint>(left), static_cast<GLint>(high),
            static_cast<GLsizei>((window.right - 1) / per_texel + 1 - left),
            static_cast<GLsizei>((window.low - 1) / per_texel + 1 - high));
  glFrontFace(GL_CW);
  draw_sight(drawn, sight);
  glFrontFace(GL_CCW);
  glDisable(GL_SCISSOR_TEST);
}

void Renderer::Impl::send_mirrors(const View& view) {
  const Mirrors& to = *card_->mirrors;
  const std::span<const Mirror> mirrors = mirrors_.mirrors();
  std::array<std::array<float, 4>, kMostMirrors> planes{}, windows{};
  for (std::size_t i = 0; i < mirrors.size(); ++i) {
    const Window& window = mirrors[i].window;
    planes[i] = four(mirrors[i].n, mirrors[i].d);
    windows[i] = {static_cast<float>(window.left), static_cast<float>(window.high),
                  static_cast<float>(window.right), static_cast<float>(window.low)};
  }
  glProgramUniform4fv(to.surface.program, to.planes, kMostMirrors, planes[0].data());
  glProgramUniform4fv(to.surface.program, to.windows, kMostMirrors, windows[0].data());
  const float per_pixel = 1 / static_cast<float>(pixels_per_texel(view));
  glProgramUniform4f(to.surface.program, to.shown, static_cast<float>(mirrors.size()), per_pixel, per_pixel,
                     0);
  glBindTextureUnit(2, to.page.colors());
}

void Renderer::Impl::draw_sight(const Drawn& drawn, const Sight& sight) {
  const View& view = sight.view;
  const Paints paints = paints_of(view.shows);
  ViewBlock block = block_of(drawn, view, sight.axes, sight.place);
  const ShadowMap& map = shadow_map_for(view);
  if (paints == Paints::kColor && block.to_sun[3] > 0) {
    View shaded = view;
    shaded.near = sight.first;
    const double reach = sight.mirror ? sight.first + kShadowReach : kShadowReach;
    const SunBox box = sun_box(shaded, sight.axes, drawn.surroundings.to_sun, reach);
    ViewBlock of_sun = block;
    of_sun.clip = block.sun_clip = clip_from_eye(box);
    block.floor[3] =
        static_cast<float>(std::max(box.high.y - box.low.y, box.high.z - box.low.z) / map.texels);
    send(of_sun);
    draw_shadows(drawn, view, box, map);
  }
  send(block);
  if (paints == Paints::kColor) send_lamps(drawn, view.eye);
  begin_target(sight);
  glDepthFunc(GL_GEQUAL);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glBindTextureUnit(0, map.depth);
  draw_bodies(drawn, sight, paints);
  draw_floor(view, paints);
  if (paints == Paints::kColor) draw_sky(view);
  if (paints != Paints::kColor) return;
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  draw_glass(drawn, sight);
  draw_smokes(drawn, sight);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void Renderer::Impl::begin_target(const Sight& sight) {
  if (sight.mirror) {
    glEnable(GL_SCISSOR_TEST);
    card_->mirrors->page.clear(*sight.mirror);
    card_->mirrors->page.bind(*sight.mirror);
  } else {
    page_of(sight.view.shows).bind();
  }
  glViewport(static_cast<GLint>(sight.place.x), static_cast<GLint>(sight.place.y),
             static_cast<GLsizei>(sight.view.width), static_cast<GLsizei>(sight.view.height));
}

/// Opaque bodies; for depth and segmentation also transparent ones.
void Renderer::Impl::draw_bodies(const Drawn& drawn, const Sight& sight, Paints paints) {
  const View& view = sight.view;
  const Axes& axes = sight.axes;
  const Planes planes = planes_of(view, axes);
  bodies_.clear();
  for (std::uint32_t row = 0; row < drawn.scene.instances.size(); ++row) {
    const Instance& instance = drawn.scene.instances[row];
    if (instance.group == view.hides && view.hides != kNoGroup) continue;
    if (paints == Paints::kColor && instance.tint[3] < kOpaque) continue;
    const ShapeOnCard& shape = card_->shapes[instance.shape];
    const Vec3 middle = instance.p - view.eye + instance.q * shape.middle;
    if (planes.may_show(middle, shape.radius)) bodies_.add(instance.shape, dot(axes.ahead, middle), row);
  }
  bodies_.finish(false, [&](std::uint32_t row) { return seen_from(view.eye, drawn.scene.instances[row]); });
  draw_runs(bodies_, &sight, Bends::kNo, paints, paints != Paints::kColor);
  people_.clear();
  for (std::uint32_t row = 0; row < drawn.scene.figures.size(); ++row) {
    const Figure& figure = drawn.scene.figures[row];
    if (figure.group == view.hides && view.hides != kNoGroup) continue;
    const Vec3 middle = figure.p - view.eye + Vec3{0, 0, 0.5 * figure.height};
    if (!planes.may_show(middle, kFigureRadius * figure.height)) continue;
    const double high = pixels_of(view, axes, figure);
    people_.add(high > kFinePixels ? 0 : high > kCoarsePixels ? 1 : 2, dot(axes.ahead, middle), row);
  }
  people_.finish(false, [&](std::uint32_t row) {
    return seen_from(view.eye, drawn.scene.figures[row], row * Humanoid::kBones);
  });
  draw_runs(people_, &sight, Bends::kYes, paints, true);
}

/// Transparent surfaces, back to front.
void Renderer::Impl::draw_glass(const Drawn& drawn, const Sight& sight) {
  const View& view = sight.view;
  const Planes planes = planes_of(view, sight.axes);
  glass_.clear();
  for (std::uint32_t row = 0; row < drawn.scene.instances.size(); ++row) {
    const Instance& instance = drawn.scene.instances[row];
    const ShapeOnCard& shape = card_->shapes[instance.shape];
    const bool is_clear = instance.tint[3] < kOpaque;
    if (!is_clear && std::ranges::none_of(shape.surfaces, &SurfaceRange::is_see_through)) continue;
    if (instance.group == view.hides && view.hides != kNoGroup) continue;
    const Vec3 middle = instance.p - view.eye + instance.q * shape.middle;
    if (planes.may_show(middle, shape.radius)) glass_.add(instance.shape, -dot(middle, middle), row);
  }
  glass_.finish(true, [&](std::uint32_t row) { return seen_from(view.eye, drawn.scene.instances[row]); });
  if (glass_.runs.empty()) return;
  // A transparent tint makes all surfaces transparent; otherwise only those with a transparent material.
  card_->instances.set(std::span<const CardInstance>(glass_.instances), GL_STREAM_DRAW);
  glBindVertexArray(card_->rigid);
  glVertexArrayVertexBuffer(card_->rigid, 1, card_->instances, 0, sizeof(CardInstance));
  const SurfaceProgram& program = program_for(&sight, Bends::kNo, Paints::kColor);
  use(program, &sight);
  for (const DrawRun& run : glass_.runs) {
    const bool is_clear = glass_.instances[run.first].tint[3] < kOpaque;
    for (const SurfaceRange& range : card_->shapes[run.what].surfaces)
      if (is_clear || range.is_see_through) draw_surface(range, run, program, Paints::kColor);
  }
  glDisable(GL_CLIP_DISTANCE0);
}

void Renderer::Impl::draw_smokes(const Drawn& drawn, const Sight& sight) {
  const View& view = sight.view;
  if (drawn.scene.smokes.empty()) return;
  std::vector<const Smoke*> order;
  for (const Smoke& smoke : drawn.scene.smokes)
    if (smoke.group != view.hides || view.hides == kNoGroup) order.push_back(&smoke);
  const auto away = [&](const Smoke* smoke) { return dot(smoke->p - view.eye, smoke->p - view.eye); };
  std::ranges::stable_sort(order, std::greater(), away);
  static constexpr float kCube[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                        {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  static constexpr std::uint8_t kSides[36] = {0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                              1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
  std::vector<float> corners;
  for (const std::uint8_t corner : kSides) corners.insert(corners.end(), kCube[corner], kCube[corner] + 3);
  Buffer cube;
  cube.set(std::span<const float>(corners), GL_STREAM_DRAW);
  if (sight.mirror)
    card_->mirrors->page.bind_colors(*sight.mirror);
  else
    card_->colors.bind_colors();
  const Program& program = sight.mirror ? card_->mirrors->smoke_beyond : card_->smoke;
  glBindVertexArray(card_->empty);
  glEnableVertexArrayAttrib(card_->empty, 0);
  glVertexArrayAttribFormat(card_->empty, 0, 3, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(card_->empty, 0, 0);
  glVertexArrayVertexBuffer(card_->empty, 0, cube, 0, 3 * sizeof(float));
  glUseProgram(program);
  glUniform4fv(program.at("cut"), 1, sight.cut.data());
  glBindTextureUnit(1, sight.mirror ? card_->mirrors->page.depth() : card_->colors.depth());
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_DEPTH_CLAMP);
  glCullFace(GL_FRONT);
  for (const Smoke* smoke : order) {
    const Axes axes = axes_of(smoke->q);
    const std::array sides{four(axes.ahead, std::max(smoke->half.x, 1e-3)),
                           four(axes.left, std::max(smoke->half.y, 1e-3)),
                           four(axes.up, std::max(smoke->half.z, 1e-3))};
    glUniform4fv(program.at("middle"), 1, four(smoke->p - view.eye, drawn.surroundings.seconds).data());
    glUniform4fv(program.at("side"), 3, sides[0].data());
    glUniform4fv(program.at("smoke"), 1, smoke->tint.data());
    glDrawArrays(GL_TRIANGLES, 0, 36);
  }
  glCullFace(GL_BACK);
  glDisable(GL_DEPTH_CLAMP);
  glEnable(GL_DEPTH_TEST);
  glDisableVertexArrayAttrib(card_->empty, 0);
}

/// Shadow casters between the sun and the view, including those outside the view frustum.
void Renderer::Impl::draw_shadows(const Drawn& drawn, const View& view, const SunBox& box,
                                  const ShadowMap& map) {
  glBindFramebuffer(GL_FRAMEBUFFER, map.target);
  glViewport(0, 0, map.texels, map.texels);
  const float far = 1;
  glClearNamedFramebufferfv(map.target, GL_DEPTH, 0, &far);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_CLAMP);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5f, 2);
  bodies_.clear();
  for (std::uint32_t row = 0; row < drawn.scene.instances.size(); ++row) {
    const Instance& instance = drawn.scene.instances[row];
    const ShapeOnCard& shape = card_->shapes[instance.shape];
    if (instance.tint[3] < kOpaque) continue;
    if (box.may_shade(instance.p - view.eye + instance.q * shape.middle, shape.radius))
      bodies_.add(instance.shape, 0, row);
  }
  bodies_.finish(false, [&](std::uint32_t row) { return seen_from(view.eye, drawn.scene.instances[row]); });
  draw_runs(bodies_, nullptr, Bends::kNo, Paints::kDepth, false);
  people_.clear();
  for (std::uint32_t row = 0; row < drawn.scene.figures.size(); ++row) {
    const Figure& figure = drawn.scene.figures[row];
    const Vec3 middle = figure.p - view.eye + Vec3{0, 0, 0.5 * figure.height};
    if (box.may_shade(middle, kFigureRadius * figure.height)) people_.add(2, 0, row);
  }
  people_.finish(false, [&](std::uint32_t row) {
    return seen_from(view.eye, drawn.scene.figures[row], row * Humanoid::kBones);
  });
  draw_runs(people_, nullptr, Bends::kYes, Paints::kDepth, true);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_CLAMP);
}

/// Draws a background, clipped to ray slopes where lines `a` and `b` are not negative.
void Renderer::Impl::draw_behind(const Program& program, const Line& a, const Line& b) {
  glUseProgram(program);
  glUniform4f(program.at("lines"), static_cast<float>(a.slope), static_cast<float>(a.offset),
              static_cast<float>(b.slope), static_cast<float>(b.offset));
  glBindVertexArray(card_->empty);
  glDisable(GL_CULL_FACE);  // its triangle turns the same way in reflections
  glEnable(GL_CLIP_DISTANCE0);
  glEnable(GL_CLIP_DISTANCE1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_CLIP_DISTANCE1);
  glDisable(GL_CLIP_DISTANCE0);
  glEnable(GL_CULL_FACE);
}

/// The floor between the near and far planes.
void Renderer::Impl::draw_floor(const View& view, Paints paints) {
  if (!(view.eye.z > 0)) return;
  draw_behind(card_->floor[static_cast<std::size_t>(paints)], {-1, -view.eye.z / view.far},
              {1, view.eye.z / view.near});
}

/// The sky, where there is no floor: above the horizon, and below an eye close to the floor.
void Renderer::Impl::draw_sky(const View& view) {
  if (!(view.eye.z > 0)) return draw_behind(card_->sky, {}, {});
  draw_behind(card_->sky, {1, view.eye.z / view.far}, {});
  draw_behind(card_->sky, {-1, -view.eye.z / view.near}, {});
}

const SurfaceProgram& Renderer::Impl::program_for(const Sight* sight, Bends bends, Paints paints) const {
  if (sight != nullptr && sight->mirror) return card_->mirrors->beyond[static_cast<std::size_t>(bends)];
  return card_->surface[static_cast<std::size_t>(bends)][static_cast<std::size_t>(paints)];
}

/// Until GL_CLIP_DISTANCE0 is disabled.
void Renderer::Impl::use(const SurfaceProgram& program, const Sight* sight) const {
  glUseProgram(program.program);
  if (sight == nullptr || !sight->mirror) return;
  glUniform4fv(program.cut, 1, sight->cut.data());
  glEnable(GL_CLIP_DISTANCE0);
}

void Renderer::Impl::draw_runs(const InstanceList& list, const Sight* sight, Bends bends, Paints paints,
                               bool see_through) {
  if (list.runs.empty()) return;
  const bool is_bent = bends == Bends::kYes;
  const VertexArray& array = is_bent ? card_->bent : card_->rigid;
  card_->instances.set(std::span<const CardInstance>(list.instances), GL_STREAM_DRAW);
  glBindVertexArray(array);
  glVertexArrayVertexBuffer(array, 1, card_->instances, 0, sizeof(CardInstance));
  const SurfaceProgram& program = program_for(sight, bends, paints);
  use(program, sight);
  const bool has_mirrors = sight != nullptr && !sight->mirror && !mirrors_.mirrors().empty();
  for (const DrawRun& run : list.runs) {
    if (is_bent) {
      const FigureStore::DetailLevel& level = card_->figures.level(static_cast<int>(run.what));
      SurfaceRange range;
      range.first_index = level.first_index;
      range.indices = level.indices;
      range.first_corner = level.first_corner;
      range.roughness = 0.8f;
      draw_surface(range, run, program, paints);
      continue;
    }
    for (const SurfaceRange& range : card_->shapes[run.what].surfaces) {
      if (range.is_see_through && !see_through) continue;
      const bool is_mirror = has_mirrors && range.is_mirror;
      if (is_mirror) use(card_->mirrors->surface, sight);
      draw_surface(range, run, is_mirror ? card_->mirrors->surface : program, paints);
      if (is_mirror) use(program, sight);
    }
  }
  glDisable(GL_CLIP_DISTANCE0);
}

void Renderer::Impl::draw_surface(const SurfaceRange& range, const DrawRun& run,
                                  const SurfaceProgram& program, Paints paints) {
  if (paints == Paints::kColor) {
    glUniform4f(program.material, range.metallic, range.roughness, range.texture != 0 ? 1 : 0,
                range.least_opacity);
    glUniform4fv(program.base, 1, range.base.data());
    glUniform3fv(program.emission, 1, range.emission.data());
    glBindTextureUnit(1, range.texture != 0 ? range.texture : GLuint{card_->white});
  }
  const bool shows_both = range.is_two_sided;
  const GLboolean culls = glIsEnabled(GL_CULL_FACE);
  if (shows_both) glDisable(GL_CULL_FACE);
  glDrawElementsInstancedBaseVertexBaseInstance(
      GL_TRIANGLES, static_cast<GLsizei>(range.indices), GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(range.first_index * sizeof(std::uint32_t)),
      static_cast<GLsizei>(run.count), static_cast<GLint>(range.first_corner), run.first);
  if (shows_both && culls == GL_TRUE) glEnable(GL_CULL_FACE);
}

float linear(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::make() {
  Result<std::unique_ptr<GlContext>> context = GlContext::make();
  if (!context) return context.error();
  auto impl = std::make_unique<Impl>(std::move(*context));
  if (const Result<void> prepared = impl->prepare(); !prepared) return prepared.error();
  return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}

const std::string& Renderer::name() const {
  return impl_->name();
}

std::uint32_t Renderer::add_shape(const mesh::Mesh& mesh) {
  return impl_->add_shape(mesh);
}

void Renderer::draw(const Environment& surroundings, const Scene& scene, std::span<const View> views,
                    std::vector<Picture>& pictures) {
  impl_->draw(surroundings, scene, views, pictures);
}

}  // namespace playhouse::render
