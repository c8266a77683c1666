#include "viewer/mouse.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::viewer {

void Mouse::move(const MouseState& mouse, Moves moves, FrameSize frame, Session& session) {
    const bool is_pressed = mouse.turns || mouse.pans || mouse.rolls;
    if (!drag_ && is_pressed && mouse.is_over_drawing) begin(mouse, frame, session);
    if (drag_ && is_pressed && mouse.position != last_) follow(mouse, moves, frame, session);
    if (!is_pressed) drag_.reset();
    last_ = mouse.position;
    if (mouse.is_over_drawing && mouse.wheel != 0) {
        constexpr double factor_of_notch = 1.15;
        session.arrangement().zoom(std::pow(factor_of_notch, mouse.wheel), mouse.position, frame);
    }
    if (coasting_ && !drag_) coast(mouse.seconds, moves, session);
}

void Mouse::begin(const MouseState& mouse, FrameSize frame, const Session& session) {
    const Kind kind = mouse.pans ? Kind::pan : mouse.rolls ? Kind::roll : Kind::turn;
    drag_ = Drag{kind, mouse.position, session.arrangement(), session.arrangement().sphere(frame)};
    last_ = mouse.position;
    coasting_.reset();
}

void Mouse::follow(const MouseState& mouse, Moves moves, FrameSize frame, Session& session) {
    Arrangement moved = drag_->arrangement;
    const VirtualSphere& sphere = drag_->sphere;
    switch (drag_->kind) {
        case Kind::turn: {
            moved.turn(moves, rotation_between(sphere.point_under(drag_->from), sphere.point_under(mouse.position)));
            const glm::dquat last = rotation_between(sphere.point_under(last_), sphere.point_under(mouse.position));
            const double angle = glm::angle(last);
            if (has_inertia_ && angle > 0 && mouse.seconds > 0) {
                coasting_ = Coasting{glm::axis(last), angle / mouse.seconds};
            }
            break;
        }
        case Kind::pan:
            moved.pan(moves, mouse.position - drag_->from, frame);
            break;
        case Kind::roll: {
            const glm::dvec2 from = drag_->from - sphere.centre, to = mouse.position - sphere.centre;
            moved.roll(moves, std::atan2(from.y, from.x) - std::atan2(to.y, to.x));  // y points down
            break;
        }
    }
    session.arrangement() = moved;
}

// Friction takes half of the speed every third of a second.
void Mouse::coast(double seconds, Moves moves, Session& session) {
    session.arrangement().turn(moves, glm::angleAxis(coasting_->speed * seconds, coasting_->axis));
    coasting_->speed *= std::pow(0.5, 3.0 * seconds);
    constexpr double standstill = 0.02;
    if (coasting_->speed < standstill) coasting_.reset();
}

}  // namespace croquis::viewer
