// Components: the kinds of pass. Each is a class with a render function, made for one pass (seed C, 2.3.1).
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "framework/pass.h"

namespace croquis::framework {

struct RenderContext;

class Component {
public:
    virtual ~Component() = default;
    Component(const Component&) = delete;
    Component& operator=(const Component&) = delete;

    /// Called for all passes of a frame before the first of them draws. Nothing happens when `render` is off.
    void start(RenderContext& context) {
        if (render_.value()) prepare(context);
    }

    /// Draws one frame of the pass, or nothing when its `render` variable is off.
    void draw(RenderContext& context) {
        if (render_.value()) render(context);
    }

    /// Called when a variable changed: the place to make at once what depends on it, so that a mistake is told then
    /// and not in a frame. When it throws, the change is taken back.
    virtual void variable_changed(std::string_view /*name*/) {}

    /// How many lines found on the model its last frame drew; 0 for passes that find none.
    [[nodiscard]] std::size_t line_count() const { return render_.value() ? lines_drawn() : 0; }

protected:
    explicit Component(const Pass& pass) : pass_(pass), render_(pass.variable<bool>("render")) {}

    /// The place to start work on other threads that may run while earlier passes draw (seed E, 10.5); `render` waits
    /// for it, and is not called when an earlier pass throws. Nothing may be drawn here.
    virtual void prepare(RenderContext& /*context*/) {}

    virtual void render(RenderContext& context) = 0;

    [[nodiscard]] virtual std::size_t lines_drawn() const { return 0; }

    const Pass& pass_;

private:
    Variable<bool> render_;
};

/// Makes a component for a pass.
using CreateComponent = std::function<std::unique_ptr<Component>(const Pass&)>;

/// All core components by the name of their descriptor.
using ComponentTable = std::map<std::string, CreateComponent, std::less<>>;

}  // namespace croquis::framework
