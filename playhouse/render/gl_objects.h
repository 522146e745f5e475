#pragma once

/// RAII wrappers of OpenGL objects. Thread: that of a CurrentContext.

#include <epoxy/gl.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace playhouse::render {

/// An OpenGL name with its deleter.
template <typename Delete>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint name) : name_(name) {}
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlName() {
    if (name_ != 0) Delete()(name_);
  }
  operator GLuint() const { return name_; }

 private:
  GLuint name_ = 0;
};

struct DeleteBuffer {
  void operator()(GLuint name) const { glDeleteBuffers(1, &name); }
};
struct DeleteTexture {
  void operator()(GLuint name) const { glDeleteTextures(1, &name); }
};
struct DeleteFramebuffer {
  void operator()(GLuint name) const { glDeleteFramebuffers(1, &name); }
};
struct DeleteVertices {
  void operator()(GLuint name) const { glDeleteVertexArrays(1, &name); }
};
struct DeleteProgram {
  void operator()(GLuint name) const { glDeleteProgram(name); }
};
using Texture = GlName<DeleteTexture>;
using Framebuffer = GlName<DeleteFramebuffer>;
using VertexArray = GlName<DeleteVertices>;

/// A buffer object that is reallocated on every set().
class Buffer {
 public:
  template <typename T>
  void set(std::span<const T> all, GLenum usage) {
    const auto bytes = static_cast<GLsizeiptr>(all.size_bytes());
    if (name_ == 0) {
      GLuint name = 0;
      glCreateBuffers(1, &name);
      name_ = GlName<DeleteBuffer>(name);
    }
    // Orphaning: the driver keeps the old storage until pending draws have finished.
    glNamedBufferData(name_, bytes > 0 ? bytes : 16, bytes > 0 ? all.data() : nullptr, usage);
  }
  operator GLuint() const { return name_; }

 private:
  GlName<DeleteBuffer> name_;
};

/// A linked vertex and fragment shader.
class Program {
 public:
  Program() = default;
  Program(const std::string& vertex, const std::string& fragment);
  operator GLuint() const { return name_; }
  GLint at(const char* uniform) const { return glGetUniformLocation(name_, uniform); }
  /// Compiler or linker errors in one line; empty on success.
  const std::string& error() const { return error_; }

 private:
  void attach(GLenum kind, const std::string& text);

  GlName<DeleteProgram> name_;
  std::string error_;
};

Texture make_texture(GLenum format, GLsizei width, GLsizei height);

}  // namespace playhouse::render
