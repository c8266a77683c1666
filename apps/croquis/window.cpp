#include "window.h"

#include <epoxy/gl.h>
// epoxy before GLFW: both declare OpenGL.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <csignal>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "viewer/appearance.h"

namespace croquis::app {
namespace {

// After an event ImGui takes a frame or two to settle: what appears is measured in one and placed in the next.
constexpr int frames_after_event = 3;
// How long a sleeping window may not notice a changed file or a model that was read.
constexpr double seconds_asleep = 0.4;

constexpr std::array<std::pair<int, const char*>, 15> named_keys{{{GLFW_KEY_TAB, "Tab"},
                                                                  {GLFW_KEY_SPACE, "Space"},
                                                                  {GLFW_KEY_BACKSPACE, "Backspace"},
                                                                  {GLFW_KEY_HOME, "Home"},
                                                                  {GLFW_KEY_UP, "Up"},
                                                                  {GLFW_KEY_DOWN, "Down"},
                                                                  {GLFW_KEY_LEFT, "Left"},
                                                                  {GLFW_KEY_RIGHT, "Right"},
                                                                  {GLFW_KEY_KP_ADD, "+"},
                                                                  {GLFW_KEY_KP_SUBTRACT, "-"},
                                                                  {GLFW_KEY_F1, "F1"},
                                                                  {GLFW_KEY_F2, "F2"},
                                                                  {GLFW_KEY_F11, "F11"},
                                                                  {GLFW_KEY_F12, "F12"},
                                                                  {GLFW_KEY_ESCAPE, "Escape"}}};

// The key as the registry of commands names it; letters are those of the user's keyboard.
std::string name_of_key(int key, int scancode) {
    for (const auto& [code, name] : named_keys) {
        if (key == code) return name;
    }
    const char* printed = glfwGetKeyName(key, scancode);
    if (printed == nullptr) return {};
    std::string name = printed;
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    return name;
}

std::string with_modifiers(const std::string& key, int modifiers) {
    std::string name;
    if ((modifiers & GLFW_MOD_CONTROL) != 0) name += "Ctrl+";
    if ((modifiers & GLFW_MOD_SHIFT) != 0) name += "Shift+";
    if ((modifiers & GLFW_MOD_ALT) != 0) name += "Alt+";
    if ((modifiers & GLFW_MOD_SUPER) != 0) name += "Super+";
    return name + key;
}

// Whether a text that is being typed takes the key: all but Escape, and Ctrl with what is no command of a text box.
bool is_for_text(const std::string& key, int modifiers) {
    constexpr std::string_view editing = "ACVXYZ";
    if (key == "Escape") return false;
    return (modifiers & GLFW_MOD_CONTROL) == 0 || key.size() != 1 || editing.find(key) != std::string_view::npos;
}

// Ctrl+C in the terminal closes the window as its cross does: what is being recorded is ended well.
volatile std::sig_atomic_t is_asked_to_end = 0;

std::string last_glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

}  // namespace

Window::Window(int width, int height, double ui_scale) {
    if (glfwInit() == GLFW_FALSE) fail("no window: {}; croquis render needs none", last_glfw_error());
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    window_ = glfwCreateWindow(width, height, "Croquis", nullptr, nullptr);
    if (window_ == nullptr) {
        const std::string reason = last_glfw_error();
        glfwTerminate();
        fail("no window: {}; croquis render needs none", reason);
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    float scale = float(ui_scale), ignored = 1;
    if (ui_scale <= 0) glfwGetWindowContentScale(window_, &scale, &ignored);
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // what is remembered stands in the settings
    viewer::set_appearance(std::clamp(scale, float(least_scale), float(most_scale)));
    listen();
    ImGui_ImplGlfw_InitForOpenGL(window_, true);  // calls on what listens already
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

// Every event asks for frames; keys and dropped files go to the application.
void Window::listen() {
    glfwSetWindowUserPointer(window_, this);
    static const auto of = [](GLFWwindow* window) -> Window& {
        Window& self = *static_cast<Window*>(glfwGetWindowUserPointer(window));
        self.frames_due_ = frames_after_event;
        return self;
    };
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double, double) { of(window); });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int, int, int) { of(window); });
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double) { of(window); });
    glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned) {
        if (ImGui::GetIO().WantTextInput) of(window);
    });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int) { of(window); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int) { of(window); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { of(window); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { of(window); });
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
        // A key that is only still held changes nothing, but for a text that is being typed.
        if (action == GLFW_REPEAT && !ImGui::GetIO().WantTextInput) return;
        Window& self = of(window);
        const std::string name = name_of_key(key, scancode);
        if (self.application_ == nullptr || name.empty()) return;
        if (action == GLFW_RELEASE)
            self.application_->release(name);
        else if (action == GLFW_PRESS && !(ImGui::GetIO().WantTextInput && is_for_text(name, modifiers)))
            self.application_->press(with_modifiers(name, modifiers));
    });
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
        Window& self = of(window);
        if (self.application_ != nullptr) self.application_->open(std::vector<std::string>(paths, paths + count));
    });
}

void Window::wake() { glfwPostEmptyEvent(); }

Window::Size Window::size() const {
    Size size;
    glfwGetWindowSize(window_, &size.width, &size.height);
    return size;
}

// Minimised, or made as small as nothing, it has no frame to draw, and what wants one waits.
bool Window::is_seen() const {
    Size pixels;
    glfwGetFramebufferSize(window_, &pixels.width, &pixels.height);
    return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_FALSE && pixels.width > 0 && pixels.height > 0 &&
           size().width > 0;
}

void Window::draw_frame(viewer::Application& application) {
    Size pixels;
    glfwGetFramebufferSize(window_, &pixels.width, &pixels.height);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    application.frame({pixels.width, pixels.height});
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);  // the application drew to its own
    glViewport(0, 0, pixels.width, pixels.height);
    const ImVec4 color = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
    glClearColor(color.x, color.y, color.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
}

void Window::run(viewer::Application& application) {
    application_ = &application;
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { is_asked_to_end = 1; });
    frames_due_ = frames_after_event;
    bool has_frames = true;
    while (glfwWindowShouldClose(window_) == GLFW_FALSE && !application.wants_to_close() && is_asked_to_end == 0) {
        if (frames_due_ > 0 && has_frames)
            glfwPollEvents();
        else
            glfwWaitEventsTimeout(seconds_asleep);
        has_frames = is_seen();
        if (application.poll()) frames_due_ = frames_after_event;
        if (application.wants_frames()) frames_due_ = std::max(frames_due_, 1);
        if (frames_due_ == 0 || !has_frames) continue;
        --frames_due_;
        draw_frame(application);
    }
    application_ = nullptr;
    glfwHideWindow(window_);  // what is still being written needs it no more
}

}  // namespace croquis::app
