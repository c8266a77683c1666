// The viewer's window: GLFW and Dear ImGui's back ends around viewer::Application.
#pragma once

#include <memory>
#include <string>

#include "viewer/application.h"

struct GLFWwindow;

namespace croquis::app {

class Window {
public:
    static constexpr double least_scale = 0.5, most_scale = 4;  ///< letters beyond can be neither read nor stored
    /// Opens a window with a current context of OpenGL 3.3. `ui_scale` 0 takes what the display asks for. Throws Error
    /// where there is no display.
    Window(int width, int height, double ui_scale);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Shows the application until the window is closed. While nothing happens it sleeps.
    void run(viewer::Application& application);

    /// Ends the sleep, from any thread.
    static void wake();

    struct Size {
        int width = 0;
        int height = 0;
    };
    [[nodiscard]] Size size() const;

private:
    void listen();
    [[nodiscard]] bool is_seen() const;
    void draw_frame(viewer::Application& application);

    GLFWwindow* window_ = nullptr;
    viewer::Application* application_ = nullptr;  // while it runs, for GLFW's callbacks
    int frames_due_ = 0;
};

}  // namespace croquis::app
