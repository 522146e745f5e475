#include "playhouse/render/pages.h"

#include <algorithm>

namespace playhouse::render {

void Page::begin(Sizes size) {
  wanted_ = size;
  if (size.width > size_.width || size.height > size_.height)
    make({std::max(size.width, size_.width), std::max(size.height, size_.height)});
  const float nothing[4] = {0, 0, 0, 0};
  const GLuint nobody[4] = {0, 0, 0, 0};
  if (shows_ == Shows::kColor) glClearNamedFramebufferfv(whole_, GL_COLOR, 0, nothing);
  if (shows_ == Shows::kSegments) glClearNamedFramebufferuiv(whole_, GL_COLOR, 0, nobody);
  glClearNamedFramebufferfv(whole_, GL_DEPTH, 0, nothing);
}

void Page::make(Sizes size) {
  size_ = size;
  const auto width = static_cast<GLsizei>(size.width), height = static_cast<GLsizei>(size.height);
  const auto framebuffer = [] {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return Framebuffer(name);
  };
  depth_ = make_texture(GL_DEPTH_COMPONENT32F, width, height);
  whole_ = framebuffer();
  glNamedFramebufferTexture(whole_, GL_DEPTH_ATTACHMENT, depth_, 0);
  if (shows_ == Shows::kDepth) {
    glNamedFramebufferDrawBuffer(whole_, GL_NONE);
    glNamedFramebufferReadBuffer(whole_, GL_NONE);
    return;
  }
  color_ = make_texture(shows_ == Shows::kColor ? GL_SRGB8_ALPHA8 : GL_R32UI, width, height);
  colors_alone_ = framebuffer();
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

}  // namespace playhouse::render
