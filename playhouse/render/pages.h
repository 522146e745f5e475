#pragma once

/// Pages: what pictures are drawn on, many of a kind side by side, so that they are read with one call.
/// Thread: that of a CurrentContext.

#include <span>
#include <vector>

#include "playhouse/render/gl_objects.h"
#include "playhouse/render/view.h"

namespace playhouse::render {

/// A page for pictures of one kind. Its size grows to what it is asked for.
class Page {
 public:
  explicit Page(Shows shows) : shows_(shows) {}

  /// Makes it at least so large, and empty.
  void begin(Sizes size);
  /// To draw on its colours and depths; or on the colours alone, while its depths are read as a texture.
  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, whole_); }
  void bind_colors() const { glBindFramebuffer(GL_FRAMEBUFFER, colors_alone_); }
  GLuint depth() const { return depth_; }
  /// Waits until it is drawn. Rows from the top, `size` as begin() was asked; a number of 32 bits for each
  /// pixel: 0xAABBGGRR, segments, or a float.
  std::span<const std::uint32_t> read();

 private:
  void make(Sizes size);

  Shows shows_;
  Sizes size_, wanted_;
  Texture color_, depth_;
  Framebuffer whole_, colors_alone_;
  std::vector<std::uint32_t> read_;
};

}  // namespace playhouse::render
