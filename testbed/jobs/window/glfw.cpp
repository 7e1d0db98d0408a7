// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of glfw.h.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "testbed/jobs/window/window.h"

namespace testbed {

static_assert(key::space == GLFW_KEY_SPACE && key::escape == GLFW_KEY_ESCAPE && key::enter == GLFW_KEY_ENTER &&
              key::tab == GLFW_KEY_TAB && key::backspace == GLFW_KEY_BACKSPACE && key::insert == GLFW_KEY_INSERT &&
              key::del == GLFW_KEY_DELETE && key::right == GLFW_KEY_RIGHT && key::up == GLFW_KEY_UP &&
              key::pageUp == GLFW_KEY_PAGE_UP && key::end == GLFW_KEY_END && key::f12 == GLFW_KEY_F12 &&
              key::keypadEnter == GLFW_KEY_KP_ENTER && key::leftShift == GLFW_KEY_LEFT_SHIFT &&
              key::rightSuper == GLFW_KEY_RIGHT_SUPER && 'A' == GLFW_KEY_A && key::count > GLFW_KEY_RIGHT_SUPER);

struct Window::State {
    GLFWwindow* window = nullptr;
    std::vector<InputEvent> events;
    float scaleX = 1, scaleY = 1;  ///< framebuffer pixels per unit of the mouse's positions

    static State& Of(GLFWwindow* window) { return *static_cast<State*>(glfwGetWindowUserPointer(window)); }
    void InstallCallbacks();
};

namespace {

std::string DescribeError(const char* what) {
    const char* words = nullptr;
    glfwGetError(&words);
    return std::string(what) + (words != nullptr ? std::string(" (") + words + ")" : "");
}

}  // namespace

void Window::State::InstallCallbacks() {
    using Kind = InputEvent::Kind;
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        State& s = Of(w);
        s.events.push_back({Kind::move, static_cast<float>(x) * s.scaleX, static_cast<float>(y) * s.scaleY, 0, false});
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        if (entered == GLFW_FALSE) Of(w).events.push_back({Kind::leave, 0, 0, 0, false});
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        if (button <= GLFW_MOUSE_BUTTON_MIDDLE) {
            Of(w).events.push_back({Kind::button, 0, 0, button, action == GLFW_PRESS});
        }
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        Of(w).events.push_back({Kind::scroll, static_cast<float>(x), static_cast<float>(y), 0, false});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int code, int, int action, int) {
        if (code >= 0 && code < key::count && action != GLFW_REPEAT) {
            Of(w).events.push_back({Kind::key, 0, 0, code, action == GLFW_PRESS});
        }
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned code) {
        Of(w).events.push_back({Kind::text, 0, 0, static_cast<int>(code), false});
    });
}

Window::Window(int width, int height, const std::string& title) : m_state(std::make_unique<State>()) {
    if (glfwInit() != GLFW_TRUE) {
        throw BackendError(DescribeError("no display to open a window on") +
                           ": set DISPLAY, run under `xvfb-run -a`, or give --offscreen with --frames");
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    m_state->window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (m_state->window == nullptr) {
        const std::string problem = DescribeError("the display offers no window with OpenGL 3.3");
        glfwTerminate();
        throw BackendError(problem + ": install libgl1-mesa-dri, or give --offscreen with --frames");
    }
    glfwMakeContextCurrent(m_state->window);
    m_state->InstallCallbacks();
}

Window::~Window() {
    glfwDestroyWindow(m_state->window);
    glfwTerminate();
}

Context::Function Window::GetFunction(const char* name) const { return glfwGetProcAddress(name); }

void Window::SetVerticalSync(bool flag) { glfwSwapInterval(flag ? 1 : 0); }

int Window::GetWidth() const {
    int width = 0;
    glfwGetFramebufferSize(m_state->window, &width, nullptr);
    return std::max(width, 1);
}

int Window::GetHeight() const {
    int height = 0;
    glfwGetFramebufferSize(m_state->window, nullptr, &height);
    return std::max(height, 1);
}

std::vector<InputEvent> Window::Poll() {
    int width = 0, height = 0;
    glfwGetWindowSize(m_state->window, &width, &height);
    m_state->scaleX = width > 0 ? static_cast<float>(GetWidth()) / static_cast<float>(width) : 1;
    m_state->scaleY = height > 0 ? static_cast<float>(GetHeight()) / static_cast<float>(height) : 1;
    m_state->events.clear();
    glfwPollEvents();
    return m_state->events;
}

bool Window::WantsToClose() const { return glfwWindowShouldClose(m_state->window) != GLFW_FALSE; }

void Window::Swap() { glfwSwapBuffers(m_state->window); }

}  // namespace testbed
