#pragma once

/// GlContext: OpenGL 4.5 without a window or a display server, through EGL: on a graphics card where there is
/// one that this process may use, else on Mesa's software renderer. Thread: one at a time, between
/// make_current() and release().

#include <memory>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::render {

class GlContext {
 public:
  /// Fails with one line that says what is missing.
  static Result<std::unique_ptr<GlContext>> make();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Until release() the calling thread may use OpenGL.
  void make_current();
  void release();

  /// Who renders, and which version of OpenGL.
  const std::string& renderer() const { return renderer_; }

 private:
  GlContext(void* display, void* context) : display_(display), context_(context) {}
  static Result<std::unique_ptr<GlContext>> make_on(void* display);

  void* display_;  // EGLDisplay
  void* context_;  // EGLContext
  std::string renderer_;
};

/// OpenGL for a block of code.
class CurrentContext {
 public:
  explicit CurrentContext(GlContext& context) : context_(context) { context_.make_current(); }
  ~CurrentContext() { context_.release(); }
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

 private:
  GlContext& context_;
};

}  // namespace playhouse::render
