#include "playhouse/render/pages.h"

#include <algorithm>

namespace playhouse::render {
namespace {

Framebuffer make_framebuffer() {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  return Framebuffer(name);
}

}  // namespace

void Page::begin(PictureSize size) {
  wanted_ = size;
  if (size.width > size_.width || size.height > size_.height)
    make({std::max(size.width, size_.width), std::max(size.height, size_.height)});
  const float nothing[4] = {0, 0, 0, 0};
  const GLuint nobody[4] = {0, 0, 0, 0};
  if (shows_ == Shows::kColor) glClearNamedFramebufferfv(whole_, GL_COLOR, 0, nothing);
  if (shows_ == Shows::kSegments) glClearNamedFramebufferuiv(whole_, GL_COLOR, 0, nobody);
  glClearNamedFramebufferfv(whole_, GL_DEPTH, 0, nothing);
}

void Page::make(PictureSize size) {
  size_ = size;
  const auto width = static_cast<GLsizei>(size.width), height = static_cast<GLsizei>(size.height);
  depth_ = make_texture(GL_DEPTH_COMPONENT32F, width, height);
  whole_ = make_framebuffer();
  glNamedFramebufferTexture(whole_, GL_DEPTH_ATTACHMENT, depth_, 0);
  if (shows_ == Shows::kDepth) {
    glNamedFramebufferDrawBuffer(whole_, GL_NONE);
    glNamedFramebufferReadBuffer(whole_, GL_NONE);
    return;
  }
  color_ = make_texture(shows_ == Shows::kColor ? GL_SRGB8_ALPHA8 : GL_R32UI, width, height);
  colors_alone_ = make_framebuffer();
  for (const GLuint to : {GLuint{whole_}, GLuint{colors_alone_}}) {
    glNamedFramebufferTexture(to, GL_COLOR_ATTACHMENT0, color_, 0);
    glNamedFramebufferDrawBuffer(to, GL_COLOR_ATTACHMENT0);
    glNamedFramebufferReadBuffer(to, GL_COLOR_ATTACHMENT0);
  }
}

std::span<const std::uint32_t> Page::read() {
  read_.resize(std::size_t{wanted_.width} * wanted_.height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, whole_);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  const auto width = static_cast<GLsizei>(wanted_.width), height = static_cast<GLsizei>(wanted_.height);
  const auto read = [&](GLenum format, GLenum type) {
    glReadPixels(0, 0, width, height, format, type, read_.data());
  };
  if (shows_ == Shows::kColor) read(GL_RGBA, GL_UNSIGNED_BYTE);
  if (shows_ == Shows::kDepth) read(GL_DEPTH_COMPONENT, GL_FLOAT);
  if (shows_ == Shows::kSegments) read(GL_RED_INTEGER, GL_UNSIGNED_INT);
  return read_;
}

void MirrorPage::begin(PictureSize size, std::size_t layers) {
  if (size.width <= size_.width && size.height <= size_.height && layers <= whole_.size()) return;
  size_ = {std::max(size.width, size_.width), std::max(size.height, size_.height)};
  layers = std::max(layers, whole_.size());
  const auto width = static_cast<GLsizei>(size_.width), height = static_cast<GLsizei>(size_.height);
  depth_ = make_texture(GL_DEPTH_COMPONENT32F, width, height);
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
  colors_ = Texture(name);
  glTextureStorage3D(colors_, 1, GL_RGBA16F, width, height, static_cast<GLsizei>(layers));
  glTextureParameteri(colors_, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(colors_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  whole_.clear();
  colors_alone_.clear();
  for (std::size_t layer = 0; layer < layers; ++layer) {
    whole_.push_back(make_framebuffer());
    colors_alone_.push_back(make_framebuffer());
    glNamedFramebufferTexture(whole_.back(), GL_DEPTH_ATTACHMENT, depth_, 0);
    for (const GLuint to : {GLuint{whole_.back()}, GLuint{colors_alone_.back()}}) {
      glNamedFramebufferTextureLayer(to, GL_COLOR_ATTACHMENT0, colors_, 0, static_cast<GLint>(layer));
      glNamedFramebufferDrawBuffer(to, GL_COLOR_ATTACHMENT0);
    }
  }
}

void MirrorPage::clear(std::size_t layer) const {
  const float nothing[4] = {0, 0, 0, 0};
  glClearNamedFramebufferfv(whole_[layer], GL_COLOR, 0, nothing);
  glClearNamedFramebufferfv(whole_[layer], GL_DEPTH, 0, nothing);
}

}  // namespace playhouse::render
