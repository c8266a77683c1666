// The mouse on the drawing: dragging turns, rolls and pans what moves, the wheel zooms.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "viewer/session.h"

namespace croquis::viewer {

/// Where the mouse is and what it does, in pixels of the picture from its upper left corner.
struct MouseState {
    glm::dvec2 position{0.0};
    bool is_over_drawing = false;  ///< not over a panel
    bool turns = false;            ///< left button
    bool pans = false;             ///< middle or right button, or left with Shift
    bool rolls = false;            ///< left button with Ctrl
    double wheel = 0;              ///< notches, up is positive
    double seconds = 0;            ///< since the last frame
};

class Mouse {
public:
    /// Moves the session's arrangement as the mouse says.
    void move(const MouseState& mouse, Moves moves, FrameSize frame, Session& session);

    [[nodiscard]] bool is_dragging() const { return drag_.has_value(); }
    /// True while inertia goes on turning.
    [[nodiscard]] bool is_coasting() const { return coasting_.has_value(); }
    void set_inertia(bool on) { has_inertia_ = on; }

private:
    enum class Kind { turn, pan, roll };
    /// A drag moves what was there at its beginning: coming back to where it began undoes it.
    struct Drag {
        Kind kind;
        glm::dvec2 from;
        Arrangement arrangement;
        VirtualSphere sphere;
    };
    void begin(const MouseState& mouse, FrameSize frame, const Session& session);
    void follow(const MouseState& mouse, Moves moves, FrameSize frame, Session& session);
    void coast(double seconds, Moves moves, Session& session);

    std::optional<Drag> drag_;
    glm::dvec2 last_{0.0};
    bool has_inertia_ = false;
    struct Coasting {
        glm::dvec3 axis;
        double speed;  // radians a second
    };
    std::optional<Coasting> coasting_;
};

}  // namespace croquis::viewer
