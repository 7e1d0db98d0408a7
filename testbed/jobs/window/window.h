// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A window with OpenGL 3.3 on the screen, by GLFW. The only place where GLFW starts: commands without a window never
// touch it.

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "testbed/gl/context.h"
#include "testbed/jobs/window/input_event.h"

namespace testbed {

class Window {
public:
    /// Throws BackendError without a display, or when the display offers no OpenGL 3.3. One window at a time.
    Window(int width, int height, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] Context::Function GetFunction(const char* name) const;
    /// Whether to wait for the screen's refresh when presenting.
    void SetVerticalSync(bool flag);
    /// The size of its framebuffer, pixels; mouse positions are in the same pixels.
    [[nodiscard]] int GetWidth() const;
    [[nodiscard]] int GetHeight() const;
    /// What happened since the last call, in order.
    [[nodiscard]] std::vector<InputEvent> Poll();
    [[nodiscard]] bool WantsToClose() const;
    /// Shows what was drawn.
    void Swap();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace testbed
