#include "viewer/painter.h"

#include <sys/resource.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "base/error.h"

namespace croquis::viewer {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begun) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
}

// The window comes first where cores are few. On Linux this is about the thread that calls, and those that the software
// renderer begins for it.
void yield_to_the_window() {
    constexpr int later = 5;
    static_cast<void>(setpriority(PRIO_PROCESS, 0, later));  // if not, then not
}

}  // namespace

// What the thread draws with. The technique of the last full picture stays open, for most often the next one is drawn
// with it.
struct Painter::Studio {
    struct Kept {
        std::string text;
        Technique technique;
    };

    explicit Studio(const Renderer::Choice& choice) : renderer(Renderer::headless(choice)) {}

    void reload() {
        is_outdated = true;
        try {
            renderer.reload();
        } catch (const std::exception&) {  // who changed the file is told by the window's own renderer
        }
    }

    // A file that became wrong leaves the technique that was good.
    Technique& keep(const Order& order) {
        const bool is_known = kept && kept->text == order.text;
        if (is_known && !is_outdated) return kept->technique;
        try {
            Technique opened = renderer.open_technique_text(order.technique, order.text);
            kept = Kept{order.text, std::move(opened)};  // after opening: shaders that both use are not compiled again
        } catch (const Error&) {
            if (!is_known) throw;
        }
        is_outdated = false;
        return kept->technique;
    }

    // A first drawing compiles and uploads. Where that did not take long it is drawn once more, to know what one takes.
    void draw(const Order& order, Technique& technique, Delivery& delivery) {
        constexpr double long_milliseconds = 1000;
        const Renderer::Counts before = renderer.counts();
        auto begun = Clock::now();
        delivery.picture = renderer.draw(order.model, technique, order.options);
        delivery.milliseconds = milliseconds_since(begun);
        const bool is_first =
            drawn_technique != order.technique || renderer.counts().programs_linked != before.programs_linked;
        drawn_technique = order.technique;
        if (order.purpose.kind != Purpose::Kind::full_picture || !is_first) return;
        if (delivery.milliseconds > long_milliseconds) return;
        begun = Clock::now();
        delivery.picture = renderer.draw(order.model, technique, order.options);
        delivery.milliseconds = milliseconds_since(begun);
    }

    void carry_out(const Order& order, Delivery& delivery) {
        if (order.text.empty()) {
            Technique technique = renderer.open_technique(order.technique);
            delivery.help = technique.help();
            draw(order, technique, delivery);
        } else {
            draw(order, keep(order), delivery);
        }
        if (order.purpose.kind != Purpose::Kind::file) return;
        delivery.picture->save(order.purpose.name);
        delivery.picture.reset();
    }

    Renderer renderer;
    std::optional<Kept> kept;
    std::string drawn_technique;  // the last one
    bool is_outdated = false;
};

Painter::Painter(Renderer::Choice choice, std::function<void()> wake)
    : choice_(std::move(choice)), wake_(std::move(wake)), thread_([this] { work(); }) {}

Painter::~Painter() {
    {
        const std::lock_guard lock(mutex_);
        is_closed_ = true;
        orders_.clear();
    }
    changed_.notify_all();
}

void Painter::order(Order order) {
    {
        const std::lock_guard lock(mutex_);
        if (!failure_.empty() || is_closed_) return;
        is_late_ = is_late_ || is_drawing(order.purpose);
        const auto is_same = [&](const auto& other) { return other.purpose == order.purpose; };
        std::erase_if(done_, [&](const Delivery& delivery) { return is_same(delivery.order); });
        const auto older = std::find_if(orders_.begin(), orders_.end(), is_same);
        if (older != orders_.end())
            *older = std::move(order);
        else
            orders_.push_back(std::move(order));
    }
    changed_.notify_all();
}

void Painter::withdraw(const Purpose& purpose) {
    const std::lock_guard lock(mutex_);
    is_late_ = is_late_ || is_drawing(purpose);
    std::erase_if(orders_, [&](const Order& order) { return order.purpose == purpose; });
    std::erase_if(done_, [&](const Delivery& delivery) { return delivery.order.purpose == purpose; });
}

void Painter::reload() {
    const std::lock_guard lock(mutex_);
    has_new_files_ = true;
}

bool Painter::has_work() const {
    const std::lock_guard lock(mutex_);
    return drawn_ || !orders_.empty() || !done_.empty();
}

bool Painter::has_order(const Purpose& purpose) const {
    const std::lock_guard lock(mutex_);
    return (is_drawing(purpose) && !is_late_) ||
           std::any_of(orders_.begin(), orders_.end(), [&](const Order& o) { return o.purpose == purpose; }) ||
           std::any_of(done_.begin(), done_.end(), [&](const Delivery& d) { return d.order.purpose == purpose; });
}

std::optional<Painter::Delivery> Painter::take() {
    const std::lock_guard lock(mutex_);
    if (done_.empty()) return std::nullopt;
    Delivery first = std::move(done_.front());
    done_.erase(done_.begin());
    return first;
}

std::string Painter::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

bool Painter::stop(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    is_closed_ = true;
    std::erase_if(orders_, [](const Order& order) { return order.purpose.kind != Purpose::Kind::file; });
    changed_.notify_all();
    changed_.wait(lock, [&] { return orders_.empty() && (!drawn_ || drawn_->kind != Purpose::Kind::file); });
    lock.unlock();
    return thread_.ends_within(patience);
}

// Waits for something to do; nothing once the painter is closed.
std::optional<Painter::Order> Painter::next_order() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return is_closed_ || !orders_.empty(); });
    if (orders_.empty()) return std::nullopt;
    Order next = std::move(orders_.front());
    orders_.pop_front();
    drawn_ = next.purpose;
    is_late_ = false;
    return next;
}

void Painter::finish(Delivery delivery) {
    {
        const std::lock_guard lock(mutex_);
        drawn_.reset();
        if (!is_late_) done_.push_back(std::move(delivery));
    }
    changed_.notify_all();
    wake_();
}

// Nobody else draws what is for a file: that it is missing is told.
void Painter::give_up(Order order, const std::string& failure) {
    {
        const std::lock_guard lock(mutex_);
        failure_ = failure;
        drawn_.reset();
        orders_.push_front(std::move(order));
        for (Order& left : orders_) {
            if (left.purpose.kind != Purpose::Kind::file) continue;
            done_.push_back({.order = std::move(left), .picture = {}, .help = {}, .error = failure, .milliseconds = 0});
        }
        orders_.clear();
    }
    changed_.notify_all();
    wake_();
}

// What is thrown may not be ours, for want of memory for one: the session goes on.
void Painter::work() {
    yield_to_the_window();
    std::optional<Studio> studio;
    while (std::optional<Order> order = next_order()) {
        try {
            if (!studio) studio.emplace(choice_);
        } catch (const std::exception& error) {
            return give_up(std::move(*order), error.what());
        }
        bool has_new_files = false;
        {
            const std::lock_guard lock(mutex_);
            has_new_files = std::exchange(has_new_files_, false);
        }
        if (has_new_files) studio->reload();
        Delivery delivery{.order = *order, .picture = {}, .help = {}, .error = {}, .milliseconds = 0};
        try {
            studio->carry_out(*order, delivery);
        } catch (const std::exception& error) {
            delivery.picture.reset();
            delivery.error = error.what();
        }
        finish(std::move(delivery));
    }
}

}  // namespace croquis::viewer
