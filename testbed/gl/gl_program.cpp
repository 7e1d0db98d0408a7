// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of gl_program.h.

#include "testbed/gl/gl_program.h"

#include <array>
#include <string>

namespace testbed {

namespace {

GLuint CompileShader(const GladGLContext& gl, GLenum kind, const char* source) {
    const GLuint shader = gl.CreateShader(kind);
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    GLint compiled = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_TRUE) {
        std::array<char, 1024> log{};
        gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw BackendError(std::string("the OpenGL driver refuses a shader: ") + log.data());
    }
    return shader;
}

}  // namespace

void LoadGl(GladGLContext& gl, FindFunction find, void* user) {
    if (gladLoadGLContextUserPtr(&gl, find, user) == 0 || gl.VERSION_3_3 == 0) {
        throw BackendError("the OpenGL driver offers less than version 3.3");
    }
}

GLuint LinkProgram(const GladGLContext& gl, const char* vertexSource, const char* fragmentSource) {
    const GLuint vertex = CompileShader(gl, GL_VERTEX_SHADER, vertexSource);
    const GLuint fragment = CompileShader(gl, GL_FRAGMENT_SHADER, fragmentSource);
    const GLuint program = gl.CreateProgram();
    gl.AttachShader(program, vertex);
    gl.AttachShader(program, fragment);
    gl.LinkProgram(program);
    gl.DeleteShader(vertex);
    gl.DeleteShader(fragment);
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) throw BackendError("the OpenGL driver cannot link a shader program");
    return program;
}

void GlTarget::Bind(const GladGLContext& gl, GLint format, int wantedWidth, int wantedHeight) {
    if (framebuffer == 0) {
        gl.GenFramebuffers(1, &framebuffer);
        gl.GenTextures(1, &texture);
        gl.BindTexture(GL_TEXTURE_2D, texture);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (width == wantedWidth && height == wantedHeight) return;
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, format, wantedWidth, wantedHeight, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw BackendError("the OpenGL driver cannot make a framebuffer of " + std::to_string(wantedWidth) + "x" +
                           std::to_string(wantedHeight) + " pixels: ask for a smaller --image");
    }
    width = wantedWidth;
    height = wantedHeight;
}

}  // namespace testbed
