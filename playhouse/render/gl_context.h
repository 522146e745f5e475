#pragma once

/// GlContext: a headless OpenGL 4.5 context through EGL, without a display
/// server: on an accessible GPU if there is one, else on Mesa's software
/// renderer. Thread: one at a time, between make_current() and release().

#include <memory>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::render {

class GlContext {
 public:
  /// Fails with a one-line reason.
  static Result<std::unique_ptr<GlContext>> make();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Binds the context to the calling thread until release().
  void make_current();
  void release();

  /// Name of the renderer, and version of OpenGL.
  const std::string& renderer() const { return renderer_; }

 private:
  GlContext(void* display, void* context) : display_(display), context_(context) {}
  static Result<std::unique_ptr<GlContext>> make_on(void* display);

  void* display_;  // EGLDisplay
  void* context_;  // EGLContext
  std::string renderer_;
};

/// Scoped binding of the context.
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
