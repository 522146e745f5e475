#include "playhouse/render/gl_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "playhouse/base/assert.h"

namespace playhouse::render {
namespace {

/// Checked first, since libepoxy aborts if a library is missing.
bool can_load(const char* name) {
  return dlopen(name, RTLD_LAZY | RTLD_LOCAL) != nullptr;  // stays loaded: used right after
}

bool has_extension(const char* all, std::string_view wanted) {
  for (std::string_view rest = all ? all : ""; !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == wanted) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

/// Displays to try: GPUs, then Mesa's surfaceless platform, then software devices.
std::vector<EGLDisplay> displays() {
  std::vector<EGLDisplay> cards, others;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (has_extension(client, "EGL_EXT_platform_device") &&
      has_extension(client, "EGL_EXT_device_enumeration")) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(devices.size(), devices.data(), &count) == EGL_TRUE)
      for (EGLint i = 0; i < count; ++i) {
        const char* can = eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS);
        auto& to = has_extension(can, "EGL_MESA_device_software") ? others : cards;
        to.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
      }
  }
  if (has_extension(client, "EGL_MESA_platform_surfaceless"))
    cards.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  cards.insert(cards.end(), others.begin(), others.end());
  return cards;
}

}  // namespace

Result<std::unique_ptr<GlContext>> GlContext::make() {
  if (!can_load("libEGL.so.1")) return Error{{}, "libEGL.so.1 is not installed"};
  if (!can_load("libOpenGL.so.0") && !can_load("libGL.so.1"))
    return Error{{}, "neither libOpenGL.so.0 nor libGL.so.1 is installed"};
  Error reason{{}, "EGL has no device and no display that needs no screen"};
  for (const EGLDisplay display : displays()) {
    if (display == EGL_NO_DISPLAY) continue;
    Result<std::unique_ptr<GlContext>> made = make_on(display);
    if (made) return made;
    reason = made.error();
  }
  return reason;
}

/// The display stays initialised until the process ends: EGL
/// displays are shared process-wide, maybe with other users.
Result<std::unique_ptr<GlContext>> GlContext::make_on(void* display) {
  if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return Error{{}, "EGL cannot use its device"};
  const char* can = eglQueryString(display, EGL_EXTENSIONS);
  if (!has_extension(can, "EGL_KHR_surfaceless_context")) return Error{{}, "EGL needs a surface"};
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return Error{{}, "EGL has no OpenGL"};
  const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, wanted, &config, 1, &count) != EGL_TRUE || count == 0) {
    if (!has_extension(can, "EGL_KHR_no_config_context")) return Error{{}, "EGL has no configuration"};
    config = EGL_NO_CONFIG_KHR;
  }
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                            4,
                            EGL_CONTEXT_MINOR_VERSION,
                            5,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                            EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  if (context == EGL_NO_CONTEXT) return Error{{}, "there is no OpenGL 4.5"};
  std::unique_ptr<GlContext> made(new GlContext(display, context));
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE)
    return Error{{}, "OpenGL cannot be used without a surface"};
  const auto text = [](GLenum name) { return std::string(reinterpret_cast<const char*>(glGetString(name))); };
  made->renderer_ = text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
  made->release();
  return made;
}

GlContext::~GlContext() {
  eglDestroyContext(display_, context_);
}

void GlContext::make_current() {
  PLAYHOUSE_ASSERT(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE);
}

void GlContext::release() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

}  // namespace playhouse::render
