// Pictures drawn beside the window, which goes on meanwhile: on a thread of their own, by a renderer of its own.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "croquis/renderer.h"
#include "viewer/thread.h"

namespace croquis::viewer {

class Painter {
public:
    /// What a picture is for. Of several orders for the same only the newest matters.
    struct Purpose {
        enum class Kind { small_picture, full_picture, file };
        Kind kind;
        std::string name;  ///< the technique of a small picture, the path of a file
        bool operator==(const Purpose&) const = default;
    };

    struct Order {
        Purpose purpose;
        std::string technique;  ///< its name
        std::string text;       ///< of its `.technique` file; empty: it is opened by its name
        Model model;
        DrawOptions options;
        long long revision = 0;  ///< what the picture is a picture of, for who ordered it
    };

    struct Delivery {
        Order order;
        std::optional<Picture> picture;  ///< none where drawing failed, or the picture was written to its file
        std::string help;                ///< the technique's
        std::string error;               ///< why it failed
        double milliseconds = 0;         ///< a drawing takes, shaders compiled and model uploaded
    };

    /// `wake` is called, on the painter's thread, whenever something can be taken. The renderer is made with the first
    /// order.
    Painter(Renderer::Choice choice, std::function<void()> wake);
    /// Waits for the drawing that was begun.
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    /// Asks for a picture. An older order for the same purpose that was not begun gives way; the picture of one that
    /// was begun is thrown away.
    void order(Order order);
    /// Takes an order back: what was drawn for it is thrown away.
    void withdraw(const Purpose& purpose);
    /// Files changed: from the next drawing on they are as they are on disk now.
    void reload();

    [[nodiscard]] bool has_work() const;
    /// True until what was ordered for the purpose was taken.
    [[nodiscard]] bool has_order(const Purpose& purpose) const;
    [[nodiscard]] std::optional<Delivery> take();

    /// Why nothing can be drawn here; empty where it can.
    [[nodiscard]] std::string failure() const;

    /// Begins nothing more but pictures for files, which are waited for; true once nothing is being drawn, false where
    /// that would take longer than `patience`.
    [[nodiscard]] bool stop(std::chrono::milliseconds patience);

private:
    struct Studio;
    void work();
    [[nodiscard]] std::optional<Order> next_order();
    void finish(Delivery delivery);
    void give_up(Order order, const std::string& failure);
    [[nodiscard]] bool is_drawing(const Purpose& purpose) const { return drawn_ && *drawn_ == purpose; }

    const Renderer::Choice choice_;
    const std::function<void()> wake_;
    mutable std::mutex mutex_;  // of all that follows
    std::condition_variable changed_;
    std::deque<Order> orders_;
    std::optional<Purpose> drawn_;  // what is being drawn
    bool is_late_ = false;          // nobody wants that any more
    std::vector<Delivery> done_;
    bool has_new_files_ = false;
    bool is_closed_ = false;
    std::string failure_;
    Thread thread_;  // the last: it uses all of the above
};

}  // namespace croquis::viewer
