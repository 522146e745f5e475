#include "playhouse/render/gl_objects.h"

#include <algorithm>

namespace playhouse::render {
namespace {

std::string first_line(const char* report) {
  const std::string text = report;
  return text.substr(0, text.find('\n'));
}

}  // namespace

Program::Program(const std::string& vertex, const std::string& fragment) : name_(glCreateProgram()) {
  attach(GL_VERTEX_SHADER, vertex);
  attach(GL_FRAGMENT_SHADER, fragment);
  if (!error_.empty()) return;
  glLinkProgram(name_);
  GLint good = GL_FALSE;
  glGetProgramiv(name_, GL_LINK_STATUS, &good);
  if (good == GL_TRUE) return;
  char report[1000] = "";
  glGetProgramInfoLog(name_, sizeof report, nullptr, report);
  error_ = "shaders cannot be linked: " + first_line(report);
}

void Program::attach(GLenum kind, const std::string& text) {
  const GLuint shader = glCreateShader(kind);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good != GL_TRUE && error_.empty()) {
    char report[1000] = "";
    glGetShaderInfoLog(shader, sizeof report, nullptr, report);
    error_ = "a shader cannot be compiled: " + first_line(report);
  }
  glAttachShader(name_, shader);
  glDeleteShader(shader);  // deleted with the program
}

Texture make_texture(GLenum format, GLsizei width, GLsizei height) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  Texture texture(name);
  glTextureStorage2D(texture, 1, format, width, height);
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace playhouse::render
