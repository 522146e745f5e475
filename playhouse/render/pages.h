#pragma once

/// Pages: atlases of pictures of one format, read back
/// with one call. Thread: that of a CurrentContext.

#include <span>
#include <vector>

#include "playhouse/render/gl_objects.h"
#include "playhouse/render/view.h"

namespace playhouse::render {

/// A render target for pictures of one format. Grows on demand.
class Page {
 public:
  explicit Page(Shows shows) : shows_(shows) {}

  /// Ensures a minimum size, and clears it.
  void begin(Sizes size);
  /// Binds colour and depth; or colour only, while depth is sampled as a texture.
  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, whole_); }
  void bind_colors() const { glBindFramebuffer(GL_FRAMEBUFFER, colors_alone_); }
  GLuint depth() const { return depth_; }
  /// Blocks until rendering is done. Rows from the top, of the `size` given
  /// to begin(); 32 bits per pixel: 0xAABBGGRR, segment numbers, or a float.
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
