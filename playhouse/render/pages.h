#pragma once

/// Pages: atlases of pictures of one format, read back
/// with one call; and what mirrors show. Thread: that of a CurrentContext.

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
  void begin(PictureSize size);
  /// Binds colour and depth; or colour only, while depth is sampled as a texture.
  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, whole_); }
  void bind_colors() const { glBindFramebuffer(GL_FRAMEBUFFER, colors_alone_); }
  GLuint depth() const { return depth_; }
  /// Blocks until rendering is done. Rows from the top, of the `size` given
  /// to begin(); 32 bits per pixel: 0xAABBGGRR, segment numbers, or a float.
  std::span<const std::uint32_t> read();

 private:
  void make(PictureSize size);

  Shows shows_;
  PictureSize size_, wanted_;
  Texture color_, depth_;
  Framebuffer whole_, colors_alone_;
  std::vector<std::uint32_t> read_;
};

/// Render targets for what the mirrors of a view show: a layer each, in linear light without an upper limit,
/// with one depth buffer. Grows on demand.
class MirrorPage {
 public:
  /// Ensures a minimum size and number of layers.
  void begin(PictureSize size, std::size_t layers);
  /// Clears a layer and the depths, within the scissor test.
  void clear(std::size_t layer) const;
  /// As those of Page.
  void bind(std::size_t layer) const { glBindFramebuffer(GL_FRAMEBUFFER, whole_[layer]); }
  void bind_colors(std::size_t layer) const { glBindFramebuffer(GL_FRAMEBUFFER, colors_alone_[layer]); }
  GLuint depth() const { return depth_; }
  GLuint colors() const { return colors_; }

 private:
  PictureSize size_;
  Texture colors_, depth_;
  std::vector<Framebuffer> whole_, colors_alone_;
};

}  // namespace playhouse::render
